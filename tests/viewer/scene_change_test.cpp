// What a change of the scene takes, and that the viewer does it.
#include "viewer/scene_change.h"

#include <gtest/gtest.h>

#include "tyg/methods.h"
#include "viewer/viewer.h"

namespace tyg {
namespace {

Scene curtain() { return loadScene("curtain", methodNames()); }

TEST(SceneChange, MethodAndStepAreTakenLive) {
  Scene other = curtain();
  EXPECT_EQ(changeBetween(curtain(), other), SceneChange::None);
  other.integrator = "leapfrog";
  other.dt *= 0.5;
  EXPECT_EQ(changeBetween(curtain(), other), SceneChange::Live);
}

TEST(SceneChange, SpringsGravityDragAndToleranceAreTakenLive) {
  Scene other = curtain();
  other.structural.ks *= 2, other.bend.kd = 1, other.gravity.x = 1, other.drag = 0.1, other.tolerance = 1e-6;
  EXPECT_EQ(changeBetween(curtain(), other), SceneChange::Live);
  other.damping = Damping::Axial;
  EXPECT_EQ(changeBetween(curtain(), other), SceneChange::Restart);
}

TEST(SceneChange, PrecisionRestartsAndAnotherGridIsANewSheet) {
  Scene other = curtain();
  other.precision = Precision::Float;
  EXPECT_EQ(changeBetween(curtain(), other), SceneChange::Restart);
  EXPECT_EQ(changeBetween(curtain(), withSheet(curtain(), 10, 12)), SceneChange::NewSheet);
}

class SceneUse : public testing::Test {
 protected:
  void run(int frames) {
    for (int k = 0; k < frames; ++k) now_ += 1.0 / 60, viewer_.frame();
  }
  double now_ = 1;
  Viewer viewer_{curtain(), Settings{.threads = 1}, [this] { return now_; }};
};

TEST_F(SceneUse, AStepGoesOnWhereTheClothIs) {
  viewer_.perform(InputAction::StartOrPause);
  run(10);
  const double time = viewer_.time();
  Scene half = viewer_.scene();
  half.dt *= 0.5;
  EXPECT_EQ(viewer_.use(half), SceneChange::Live);
  EXPECT_EQ(viewer_.simulation().dt(), half.dt);
  EXPECT_EQ(viewer_.time(), time);
  EXPECT_EQ(viewer_.use(half), SceneChange::None);
}

TEST_F(SceneUse, OtherGravityActsOnTheMovingClothAndGoesBackWithIt) {
  viewer_.perform(InputAction::StartOrPause);
  run(20);
  const double time = viewer_.time();
  Scene up = viewer_.scene();
  up.gravity = {0, 9.81, 0};
  EXPECT_EQ(viewer_.use(up), SceneChange::Live);
  EXPECT_EQ(viewer_.time(), time);
  EXPECT_EQ(viewer_.simulation().scene().gravity, up.gravity);
  run(20);
  viewer_.turnToTime(time / 2);
  run(3);
  EXPECT_EQ(viewer_.scene().gravity, curtain().gravity);
  EXPECT_EQ(viewer_.simulation().scene().gravity, curtain().gravity);
  viewer_.perform(InputAction::Restart);
  EXPECT_EQ(viewer_.simulation().scene().gravity, curtain().gravity);
}

TEST_F(SceneUse, AnotherSceneRunsOnFromItsStart) {
  viewer_.perform(InputAction::StartOrPause);
  run(10);
  EXPECT_EQ(viewer_.use(loadScene("flag", methodNames())), SceneChange::NewSheet);
  EXPECT_EQ(viewer_.time(), 0);
  EXPECT_EQ(viewer_.state(), RunState::Running);
  EXPECT_EQ(viewer_.sheetsSoFar(), 2);
  EXPECT_EQ(viewer_.positions().size(), std::size_t(3 * viewer_.simulation().sheet().count()));
  run(10);
  EXPECT_GT(viewer_.time(), 0);
}

TEST_F(SceneUse, ASceneThatDoesNotFitTogetherChangesNothing) {
  Scene broken = viewer_.scene();
  broken.pins = {Place{.name = "", .column = 99, .row = 0}};
  EXPECT_EQ(viewer_.use(broken), SceneChange::None);
  EXPECT_EQ(viewer_.scene(), curtain());
  EXPECT_FALSE(viewer_.note().empty());
}

}  // namespace
}  // namespace tyg
