// The viewer in a failure, without a window: what it says, and the ways out of it with all that was set.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/simulation/live_parameters.h"
#include "study/limits/stability.h"
#include "viewer/edits.h"
#include "viewer/viewer_fixture.h"

namespace tyg {
namespace {

/// A step far past the limit of every method here.
class WildViewerTest : public ViewerTest {
 protected:
  static Scene wild() {
    Scene scene = curtain();
    scene.dt = 0.05;
    return scene;
  }
  WildViewerTest() : ViewerTest(wild()) {}
  void runUntilFrozen() {
    tap(' ');
    for (int frame = 0; frame < 600 && viewer_.run().state() == RunState::Running; ++frame) frames(1);
  }
};

TEST_F(WildViewerTest, AnUnstableClothFreezesAtItsLastGoodFrame) {
  runUntilFrozen();
  ASSERT_EQ(viewer_.run().state(), RunState::Frozen);
  for (const float coordinate : viewer_.run().shown().positions()) ASSERT_LT(std::abs(coordinate), 10);
  EXPECT_LT(viewer_.run().shown().time(), viewer_.run().simulation().time());
  EXPECT_NE(viewer_.logLine().alarm, "ok");
}

TEST_F(WildViewerTest, TheMessageNamesMethodStepAndTime) {
  runUntilFrozen();
  for (const char* word : {"rk4", "50 ms", " s: "}) {
    EXPECT_NE(viewer_.run().failure().message().find(word), std::string::npos) << viewer_.run().failure().message();
  }
}

TEST_F(WildViewerTest, AFrozenClothStaysFrozenUntilRestartedWithTheChosenMethod) {
  runUntilFrozen();
  const double then = viewer_.run().shown().time();
  tap(' '), tap('.'), clickOnCloth(), tap('2');
  frames(5);
  EXPECT_EQ(viewer_.run().state(), RunState::Frozen);
  EXPECT_EQ(viewer_.run().shown().time(), then);
  tap('R');
  EXPECT_EQ(viewer_.run().state(), RunState::Waiting);
  EXPECT_EQ(viewer_.run().simulation().method().name, "symplectic-euler");
  EXPECT_EQ(viewer_.run().simulation().status(), Status::Ok);
}

TEST_F(WildViewerTest, SpaceWhileFrozenSaysWhatItWouldDo) {
  runUntilFrozen();
  tap(' ');
  EXPECT_EQ(viewer_.run().state(), RunState::Frozen);
  EXPECT_NE(viewer_.notes().text().find("into the failure"), std::string::npos) << viewer_.notes().text();
}

TEST_F(WildViewerTest, TheSameFailureIsToldAlikeHoweverItIsReached) {
  runUntilFrozen();
  const std::string told = viewer_.run().failure().message();
  for (const KeyCode way : {'J', ','}) {
    tap(way);
    frames(2);
    for (int frame = 0; frame < 3000 && viewer_.run().state() != RunState::Frozen; ++frame) {
      if (way == ',' || viewer_.run().state() == RunState::Paused) tap('.');
      frames(1);
    }
    EXPECT_EQ(viewer_.run().failure().message(), told) << way;
  }
}

TEST_F(WildViewerTest, AnUndoThatMendsTheStepGoesOnFromBeforeTheFailure) {
  Edits edits(viewer_);
  Scene wanted = viewer_.scenes().scene();
  wanted.dt = 0.002;
  viewer_.scenes().use(wanted);
  edits.follow(viewer_);
  tap(' '), frames(60);
  wanted.dt = 0.05;
  viewer_.scenes().use(wanted);
  edits.follow(viewer_);
  for (int frame = 0; frame < 600 && viewer_.run().state() == RunState::Running; ++frame) frames(1);
  ASSERT_EQ(viewer_.run().state(), RunState::Frozen);
  const double broke = viewer_.run().failure().alarmTime();
  edits.undo(viewer_);
  frames(120);
  EXPECT_EQ(viewer_.run().state(), RunState::Running) << viewer_.run().failure().message();
  EXPECT_EQ(viewer_.run().simulation().dt(), 0.002);
  EXPECT_GT(viewer_.run().simulation().time(), broke);
}

TEST_F(WildViewerTest, TheMessageNamesTheLimitAndTheWaysOut) {
  runUntilFrozen();
  ASSERT_TRUE(viewer_.run().failure().cure());
  for (const char* words : {"its limit is 4.26 ms", "take a step of 3.8 ms", "which holds with this step"}) {
    EXPECT_NE(viewer_.run().failure().message().find(words), std::string::npos) << viewer_.run().failure().message();
  }
}

TEST_F(WildViewerTest, TheSafeStepGoesOnFromBeforeTheFailureAndHolds) {
  runUntilFrozen();
  const double then = viewer_.run().shown().time();
  tap('V');
  EXPECT_EQ(viewer_.run().state(), RunState::Running);
  EXPECT_LE(viewer_.run().shown().time(), then);
  EXPECT_EQ(viewer_.run().simulation().dt(), 0.0038);
  frames(200);
  EXPECT_EQ(viewer_.run().state(), RunState::Running);
  EXPECT_GT(viewer_.run().shown().time(), then + 2);
  EXPECT_EQ(viewer_.run().simulation().status(), Status::Ok);
}

TEST_F(WildViewerTest, AMethodThatHoldsGoesOnWithTheSameStep) {
  runUntilFrozen();
  const Method* other = viewer_.run().failure().cure()->method;
  ASSERT_NE(other, nullptr);
  tap('M');
  EXPECT_EQ(&viewer_.run().simulation().method(), other);
  EXPECT_EQ(viewer_.run().simulation().dt(), 0.05);
  frames(100);
  EXPECT_EQ(viewer_.run().state(), RunState::Running);
}

TEST_F(WildViewerTest, RunsOnPastItsAlarmWhenToldToAndComesBack) {
  runUntilFrozen();
  const double then = viewer_.run().shown().time();
  for (const char* time : {"once", "again"}) {
    tap(kEnterKey);
    frames(1);
    EXPECT_EQ(viewer_.run().state(), RunState::Running) << time;
    for (int frame = 0; frame < 2000 && viewer_.run().state() == RunState::Running; ++frame) frames(1);
    EXPECT_EQ(viewer_.run().state(), RunState::Frozen) << "it is many times as large as its sheet, " << time;
    EXPECT_GT(viewer_.run().simulation().time(), then) << time;
    EXPECT_TRUE(viewer_.run().showsBreaking()) << time;
  }
  tap('V');
  EXPECT_LE(viewer_.run().shown().time(), then);
  frames(60);
  EXPECT_EQ(viewer_.run().state(), RunState::Running);
}

/// When the alarm goes, s, in frames that come at this rate.
double alarmTimeAt(double framesPerSecond, double dt) {
  Scene scene = loadScene("curtain");
  scene.dt = dt;
  double now = 0;
  Viewer viewer(scene, Settings{.threads = 1}, [&now] { return now; });
  viewer.perform(InputAction::StartOrPause);
  for (int frame = 0; frame < 3000 && viewer.run().state() == RunState::Running; ++frame) {
    now += 1 / framesPerSecond;
    viewer.frame();
  }
  return viewer.run().failure().alarmTime();
}

TEST(FailureTest, AFailureHasTheSameTimeWhateverTheFrameRate) {
  for (const double dt : {0.0046, 0.006, 0.02}) {
    Scene scene = loadScene("curtain");
    scene.dt = dt;
    Simulation plain(scene, findMethod(scene.integrator), {});
    plain.tick(100000);
    ASSERT_NE(plain.status(), Status::Ok);
    const double time = alarmTimeAt(60, dt);
    EXPECT_LE(time, plain.alarmTime() + 1e-9) << dt;
    EXPECT_GT(time, plain.alarmTime() - 64 * dt) << dt << ", a plain run looks every 64 steps";
    for (const double rate : {17.0, 144.0}) EXPECT_EQ(alarmTimeAt(rate, dt), time) << dt << " " << rate;
  }
}

/// Just past its limit, where an instability takes a while to grow.
class BreakingViewerTest : public ViewerTest {
 protected:
  static Scene breaking() {
    Scene scene = curtain();
    scene.dt = 0.0046;
    return scene;
  }
  BreakingViewerTest() : ViewerTest(breaking()) {}
  void runUntilFrozen() {
    for (int frame = 0; frame < 3000 && viewer_.run().state() == RunState::Running; ++frame) frames(1);
  }
};

TEST_F(BreakingViewerTest, LettingItBreakIsSlowIsFollowedByTheCameraAndEndsWithTheWaysOut) {
  tap(' ');
  runUntilFrozen();
  ASSERT_EQ(viewer_.run().state(), RunState::Frozen);
  ASSERT_TRUE(viewer_.run().failure().motion());
  EXPECT_EQ(viewer_.run().failure().motion()->name, "stripes");
  EXPECT_FALSE(viewer_.run().showsBreaking()) << "the last good frame is shown";
  tap(kEnterKey);
  EXPECT_LT(viewer_.run().frameClock().speed(), 0.2);
  const double began = now_;
  frames(30);
  EXPECT_TRUE(viewer_.run().showsBreaking());
  EXPECT_GT(viewer_.run().breaking().size(), 2U);
  runUntilFrozen();
  EXPECT_EQ(viewer_.run().state(), RunState::Frozen);
  EXPECT_GT(now_ - began, 3) << "s, of the clock";
  EXPECT_TRUE(viewer_.run().failure().cure());
  for (const glm::vec3& corner : viewer_.run().shown().box().corners()) {
    const glm::vec4 clip =
        viewer_.view().camera().projection(1280.0F / 720) * viewer_.view().camera().view() * glm::vec4(corner, 1);
    EXPECT_LT(std::abs(clip.x / clip.w), 1.05F);
    EXPECT_LT(std::abs(clip.y / clip.w), 1.05F);
  }
  tap('V');
  frames(120);
  EXPECT_EQ(viewer_.run().state(), RunState::Running);
  EXPECT_EQ(viewer_.run().frameClock().speed(), 1);
  EXPECT_FALSE(viewer_.run().showsBreaking());
}

class StretchedViewerTest : public ViewerTest {
 protected:
  StretchedViewerTest() : ViewerTest(loadScene("fail-stretched", methodNames())) {}
  void runUntilFrozen() {
    for (int frame = 0; frame < 3000 && viewer_.run().state() == RunState::Running; ++frame) frames(1);
    ASSERT_EQ(viewer_.run().state(), RunState::Frozen);
  }
};

TEST_F(StretchedViewerTest, ItsFailureIsExplainedAlikeAfterItWasLetBreak) {
  tap(' ');
  runUntilFrozen();
  const std::string told = viewer_.run().failure().message();
  const double step = viewer_.run().failure().cure()->step;
  tap(kEnterKey);
  frames(30);
  EXPECT_TRUE(viewer_.run().showsBreaking());
  EXPECT_EQ(viewer_.run().margin().band(), MarginBand::Past) << viewer_.run().margin().share();
  runUntilFrozen();
  EXPECT_EQ(viewer_.run().failure().message(), told);
  EXPECT_EQ(viewer_.run().failure().cure()->step, step);
}

class HardFloorViewerTest : public ViewerTest {
 protected:
  HardFloorViewerTest() : ViewerTest(loadScene("fail-contact", methodNames())) {}
};

TEST_F(HardFloorViewerTest, AFailureByContactNamesTheParticleAndIsNoWave) {
  tap(' ');
  for (int frame = 0; frame < 600 && viewer_.run().state() == RunState::Running; ++frame) frames(1);
  ASSERT_TRUE(viewer_.run().failure().motion());
  EXPECT_EQ(viewer_.run().failure().motion()->name, "a particle on the plane");
  EXPECT_EQ(viewer_.run().failure().motion()->columns, 0);
}

TEST_F(WildViewerTest, AFrozenClothStepsBackAndOnAgain) {
  runUntilFrozen();
  const double then = viewer_.run().shown().time();
  tap(',');
  EXPECT_EQ(viewer_.run().state(), RunState::Paused);
  EXPECT_NEAR(viewer_.run().shown().time(), then - 0.05, 1e-9);
  EXPECT_TRUE(viewer_.run().failure().message().empty());
  tap('.');
  EXPECT_EQ(viewer_.run().shown().time(), then);
  for (int step = 0; step < 100 && viewer_.run().state() == RunState::Paused; ++step) tap('.');
  EXPECT_EQ(viewer_.run().state(), RunState::Frozen);
}

TEST_F(WildViewerTest, AReplayRunsSlowlyIntoTheFailureAgain) {
  runUntilFrozen();
  const double then = viewer_.run().shown().time();
  tap('J');
  EXPECT_EQ(viewer_.run().state(), RunState::Running);
  EXPECT_LT(viewer_.run().frameClock().speed(), 1);
  const double from = viewer_.run().shown().time();
  EXPECT_LT(from, then);
  frames(60);
  EXPECT_LE(viewer_.run().shown().time(), from + 0.125 + 0.05);  // a second at an eighth of the speed, and a tick
  for (int frame = 0; frame < 2000 && viewer_.run().state() == RunState::Running; ++frame) frames(1);
  EXPECT_NE(viewer_.run().state(), RunState::Running);
  EXPECT_GE(viewer_.run().shown().time(), then);
  EXPECT_EQ(viewer_.run().frameClock().speed(), 1);
}

TEST_F(WildViewerTest, ARecordOfACuredRunReplaysToTheSameHash) {
  runUntilFrozen();
  tap('V');
  frames(30);
  const EventLog log = viewer_.run().record();
  Simulation again(wild(), findMethod(log.integrator), {.threads = 1});
  again.replay(log, methods());
  again.tick(log.ticks);
  EXPECT_EQ(again.hash(), viewer_.run().simulation().hash());
}

/// Half a second of rk4, then a step, springs and a method that do not go with each other.
class MischosenViewerTest : public ViewerTest {
 protected:
  MischosenViewerTest() {
    tap(' ');
    frames(30);
    stiff_ = viewer_.scenes().scene();
    stiff_.dt = 0.003, stiff_.bend.ks *= 1.5, stiff_.gravity.y *= 0.5;
    viewer_.scenes().use(stiff_);
    tap('1');  // explicit-euler
    stiff_.integrator = viewer_.scenes().method().name;
    for (int frame = 0; frame < 600 && viewer_.run().state() == RunState::Running; ++frame) frames(1);
  }
  Scene stiff_;
};

TEST_F(MischosenViewerTest, ACureIsForTheMethodTheStepAndTheWorldThatFailed) {
  ASSERT_EQ(viewer_.run().state(), RunState::Frozen);
  const double limit = restLatticeLimit(stiff_, findMethod("explicit-euler"));
  ASSERT_LT(limit, stiff_.dt);
  EXPECT_EQ(viewer_.run().margin().limit, limit);
  EXPECT_EQ(viewer_.run().failure().cure()->step, safeStep(limit));
  EXPECT_NE(viewer_.run().failure().message().find(fmt::format(": its limit is {:.3g} ms; take", 1e3 * limit)),
            std::string::npos)
      << viewer_.run().failure().message();
}

TEST_F(MischosenViewerTest, ACuredRunHasTheSettingsThatFailedAndTheCure) {
  ASSERT_LT(viewer_.run().shown().time(), 0.75) << "chosen within what a cure goes back";
  stiff_.dt = viewer_.run().failure().cure()->step;
  tap('V');
  EXPECT_EQ(viewer_.run().state(), RunState::Running);
  EXPECT_EQ(viewer_.scenes().scene(), stiff_);
  EXPECT_EQ(viewer_.run().simulation().method().name, "explicit-euler");
  EXPECT_EQ(viewer_.run().simulation().dt(), stiff_.dt);
  EXPECT_TRUE(sameLiveParameters(viewer_.run().simulation().scene(), stiff_));
  frames(60);
  EXPECT_EQ(viewer_.run().state(), RunState::Running);
  const EventLog log = viewer_.run().record();
  Simulation again(curtain(), findMethod(log.integrator), {.threads = 1});
  again.replay(log, methods());
  again.tick(log.ticks);
  EXPECT_EQ(again.hash(), viewer_.run().simulation().hash());
}

TEST_F(MischosenViewerTest, WhatIsChosenWhileItIsFrozenAndHoldsGoesOnFromBeforeTheFailure) {
  const double then = viewer_.run().shown().time();
  Scene chosen = viewer_.scenes().scene();
  chosen.integrator = "leapfrog", chosen.dt = 5e-4, chosen.drag = 0.01;
  ASSERT_EQ(viewer_.scenes().use(chosen), SceneChange::Live);
  EXPECT_LE(viewer_.run().simulation().time(), then);
  frames(60);
  EXPECT_EQ(viewer_.run().state(), RunState::Running);
  EXPECT_EQ(viewer_.scenes().scene(), chosen);
  EXPECT_EQ(viewer_.run().simulation().method().name, "leapfrog");
  EXPECT_EQ(viewer_.run().simulation().scene().drag, 0.01);
}

TEST_F(MischosenViewerTest, WhatIsChosenWhileItIsFrozenAndDoesNotHoldIsShown) {
  Scene chosen = viewer_.scenes().scene();
  chosen.integrator = "leapfrog", chosen.dt = 0.01;
  ASSERT_EQ(viewer_.scenes().use(chosen), SceneChange::Live);
  frames(1);
  EXPECT_EQ(viewer_.run().state(), RunState::Frozen);
  StepText step;
  viewer_.scenes().describeStep(step);
  EXPECT_STREQ(step.data(), "step of 10 ms");
  EXPECT_EQ(viewer_.run().margin().limit, restLatticeLimit(chosen, findMethod("leapfrog")));
}

TEST_F(WildViewerTest, AStepThatIsMadeSmallerWhileItIsFrozenEndsTheFreezeWhereItHolds) {
  runUntilFrozen();
  for (int press = 0; press < 200 && viewer_.run().state() == RunState::Frozen; ++press) tap('[');
  EXPECT_LT(viewer_.scenes().scene().dt, 0.0045);
  EXPECT_GT(viewer_.scenes().scene().dt, 0.0035);
  frames(30);
  EXPECT_EQ(viewer_.run().state(), RunState::Running);
}

TEST_F(WildViewerTest, AButtonOfAMethodThatRefusesTheSceneSaysSo) {
  Scene axial = wild();
  axial.damping = Damping::Axial;
  viewer_.scenes().use(axial);
  runUntilFrozen();
  ASSERT_EQ(viewer_.run().state(), RunState::Frozen);
  const auto imex = std::ranges::find(methods(), "imex", &Method::name) - methods().begin();
  viewer_.scenes().chooseMethod(static_cast<std::size_t>(imex));
  ASSERT_EQ(viewer_.scenes().method().name, "imex");
  EXPECT_NO_THROW(viewer_.perform(InputAction::Restart));
  EXPECT_NE(viewer_.notes().text().find("axial"), std::string::npos) << viewer_.notes().text();
}

}  // namespace
}  // namespace tyg
