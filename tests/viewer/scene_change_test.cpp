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

TEST(SceneChange, AirAndTheFirstWindAreTakenLiveAndAnotherWindRestarts) {
  Scene other = curtain();
  other.air = {1.2, 1.3};
  other.winds = {{.velocity = {3, 0, 1}, .gust = {0, 0, 1}, .wavelength = 2}};
  EXPECT_EQ(changeBetween(curtain(), other), SceneChange::Live);
  EXPECT_EQ(changeBetween(other, curtain()), SceneChange::Live);
  Scene second = other;
  second.winds.push_back({.velocity = {1, 0, 0}});
  EXPECT_EQ(changeBetween(other, second), SceneChange::Restart);
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
  const double time = viewer_.run().shown().time();
  Scene half = viewer_.scenes().scene();
  half.dt *= 0.5;
  EXPECT_EQ(viewer_.scenes().use(half), SceneChange::Live);
  EXPECT_EQ(viewer_.run().simulation().dt(), half.dt);
  EXPECT_EQ(viewer_.run().shown().time(), time);
  EXPECT_EQ(viewer_.scenes().use(half), SceneChange::None);
}

TEST_F(SceneUse, OtherGravityActsOnTheMovingClothAndGoesBackWithIt) {
  viewer_.perform(InputAction::StartOrPause);
  run(20);
  const double time = viewer_.run().shown().time();
  Scene up = viewer_.scenes().scene();
  up.gravity = {0, 9.81, 0};
  EXPECT_EQ(viewer_.scenes().use(up), SceneChange::Live);
  EXPECT_EQ(viewer_.run().shown().time(), time);
  EXPECT_EQ(viewer_.run().simulation().scene().gravity, up.gravity);
  run(20);
  viewer_.run().turnToTime(time / 2);
  run(3);
  EXPECT_EQ(viewer_.scenes().scene().gravity, curtain().gravity);
  EXPECT_EQ(viewer_.run().simulation().scene().gravity, curtain().gravity);
  viewer_.perform(InputAction::Restart);
  EXPECT_EQ(viewer_.run().simulation().scene().gravity, curtain().gravity);
}

TEST_F(SceneUse, AWindBlowsAtTheMovingClothAndGoesBackWithIt) {
  viewer_.perform(InputAction::StartOrPause);
  run(20);
  const double time = viewer_.run().shown().time();
  Scene windy = viewer_.scenes().scene();
  windy.air.density = 1.2;
  windy.winds = {{.velocity = {0, 0, 5}, .gust = {2, 0, 0}, .wavelength = 1}};
  EXPECT_EQ(viewer_.scenes().use(windy), SceneChange::Live);
  EXPECT_EQ(viewer_.run().shown().time(), time);
  EXPECT_EQ(viewer_.run().simulation().scene().winds, windy.winds);
  run(20);
  viewer_.run().turnToTime(time / 2);
  run(3);
  EXPECT_EQ(viewer_.scenes().scene(), curtain());
  EXPECT_EQ(viewer_.run().simulation().scene(), curtain());
}

TEST_F(SceneUse, AnotherSceneRunsOnFromItsStart) {
  viewer_.perform(InputAction::StartOrPause);
  run(10);
  EXPECT_EQ(viewer_.scenes().use(loadScene("flag", methodNames())), SceneChange::NewSheet);
  EXPECT_EQ(viewer_.run().shown().time(), 0);
  EXPECT_EQ(viewer_.run().state(), RunState::Running);
  EXPECT_EQ(viewer_.scenes().sheetsSoFar(), 2);
  EXPECT_EQ(viewer_.run().shown().positions().size(), std::size_t(3 * viewer_.run().simulation().sheet().count()));
  run(10);
  EXPECT_GT(viewer_.run().shown().time(), 0);
}

TEST_F(SceneUse, ASceneThatDoesNotFitTogetherChangesNothing) {
  Scene broken = viewer_.scenes().scene();
  broken.pins = {Place{.name = "", .column = 99, .row = 0}};
  EXPECT_EQ(viewer_.scenes().use(broken), SceneChange::None);
  EXPECT_EQ(viewer_.scenes().scene(), curtain());
  EXPECT_FALSE(viewer_.notes().text().empty());
}

}  // namespace
}  // namespace tyg
