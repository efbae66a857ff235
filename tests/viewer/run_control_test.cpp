// The run of a cloth through time, without a window: back and forth, to sleep and on, and nothing is lost.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <string>

#include "app/reports/run_report.h"
#include "viewer/viewer_fixture.h"

namespace tyg {
namespace {

TEST_F(ViewerTest, StepsBackTickByTickAndForwardAgainToTheSameState) {
  tap(' ');
  frames(30);
  tap(' ');
  const std::int64_t end = ticks();
  const std::uint64_t hash = viewer_.run().simulation().hash();
  tap(','), tap(','), tap(',');
  EXPECT_EQ(ticks(), end - 3);
  EXPECT_NE(viewer_.run().simulation().hash(), hash);
  tap('.'), tap('.'), tap('.');
  EXPECT_EQ(ticks(), end);
  EXPECT_EQ(viewer_.run().simulation().hash(), hash);
}

TEST_F(ViewerTest, AHeldKeyStepsOnAndOn) {
  tap(' ');
  frames(60);
  tap(' ');
  const std::int64_t end = ticks();
  press(',');
  frames(60);
  release(',');
  EXPECT_LT(ticks(), end - 5);
  const std::int64_t then = ticks();
  frames(60);
  EXPECT_EQ(ticks(), then);
}

TEST_F(ViewerTest, ThePastCanBeLookedAtWithoutLosingTheRecord) {
  tap(' ');
  frames(30);
  tap(' ');
  const EventLog record = viewer_.run().record();
  viewer_.run().turnToTime(0.1);
  EXPECT_NEAR(viewer_.run().shown().time(), 0.1, 1e-9);
  EXPECT_TRUE(viewer_.run().timeline().past);
  EXPECT_EQ(viewer_.run().record(), record);
}

TEST_F(ViewerTest, WhatIsKeptWithAPictureOfThePastEndsThere) {
  tap(' ');
  frames(30);
  tap(']');
  frames(30);
  viewer_.run().turnToTime(0.1);
  const EventLog log = viewer_.run().recordShown();
  EXPECT_EQ(log.ticks, ticks());
  EXPECT_TRUE(log.events.empty());
  Simulation again(curtain(), findMethod(log.integrator), {.threads = 1});
  again.replay(log, methods());
  again.tick(log.ticks);
  EXPECT_EQ(again.hash(), viewer_.run().simulation().hash());
  EXPECT_EQ(hashText(again), log.hash);
}

TEST_F(ViewerTest, SingleStepsThroughThePastShowWhatWasSetThen) {
  const double dt = viewer_.run().simulation().dt();
  tap('.'), tap('.'), tap(']'), tap('.');
  tap(','), tap(',');
  EXPECT_EQ(viewer_.scenes().scene().dt, dt);
  tap('.'), tap('.');
  EXPECT_EQ(viewer_.scenes().scene().dt, viewer_.run().simulation().dt());
  EXPECT_NEAR(viewer_.scenes().scene().dt, 1.05 * dt, 1e-12);
}

TEST_F(ViewerTest, GoingOnFromThePastForgetsWhatCameAfter) {
  tap(' ');
  frames(30);
  clickOnCloth();
  frames(30);
  viewer_.run().turnToTime(0.1);
  tap(' ');
  frames(1);
  EXPECT_FALSE(viewer_.run().timeline().past);
  EXPECT_LT(viewer_.run().shown().time(), 0.2);
  EXPECT_TRUE(viewer_.run().record().events.empty());
}

TEST_F(ViewerTest, AStepThatIsDraggedPastItsLimitIsWarnedOfBeforeItBreaks) {
  tap(' ');
  bool close = false;
  press(']');
  for (int frame = 0; frame < 600 && viewer_.run().state() == RunState::Running; ++frame) {
    frames(1);
    close = close || viewer_.run().margin().band() == MarginBand::Close;
  }
  release(']');
  EXPECT_TRUE(close);
  EXPECT_EQ(viewer_.run().margin().band(), MarginBand::Past);
  EXPECT_EQ(viewer_.run().state(), RunState::Frozen);
}

TEST_F(ViewerTest, SlowMotionMakesTimeSlower) {
  tap(';'), tap(';');
  EXPECT_EQ(viewer_.run().frameClock().speed(), 0.25);
  tap(' ');
  frames(60);
  EXPECT_NEAR(viewer_.run().shown().time(), 0.25, 0.01);
  tap('\''), tap('\''), tap('\'');
  EXPECT_EQ(viewer_.run().frameClock().speed(), 1);
}

TEST_F(ViewerTest, ASpeedThatIsChosenInAReplayOutlastsIt) {
  tap(' ');
  frames(90);
  tap('J'), tap('\''), tap('\'');
  const double chosen = viewer_.run().frameClock().speed();
  EXPECT_EQ(chosen, 0.5);
  for (int frame = 0; frame < 600 && viewer_.run().state() == RunState::Running; ++frame) frames(1);
  EXPECT_EQ(viewer_.run().state(), RunState::Paused);
  EXPECT_EQ(viewer_.run().frameClock().speed(), chosen);
}

TEST_F(ViewerTest, ARestartSurvivesARecordThatCannotBeKept) {
  viewer_.run().onRunEnd([](const EventLog&) { throw InputError("the disk is full"); });
  tap('.');
  tap('R');
  EXPECT_EQ(viewer_.run().state(), RunState::Waiting);
  EXPECT_EQ(viewer_.run().shown().time(), 0);
  EXPECT_EQ(viewer_.notes().text(), "the disk is full");
  EXPECT_TRUE(viewer_.notes().warns());
  viewer_.notes().say("saved to curtain.toml", now_ + Notes::kFiles);
  EXPECT_FALSE(viewer_.notes().warns());
  tap('.');
  EXPECT_FALSE(viewer_.notes().text().empty()) << "where a file is stays long enough to be read";
  now_ += Notes::kFiles;
  tap('.');
  EXPECT_TRUE(viewer_.notes().text().empty());
}

/// Starts nearly as it will hang, and loses all motion within seconds.
class CalmViewerTest : public ViewerTest {
 protected:
  static Scene calm() {
    Scene scene = curtain();
    scene.columns = scene.rows = 6;
    scene.pins = {{.name = "top"}};
    scene.start = Start::Hanging;
    scene.drag = 0.2;
    return scene;
  }
  CalmViewerTest() : ViewerTest(calm()) {}
  void runUntilAsleep() {
    tap(' ');
    for (int frame = 0; frame < 1800 && !viewer_.run().asleep(); ++frame) frames(1);
  }
};

TEST_F(CalmViewerTest, FallsAsleepWhenNothingMovesAndThenNoTicksPass) {
  runUntilAsleep();
  ASSERT_TRUE(viewer_.run().asleep());
  EXPECT_TRUE(viewer_.idle());
  EXPECT_EQ(viewer_.run().state(), RunState::Running);
  for (int particle = 0; particle < 36; ++particle) {
    const Vec3 v = viewer_.run().simulation().velocity(particle);
    EXPECT_LT(std::hypot(v.x, v.y, v.z), 1e-3);  // m/s
  }
  const std::int64_t then = ticks();
  frames(100);
  EXPECT_EQ(ticks(), then);
}

TEST_F(CalmViewerTest, AsleepItIsNotBehindRealTime) {
  tap(' ');
  for (int frame = 0; frame < 1800 && !viewer_.run().asleep(); ++frame) frames(1, 0.3);
  ASSERT_TRUE(viewer_.run().asleep());
  EXPECT_TRUE(viewer_.pace().behind) << "it was, until then";
  EXPECT_FALSE(viewer_.behind());
}

TEST_F(CalmViewerTest, WhateverChangesSomethingWakesItAtOnce) {
  runUntilAsleep();
  const std::array<std::function<void()>, 4> changes{[this] { tap(kLeftButton); }, [this] { tap('4'); },
                                                     [this] { tap(']'); }, [this] { tap(' '), tap(' '); }};
  for (const auto& change : changes) {
    ASSERT_TRUE(viewer_.run().asleep());
    const double then = viewer_.run().shown().time();
    now_ += 1000;
    change();
    EXPECT_FALSE(viewer_.run().asleep());
    frames(1);
    EXPECT_GT(viewer_.run().shown().time(), then);
    EXPECT_LT(viewer_.run().shown().time(), then + 0.1);  // the sleep is not made up
    for (int frame = 0; frame < 1800 && !viewer_.run().asleep(); ++frame) frames(1);
  }
}

TEST_F(CalmViewerTest, ItsSleepIsNoPartOfTheRecord) {
  runUntilAsleep();
  frames(50);
  tap(kLeftButton);
  frames(50);
  const EventLog log = viewer_.run().record();
  Simulation again(calm(), findMethod(log.integrator), {.threads = 1});
  again.replay(log, methods());
  again.tick(log.ticks);
  EXPECT_EQ(again.hash(), viewer_.run().simulation().hash());
}

/// Its method chooses some hundred steps for each tick, and each look at the clock takes a second.
/// Falls onto a floor whose layer a step crosses.
class FallingViewerTest : public ViewerTest {
 protected:
  static Scene falling() {
    Scene scene = curtain();
    scene.columns = scene.rows = 6;
    scene.pins.clear();
    scene.start = Start::Flat;
    scene.integrator = "leapfrog", scene.dt = 1e-3;
    scene.bodies = {{.shape = Shape::Plane, .at = {0, -1, 0}}};
    scene.contact = {.stiffness = 500, .layer = 1e-3};
    fillContact(scene);
    return scene;
  }
  FallingViewerTest() : ViewerTest(falling()) {}
};

TEST_F(FallingViewerTest, AStepThatCrossesTheLayerIsToldOnceInARun) {
  const auto isTold = [&] { return viewer_.notes().text().find("of the layer of contact") != std::string::npos; };
  for (int run = 0; run < 2; ++run) {
    tap(' ');
    EXPECT_FALSE(isTold());
    frames(30);
    EXPECT_TRUE(isTold()) << run;
    tap('H'), tap('H');
    frames(10);
    EXPECT_FALSE(isTold()) << "once is enough";
    viewer_.scenes().restart();
  }
}

class StallingViewerTest : public ViewerTest {
 protected:
  static Scene stalling() {
    Scene scene = curtain();
    scene.integrator = "dopri54", scene.dt = 0.05, scene.tolerance = 1e-13;
    return scene;
  }
  StallingViewerTest() : ViewerTest(stalling()) { look_ = 1; }
};

TEST_F(StallingViewerTest, NoFrameWaitsForATickThatDoesNotEnd) {
  tap(' ');
  frames(3, 0.5);
  EXPECT_EQ(viewer_.run().state(), RunState::Frozen);
  EXPECT_NE(viewer_.run().failure().message().find("dopri54 stalled at 0.000 s"), std::string::npos)
      << viewer_.run().failure().message();
  EXPECT_EQ(ticks(), 0);
  look_ = 0;
  tap('M');
  frames(3, 0.5);
  EXPECT_EQ(viewer_.run().state(), RunState::Running);
  EXPECT_NE(viewer_.scenes().method().name, "dopri54");
  EXPECT_GT(viewer_.run().shown().time(), 0);
}

class PushedLaterViewerTest : public ViewerTest {
 protected:
  static Scene pushedLater() {
    Scene scene = curtain();
    scene.gravity = {};
    scene.pushes = {{.particle = {.name = "middle"}, .force = {0, 0, 5}, .at = 3, .duration = 0.1}};
    return scene;
  }
  PushedLaterViewerTest() : ViewerTest(pushedLater()) {}
};

TEST_F(PushedLaterViewerTest, AClothWithAPushStillToComeStaysAwake) {
  tap(' ');
  for (int frame = 0; frame < 240; ++frame) {
    frames(1);
    ASSERT_FALSE(viewer_.run().asleep());
  }
  EXPECT_GT(viewer_.run().shown().time(), 3.5);
}

TEST_F(ViewerTest, EveryStepBackCountsWhileAnEarlierOneIsOnItsWay) {
  viewer_.perform(InputAction::StartOrPause);
  frames(60);
  viewer_.perform(InputAction::StartOrPause);
  const std::int64_t before = viewer_.run().shown().tick();
  look_ = 0.02;  // a slow machine
  for (int count = 0; count < 5; ++count) {
    viewer_.perform(InputAction::StepBack);
    EXPECT_TRUE(viewer_.run().seeking());
    frames(1);
  }
  look_ = 0;
  frames(60);
  EXPECT_FALSE(viewer_.run().seeking());
  EXPECT_EQ(viewer_.run().shown().tick(), before - 5);
}

}  // namespace
}  // namespace tyg
