// Dragging a body with the left button, without a window, and taking it back.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/forces/terms/contact.h"
#include "viewer/edits.h"
#include "viewer/viewer_fixture.h"

namespace tyg {
namespace {

class BodyDragTest : public ViewerTest {
 protected:
  BodyDragTest() : ViewerTest(scene()) {}
  /// A sheet that hangs beside a ball.
  static Scene scene() {
    Scene scene = curtain();
    scene.bodies = {{.shape = Shape::Ball, .at = {-1.6, 0.2, 0}, .radius = 0.2}};
    scene.contact.layer = 0.02;
    fillContact(scene);
    scene.dt = 1e-3;
    return scene;
  }
  [[nodiscard]] glm::dvec3 ballAt() const {
    const Vec3& at = viewer_.run().simulation().scene().bodies[0].at;
    return {at.x, at.y, at.z};
  }
  [[nodiscard]] glm::dvec2 ballSeen() const {
    return placeInWindow(viewer_.view().camera(), glm::vec3(ballAt()), {1280, 720});
  }

  Edits edits_{viewer_};
};

TEST_F(BodyDragTest, ADragTakesABodyAlongAndReplaysToTheSameBits) {
  tap(' '), frames(120);  // the view glides at first
  const glm::dvec3 before = ballAt();
  const glm::dvec2 wanted = ballSeen() + glm::dvec2(150, 60);
  pressAt(ballSeen()), moveTo(wanted);
  frames(40);
  EXPECT_LT(glm::distance(ballSeen(), wanted), 10) << "its surface is held, not its middle";
  EXPECT_NEAR(glm::dot(ballAt() - before, glm::dvec3(viewer_.view().camera().forward())), 0, 1e-3);
  EXPECT_EQ(viewer_.logLine().held, -1) << "the cloth was not grabbed";
  release(kLeftButton);
  EXPECT_EQ(viewer_.scenes().scene().bodies[0].at, viewer_.run().simulation().scene().bodies[0].at);
  const EventLog log = viewer_.run().record();
  EXPECT_GT(
      std::ranges::count_if(log.events, [](const Event& e) { return std::holds_alternative<WorldEvent>(e.action); }), 3)
      << "it goes in small jumps";
  Simulation again(scene(), findMethod(log.integrator), {.threads = 1});
  again.replay(parseEventLog(formatEventLog(log), "log"), methods());
  again.tick(log.ticks);
  EXPECT_EQ(hashText(again), log.hash);
}

TEST_F(BodyDragTest, AJumpWhileTimePassesIsAtMostHalfTheLayer) {
  Scene coarse = viewer_.scenes().scene();
  coarse.dt = 4e-3;
  viewer_.scenes().use(coarse);
  tap(' '), frames(5);
  pressAt(ballSeen()), moveTo(ballSeen() + glm::dvec2(200, 0));
  frames(5);
  const double layer = viewer_.run().simulation().scene().contact.layer;
  Vec3 last = scene().bodies[0].at;
  int jumps = 0;
  for (const Event& event : viewer_.run().record().events) {
    const auto* world = std::get_if<WorldEvent>(&event.action);
    if (world == nullptr) continue;
    const Vec3& at = world->value;
    EXPECT_LE(std::hypot(at.x - last.x, at.y - last.y, at.z - last.z), 0.51 * layer);
    last = at, ++jumps;
  }
  EXPECT_GT(jumps, 5);
}

TEST_F(BodyDragTest, TheWholeDragIsOneChangeToUndo) {
  tap(' '), frames(5);
  edits_.follow(viewer_);
  const glm::dvec3 before = ballAt();
  pressAt(ballSeen()), moveTo(ballSeen() + glm::dvec2(50, 0));
  for (int k = 0; k < 20; ++k) frames(1), edits_.follow(viewer_);
  release(kLeftButton), frames(1), edits_.follow(viewer_);
  EXPECT_GT(glm::distance(ballAt(), before), 0.02);
  edits_.undo(viewer_);
  EXPECT_EQ(ballAt(), before);
  edits_.redo(viewer_);
  EXPECT_GT(glm::distance(ballAt(), before), 0.02);
}

TEST_F(BodyDragTest, ABodyOfAPausedClothIsAtOnceWhereTheCursorIs) {
  tap(' '), frames(5), tap(' ');
  const std::int64_t still = ticks();
  const glm::dvec2 wanted = ballSeen() + glm::dvec2(-80, 30);
  pressAt(ballSeen()), moveTo(wanted), frames(1);
  EXPECT_LT(glm::distance(ballSeen(), wanted), 5);
  EXPECT_EQ(ticks(), still);
}

TEST_F(BodyDragTest, AClickOnABodySaysWhatADragDoes) {
  tap(' '), frames(5);
  const std::size_t events = viewer_.run().record().events.size();
  pressAt(ballSeen()), release(kLeftButton), frames(5);
  EXPECT_EQ(viewer_.notes().text(), "A drag moves this body.");
  EXPECT_EQ(viewer_.run().record().events.size(), events);
}

TEST_F(BodyDragTest, TheClothBeforeABodyIsGrabbedAndNotTheBody) {
  tap(' '), frames(5);
  Scene behind = scene();
  behind.bodies[0].at = {0, -0.5, -0.6};
  viewer_.scenes().use(behind);
  frames(1);
  const glm::dvec3 before = ballAt();
  pressAt(placeOf(210)), moveTo(placeOf(210) + glm::dvec2(60, 0));
  frames(5);
  EXPECT_EQ(viewer_.logLine().held, 210);
  EXPECT_EQ(ballAt(), before);
}

/// Without gravity nothing moves but by the hand.
class StillBodyDragTest : public BodyDragTest {
 protected:
  StillBodyDragTest() {
    Scene still = scene();
    still.gravity = {};
    viewer_.scenes().use(still);
  }
};

TEST_F(StillBodyDragTest, AHeldBodyFollowsTheCursorHoweverLongItWasStill) {
  tap(' '), frames(60);
  pressAt(ballSeen()), moveTo(ballSeen() + glm::dvec2(-40, 0));
  frames(600);
  const glm::dvec3 before = ballAt();
  moveTo(ballSeen() + glm::dvec2(-40, 0)), frames(60);
  EXPECT_GT(glm::distance(ballAt(), before), 0.02);
  release(kLeftButton), frames(600);
  EXPECT_TRUE(viewer_.run().asleep()) << "as it is without a hand";
}

TEST_F(StillBodyDragTest, ABodyComesToRestWhereTheCursorIsWhateverTheStep) {
  for (const double dt : {1e-2, 1e-3, 5e-5}) {
    Scene scene = viewer_.scenes().scene();
    scene.dt = dt;
    viewer_.scenes().use(scene);
    if (viewer_.run().state() != RunState::Running) tap(' ');
    frames(60);
    pressAt(ballSeen()), moveTo(ballSeen() + glm::dvec2(-30, 10));
    frames(90);
    const glm::dvec3 there = ballAt();
    frames(30);
    EXPECT_LT(glm::distance(ballAt(), there), 1e-3) << dt;
    release(kLeftButton);
  }
}

TEST_F(BodyDragTest, ABodyThatMovesByItselfStaysWhereTheCursorHoldsIt) {
  Scene moving = scene();
  moving.bodies[0].name = "ball";
  moving.moves = {{.velocity = {0.3, 0.1, 0}, .duration = 10, .body = "ball"}};
  viewer_.scenes().use(moving);
  tap(' '), frames(60);
  const auto ballNow = [&] {
    const Simulation& simulation = viewer_.run().simulation();
    const Vec3 at = tyg::placeOf(simulation.scene(), 0, simulation.time());
    return glm::vec3(at.x, at.y, at.z);
  };
  const glm::dvec2 seen = placeInWindow(viewer_.view().camera(), ballNow(), {1280, 720});
  pressAt(seen), moveTo(seen + glm::dvec2(30, 0)), frames(60);
  const glm::vec3 held = ballNow();
  frames(120);
  EXPECT_LT(glm::distance(ballNow(), held), 0.02) << "by itself it would have gone 0.6 m";
  release(kLeftButton), frames(60);
  EXPECT_GT(glm::distance(ballNow(), held), 0.2);
}

TEST_F(BodyDragTest, BeyondTheSixthBodyADragSaysThatItMovesNone) {
  Scene many = scene();
  const Body ball = many.bodies[0];
  for (int k = 0; k < 6; ++k) many.bodies.insert(many.bodies.begin(), {.shape = Shape::Plane, .at = {0, -50.0 - k, 0}});
  viewer_.scenes().use(many);
  frames(1);
  const glm::dvec2 seen =
      placeInWindow(viewer_.view().camera(), {float(ball.at.x), float(ball.at.y), float(ball.at.z)}, {1280, 720});
  pressAt(seen), moveTo(seen + glm::dvec2(50, 0)), frames(2);
  EXPECT_EQ(viewer_.notes().text(), "Of the bodies of a scene only the first six can be moved.");
  EXPECT_EQ(viewer_.run().state(), RunState::Waiting) << "nothing was done to the cloth";
  release(kLeftButton);
}

}  // namespace
}  // namespace tyg
