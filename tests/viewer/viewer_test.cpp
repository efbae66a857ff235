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

TEST_F(ViewerTest, LosingTheFocusReleasesHeldKeys) {
  press('W');
  press(kRightButton, 600, 300);
  viewer_.handle({.kind = Kind::FocusLost});
  EXPECT_TRUE(viewer_.idle());
  const glm::vec3 eye = viewer_.view().camera().eye();
  frames(6);
  EXPECT_EQ(viewer_.view().camera().eye(), eye);
}

TEST_F(ViewerTest, ARecordReplaysToTheSameHash) {
  tap(' ');
  frames(20);
  pressOnCloth();
  frames(15);
  release(kLeftButton);
  tap('4');
  frames(20);
  const EventLog log = viewer_.run().record();
  Simulation again(curtain(), findMethod(log.integrator), {.threads = 1});
  again.replay(parseEventLog(formatEventLog(log), "record"), methods());
  while (again.ticks() < log.ticks) again.tick();
  EXPECT_EQ(again.hash(), viewer_.run().simulation().hash());
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

TEST_F(ViewerTest, AMinimisedWindowChangesNothing) {
  const glm::vec3 eye = viewer_.view().camera().eye();
  viewer_.resize({}, {});
  press(kLeftButton, 10, 10), release(kLeftButton);
  tap('F');
  frames(3);
  EXPECT_EQ(viewer_.view().camera().eye(), eye);
  EXPECT_EQ(viewer_.logLine().pushes, 0);
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
  EXPECT_EQ(viewer_.run().failure().message(), "the driver gave up");
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
}  // namespace tyg
