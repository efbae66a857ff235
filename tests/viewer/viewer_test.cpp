// The viewer without a window: what inputs and frame times do to the cloth, the camera and the states.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "viewer/viewer_fixture.h"

namespace tyg {
namespace {

TEST_F(ViewerTest, OpensWaitingAtTimeZero) {
  frames(30);
  EXPECT_EQ(viewer_.run().state(), RunState::Waiting);
  EXPECT_EQ(viewer_.run().shown().time(), 0);
  EXPECT_TRUE(viewer_.idle());
  EXPECT_TRUE(viewer_.view().showsHelp());
}

TEST_F(ViewerTest, SpaceStartsAndPausesAndGoesOn) {
  tap(' ');
  frames(6);
  EXPECT_EQ(viewer_.run().state(), RunState::Running);
  const double then = viewer_.run().shown().time();
  EXPECT_GT(then, 0);
  tap(' ');
  frames(6);
  EXPECT_EQ(viewer_.run().state(), RunState::Paused);
  EXPECT_EQ(viewer_.run().shown().time(), then);
  tap(' ');
  frames(6);
  EXPECT_GT(viewer_.run().shown().time(), then);
}

TEST_F(ViewerTest, TheTimeSpentWaitingIsNotMadeUp) {
  now_ += 3600;
  tap(' ');
  frames(1, 0.010);
  EXPECT_LE(viewer_.run().shown().time(), 0.010 + 1e-9);
}

TEST_F(ViewerTest, FullStopMakesOneStepAndPauses) {
  tap('.');
  EXPECT_EQ(ticks(), 1);
  EXPECT_EQ(viewer_.run().shown().time(), viewer_.run().simulation().dt());
  frames(3);
  EXPECT_EQ(ticks(), 1);
  EXPECT_EQ(viewer_.run().state(), RunState::Paused);
}

class FrameRate : public ViewerTest, public testing::WithParamInterface<double> {};
TEST_P(FrameRate, GivesTheStateOfPlainTicks) {
  tap(' ');
  while (ticks() < 300) frames(1, 1 / GetParam());
  Simulation plain(curtain(), findMethod("rk4"), {.threads = 1});
  while (plain.ticks() < ticks()) plain.tick();
  EXPECT_EQ(viewer_.run().simulation().hash(), plain.hash());
}
INSTANTIATE_TEST_SUITE_P(Usual, FrameRate, testing::Values(30.0, 60.0, 144.0));

TEST_F(ViewerTest, RestartGoesBackToZeroAndKeepsTheCamera) {
  tap(' ');
  press('W');
  frames(20);
  release('W');
  const glm::vec3 eye = viewer_.view().camera().eye();
  tap('R');
  frames(3);
  EXPECT_EQ(viewer_.run().state(), RunState::Waiting);
  EXPECT_EQ(viewer_.run().shown().time(), 0);
  EXPECT_EQ(viewer_.view().camera().eye(), eye);
}

TEST_F(ViewerTest, NumberKeysChangeTheMethodOfTheRunningCloth) {
  tap(' ');
  frames(3);
  for (std::size_t place = 0; place < 5; ++place) {
    tap(static_cast<KeyCode>('1' + place));
    EXPECT_EQ(&viewer_.run().simulation().method(), &methods()[place]);
  }
  EXPECT_EQ(viewer_.run().state(), RunState::Running);
}

TEST_F(ViewerTest, ANumberWithoutAMethodChangesNothing) {
  const Method* before = &viewer_.scenes().method();
  tap('0');
  EXPECT_EQ(methods().size() > 9, before != &viewer_.scenes().method());
}

TEST_F(ViewerTest, RestartKeepsTheChosenMethod) {
  tap('4');
  tap('R');
  EXPECT_EQ(viewer_.run().simulation().method().name, "leapfrog");
}

TEST_F(ViewerTest, EveryMovingKeyMovesTheEyeItsWay) {
  const struct {
    KeyCode key;
    glm::vec3 way;
  } kWays[] = {{'W', viewer_.view().camera().forward()},
               {'S', -viewer_.view().camera().forward()},
               {'D', viewer_.view().camera().right()},
               {'A', -viewer_.view().camera().right()},
               {'E', {0, 1, 0}},
               {'Q', {0, -1, 0}}};
  for (const auto& [key, way] : kWays) {
    const glm::vec3 before = viewer_.view().camera().eye();
    press(key);
    frames(6);
    release(key);
    EXPECT_GT(glm::dot(viewer_.view().camera().eye() - before, way), 0) << key;
  }
}

TEST_F(ViewerTest, LosingTheFocusReleasesHeldKeys) {
  press('W');
  press(kRightButton, 600, 300);
  viewer_.handle({.kind = Kind::FocusLost});
  EXPECT_TRUE(viewer_.idle());
  const glm::vec3 eye = viewer_.view().camera().eye();
  frames(6);
  EXPECT_EQ(viewer_.view().camera().eye(), eye);
}

TEST_F(ViewerTest, TheMouseLooksAroundOnlyWithTheRightButtonHeld) {
  const float yaw = viewer_.view().camera().yaw();
  viewer_.handle({.kind = Kind::Move, .x = 700, .y = 300});
  EXPECT_EQ(viewer_.view().camera().yaw(), yaw);
  press(kRightButton, 700, 300);
  viewer_.handle({.kind = Kind::Move, .x = 760, .y = 300});
  EXPECT_GT(viewer_.view().camera().yaw(), yaw);
}

TEST_F(ViewerTest, TheWheelGoesNearer) {
  const float before = viewer_.view().camera().distance();
  viewer_.handle({.kind = Kind::Scroll, .key = kWheel, .notches = 1});
  EXPECT_LT(viewer_.view().camera().distance(), before);
}

TEST_F(ViewerTest, AClickPushesTheParticleUnderTheCursorAwayFromTheEye) {
  clickOnCloth();
  release(kLeftButton);
  ASSERT_TRUE(viewer_.tools().drawing().arrow);
  EXPECT_EQ(viewer_.tools().drawing().arrow->particle, 210);
  const Vec3 force = viewer_.tools().drawing().arrow->force;
  EXPECT_GT(glm::dot(glm::vec3(force.x, force.y, force.z), viewer_.view().camera().forward()), 0);
  EXPECT_EQ(viewer_.logLine().pushes, 1);
  EXPECT_EQ(viewer_.logLine().picked, 210);
}

TEST_F(ViewerTest, AClickThatMissesPushesTheMiddleParticleAlongZ) {
  press(kLeftButton, 5, 700);
  ASSERT_TRUE(viewer_.tools().drawing().arrow);
  EXPECT_EQ(viewer_.tools().drawing().arrow->particle, 210);
  EXPECT_EQ(viewer_.tools().drawing().arrow->force.x, 0);
  EXPECT_EQ(viewer_.tools().drawing().arrow->force.y, 0);
  EXPECT_GT(viewer_.tools().drawing().arrow->force.z, 0);
}

TEST_F(ViewerTest, AClickPushesForATenthOfASecondInWholeTicks) {
  clickOnCloth();
  release(kLeftButton);
  const EventLog log = viewer_.run().record();
  ASSERT_EQ(log.events.size(), 1U);
  EXPECT_EQ(std::get<PushEvent>(log.events[0].action).ticks, 50);  // 0.1 s of 2 ms
}

TEST_F(ViewerTest, HoldingTheButtonGoesOnWithoutDoublingTheForce) {
  clickOnCloth();
  tap(' ');
  frames(30);
  release(kLeftButton);
  const EventLog log = viewer_.run().record();
  ASSERT_GT(log.events.size(), 5U);
  const auto push = [&log](std::size_t index) { return std::get<PushEvent>(log.events[index].action); };
  for (std::size_t next = 1; next < log.events.size(); ++next) {
    EXPECT_EQ(log.events[next].tick, log.events[next - 1].tick + push(next - 1).ticks);
    EXPECT_EQ(push(next).force, push(0).force);
  }
  EXPECT_EQ(viewer_.logLine().pushes, 1);
}

TEST_F(ViewerTest, ARecordReplaysToTheSameHash) {
  tap(' ');
  frames(20);
  clickOnCloth();
  frames(9);
  release(kLeftButton);
  tap('4');
  frames(20);
  const EventLog log = viewer_.run().record();
  Simulation again(curtain(), findMethod(log.integrator), {.threads = 1});
  again.replay(parseEventLog(formatEventLog(log), "record"), methods());
  while (again.ticks() < log.ticks) again.tick();
  EXPECT_EQ(again.hash(), viewer_.run().simulation().hash());
}

TEST_F(ViewerTest, ARecordOfAnEditedSceneCarriesItAsItWasEdited) {
  Scene edited = curtain();
  edited.precision = Precision::Float;
  viewer_.scenes().use(edited);
  tap('4');
  edited = viewer_.scenes().scene();
  edited.structural.kd = 0.4;
  viewer_.scenes().use(edited);
  tap(' ');
  frames(20);
  edited.gravity = {0, -1.62, 0};
  viewer_.scenes().use(edited);
  frames(20);
  const EventLog log = parseEventLog(formatEventLog(viewer_.run().record()), "record");
  const Scene scene = parseScene(log.sceneText, "record", methodNames());
  Simulation again(scene, findMethod(log.integrator), {.threads = 1});
  again.replay(log, methods());
  again.tick(log.ticks);
  EXPECT_EQ(again.hash(), viewer_.run().simulation().hash());
  EXPECT_NE(scene, curtain());
}

TEST_F(ViewerTest, ARestartHandsOutTheRecordOfTheRunThatEnded) {
  std::vector<EventLog> kept;
  viewer_.run().onRunEnd([&kept](const EventLog& log) { kept.push_back(log); });
  tap('R');
  EXPECT_TRUE(kept.empty());  // nothing had run
  tap('.');
  const EventLog expected = viewer_.run().record();
  tap('R');
  ASSERT_EQ(kept.size(), 1U);
  EXPECT_EQ(kept[0], expected);
}

TEST_F(ViewerTest, FBringsALostClothBack) {
  press(kRightButton, 0, 300);
  const auto lost = [this] {
    return edgeArrow(viewer_.view().camera(), viewer_.run().shown().box(), {1280, 720}, 20).has_value();
  };
  for (int x = 50; x < 2000 && !lost(); x += 50) viewer_.handle({.kind = Kind::Move, .x = double(x), .y = 300});
  ASSERT_TRUE(lost());
  tap('F');
  EXPECT_FALSE(lost());
}

/// Where the middle of the cloth's box is seen, from -1 at the left edge to 1.
float middleOf(const Viewer& viewer) {
  const Camera& camera = viewer.view().camera();
  const glm::vec4 clip =
      camera.projection(1280.0F / 720) * camera.view() * glm::vec4(viewer.run().shown().box().centre(), 1);
  return clip.x / clip.w;
}
constexpr Insets kPanelOnTheRight{.left = 200, .right = 600};
constexpr float kMiddleOfTheRest = -400.0F / 1280;  // 200 pixels to the left
constexpr float kSeenMiddle = 0.1F;                 // the middle of the box is not that of its picture

TEST_F(ViewerTest, APanelMovesTheClothIntoWhatIsFree) {
  const float distance = viewer_.view().camera().distance();
  viewer_.resize({.width = 1280, .height = 720}, kPanelOnTheRight);
  EXPECT_NEAR(middleOf(viewer_), kMiddleOfTheRest, kSeenMiddle);
  EXPECT_GT(viewer_.view().camera().distance(), 1.1F * distance) << "half the room, and no farther away";
  viewer_.resize({.width = 1280, .height = 720}, {.left = 200, .right = 200});
  EXPECT_NEAR(middleOf(viewer_), 0, kSeenMiddle);
  EXPECT_NEAR(viewer_.view().camera().distance(), distance, 1e-4F * distance);
}

TEST_F(ViewerTest, APanelSlidesAClothThatThePersonHasLookedAtCloser) {
  viewer_.handle({.kind = Kind::Scroll, .notches = 2});
  const glm::vec3 eye = viewer_.view().camera().eye();
  const float before = middleOf(viewer_);
  viewer_.resize({.width = 1280, .height = 720}, kPanelOnTheRight);
  EXPECT_NEAR(middleOf(viewer_), before + kMiddleOfTheRest, kSeenMiddle);
  viewer_.resize({}, kPanelOnTheRight);
  viewer_.resize({.width = 1280, .height = 720}, {.left = 200, .right = 200});
  EXPECT_LT(glm::distance(viewer_.view().camera().eye(), eye), 0.05F * viewer_.view().camera().distance());
}

TEST_F(ViewerTest, AMinimisedWindowChangesNothing) {
  const glm::vec3 eye = viewer_.view().camera().eye();
  viewer_.resize({}, {});
  press(kLeftButton, 10, 10);
  tap('F');
  frames(3);
  EXPECT_EQ(viewer_.view().camera().eye(), eye);
  EXPECT_EQ(viewer_.logLine().pushes, 0);
}

TEST_F(ViewerTest, TogglesSwitchWhatIsDrawn) {
  tap('X'), tap('N'), tap('P'), tap('I'), tap('L'), tap('U'), tap('B'), tap('H');
  const DrawOptions& draw = viewer_.view().drawOptions();
  EXPECT_TRUE(draw.shear && draw.bend && draw.particles);
  EXPECT_FALSE(draw.pins || draw.structural || draw.ground || viewer_.view().showsHelp());
  EXPECT_EQ(draw.background, Background::Light);
}

TEST_F(ViewerTest, EscapeLeaves) {
  EXPECT_FALSE(viewer_.leaving());
  tap(kEscapeKey);
  EXPECT_TRUE(viewer_.leaving());
}

TEST_F(ViewerTest, WhatIsThrownIsShownAndFreezes) {
  viewer_.run().freeze("the driver gave up");
  tap(' ');
  EXPECT_EQ(viewer_.run().state(), RunState::Frozen);
  EXPECT_EQ(viewer_.run().failure().message, "the driver gave up");
  tap('R');
  EXPECT_EQ(viewer_.run().state(), RunState::Waiting);
}

TEST(ViewerOnASlowMachine, StaysResponsiveAndSaysSo) {
  // Each look at the clock takes a second: no more than one tick fits into a frame.
  double now = 0;
  Viewer viewer(loadScene("curtain", methodNames()), Settings{.threads = 1}, [&now] { return now += 1; });
  viewer.resize({.width = 1280, .height = 720}, {});
  viewer.handle({.kind = Kind::Press, .key = ' '});
  for (int frame = 0; frame < 10; ++frame) viewer.frame();
  EXPECT_EQ(viewer.run().simulation().ticks(), 10);
}

}  // namespace
TEST_F(ViewerTest, TheViewTakesInASecondClothBesideTheFirst) {
  constexpr float kAway = 2;  // m
  viewer_.resize({.width = 1280, .height = 720}, {.left = 200, .right = 200, .beside = kAway});
  const Camera& camera = viewer_.view().camera();
  for (const glm::vec3 corner : viewer_.run().shown().box().corners()) {
    for (const glm::vec3 point : {corner, corner - kAway * camera.right()}) {
      const glm::vec4 clip = camera.projection(1280.0F / 720) * camera.view() * glm::vec4(point, 1);
      const float x = 640 * (1 + clip.x / clip.w);
      EXPECT_GT(x, 200);
      EXPECT_LT(x, 1080);
    }
  }
}

}  // namespace tyg
