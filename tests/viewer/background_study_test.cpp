// The study beside a running window: its rows, its stop sign, and that it takes nothing from the cloth but time.
#include "viewer/background_study.h"
#include "util/calibration_clock.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

#include "test_systems.h"
#include "tyg/methods.h"

namespace tyg {
namespace {

using Stage = StudyProgress::Stage;

Scene smallScene() {
  Scene scene = loadScene("four-particles", methodNames());
  scene.duration = 0.1;
  return scene;
}

/// Looks until the condition holds; false after far longer than any machine needs.
template <class Condition>
bool awaited(BackgroundStudy& study, const Condition& holds) {
  for (int turn = 0; turn < 60000; ++turn) {
    if (holds(study.progress())) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}
bool isDone(const StudyProgress& told) { return told.stage == Stage::Done; }
bool hasRows(const StudyProgress& told) { return !told.rows.empty(); }
std::vector<const Method*> twoMethods() { return {&findMethod("leapfrog"), &findMethod("rk4")}; }

TEST(BackgroundStudy, IsIdleUntilItIsStarted) {
  BackgroundStudy study([] { return calibrationClock(1); });
  EXPECT_EQ(study.progress().stage, Stage::Idle);
  EXPECT_FALSE(study.running());
}

TEST(BackgroundStudy, GivesRowsOfItsMethodsInTheirOrder) {
  BackgroundStudy study([] { return calibrationClock(1); });
  study.start(smallScene(), twoMethods());
  EXPECT_TRUE(study.running());
  ASSERT_TRUE(awaited(study, isDone));
  const StudyProgress& told = study.progress();
  EXPECT_FALSE(study.running());
  EXPECT_EQ(told.rows.front().integrator, "leapfrog");
  EXPECT_EQ(told.rows.back().integrator, "rk4");
  EXPECT_EQ(told.fraction, 1);
  ASSERT_TRUE(told.reference);
  EXPECT_TRUE(told.reference->usable());
}

TEST(BackgroundStudy, HandsRowsOverBeforeItIsDone) {
  BackgroundStudy study([] { return calibrationClock(1); });
  Scene scene = smallScene();
  scene.duration = 1;  // a second of work or more in all: the first row is seen long before the last
  std::vector<const Method*> all;
  for (const Method& method : methods()) all.push_back(&method);
  study.start(scene, all);
  ASSERT_TRUE(awaited(study, hasRows));
  EXPECT_EQ(study.progress().stage, Stage::Rows);
}

TEST(BackgroundStudy, HasTheCoarseRowsOfAllMethodsBeforeItGoesFarDownOne) {
  BackgroundStudy study([] { return calibrationClock(1); });
  study.start(smallScene(), twoMethods());
  const auto inOrder = [](const WorkRow& row) { return std::pair(row.integrator, -row.dt); };
  ASSERT_TRUE(awaited(study, [&](const StudyProgress& told) {
    const auto of = [&](const char* method) { return std::ranges::count(told.rows, method, &WorkRow::integrator); };
    EXPECT_TRUE(std::ranges::is_sorted(told.rows, {}, inOrder));
    EXPECT_EQ(told.allMethods, of("leapfrog") > 5) << "after " << told.rows.size() << " rows";
    EXPECT_TRUE(of("leapfrog") <= 5 || of("rk4") >= 5);
    return isDone(told) || testing::Test::HasFailure();
  }));
}

TEST(BackgroundStudy, FromItsStopOnNothingIsTold) {
  BackgroundStudy study([] { return calibrationClock(1); });
  study.start(smallScene(), twoMethods());
  ASSERT_TRUE(awaited(study, hasRows));
  study.stop();
  for (int turn = 0; turn < 50; ++turn) {
    EXPECT_EQ(study.progress().stage, Stage::Idle);
    EXPECT_TRUE(study.progress().rows.empty());
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

TEST(BackgroundStudy, TheLastOfManyStartsIsTheOneThatIsStudied) {
  BackgroundStudy study([] { return calibrationClock(1); });
  Scene scene = smallScene();
  for (int turn = 1; turn <= 10; ++turn) {
    scene.particleMass = 0.1 + 0.01 * turn;
    study.start(scene, twoMethods());
    std::this_thread::sleep_for(std::chrono::milliseconds(turn % 4));
  }
  ASSERT_TRUE(awaited(study, isDone));
  EXPECT_EQ(study.progress().reference->scene.particleMass, scene.particleMass);
}

TEST(BackgroundStudy, SaysWhyThereAreNoRows) {
  BackgroundStudy study([] { return calibrationClock(1); });
  Scene scene = smallScene();
  scene.columns = scene.rows = 100;
  study.start(scene, twoMethods());
  ASSERT_TRUE(awaited(study, [](const StudyProgress& told) { return told.stage == Stage::Failed; }));
  EXPECT_NE(study.progress().problem.find("10000 particles"), std::string::npos) << study.progress().problem;
}

TEST(BackgroundStudy, WorksAtTheLowestPriority) {
  BackgroundStudy study([] { return calibrationClock(1); });
  study.start(smallScene(), twoMethods());
  ASSERT_TRUE(awaited(study, hasRows));
  EXPECT_EQ(study.niceness(), 19);
}

TEST(BackgroundStudy, TheClothMovesToTheSameBitsBesideIt) {
  const Scene scene = smallScene();
  const Method& method = findMethod("rk4");
  Simulation alone(scene, method, {.threads = 1}), beside(scene, method, {.threads = 1});
  for (int tick = 0; tick < 200; ++tick) alone.tick();
  BackgroundStudy study([] { return calibrationClock(1); });
  study.start(scene, twoMethods());
  ASSERT_TRUE(awaited(study, hasRows));
  for (int tick = 0; tick < 200; ++tick) {
    beside.tick();
    study.progress();
  }
  EXPECT_EQ(beside.hash(), alone.hash());
  EXPECT_EQ(beside.forceEvaluations(), alone.forceEvaluations());
}

}  // namespace
}  // namespace tyg
