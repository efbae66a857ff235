// A moving simulation that is edited, saved, restored and replayed: nothing of the past may leak into a step.
#include <gtest/gtest.h>

#include <algorithm>

#include "method_checks.h"
#include "tyg/methods.h"
#include "tyg/simulation.h"

namespace tyg::test {
namespace {

/// A sheet in steps of a power of two seconds, so that whole ticks are exact in binary.
Scene tickingSheet() {
  Scene scene = softSheet(Damping::Relative);
  scene.dt = 1.0 / 256;
  scene.tolerance = 0;  // adaptive methods take steps of dt
  return scene;
}

void tick(Simulation& simulation, int times) {
  for (int n = 0; n < times; ++n) simulation.tick();
}

constexpr int kMiddle = 7;
constexpr Vec3 kPush{3, -1, 2};

TEST(Edits, PushThenStepEqualsAFreshIntegratorsStepBitForBit) {
  for (const Method& method : methods()) EXPECT_TRUE(stepsAfreshAfterAPush(tickingSheet(), method)) << method.name;
}

TEST(Edits, APushActsForItsTicksAndNoLonger) {
  Scene scene = emptyWorld(1, 1);
  scene.dt = 1.0 / 64;
  scene.tolerance = 0;
  for (const Method& method : methods()) {
    Simulation simulation(scene, method);
    simulation.push(0, {2, 0, 0}, 3);
    tick(simulation, 3);
    const double pushed = simulation.velocity(0).x;
    tick(simulation, 5);
    EXPECT_NEAR(pushed, 2 * 3 * scene.dt, method.name == "report-rk4" ? 0.01 * pushed : 1e-15) << method.name;
    EXPECT_EQ(simulation.velocity(0).x, pushed) << method.name;
  }
}

TEST(Edits, ARestoredMomentGoesOnWithTheSameBits) {
  for (const Precision precision : {Precision::Float, Precision::Double}) {
    for (const Method& method : methods()) {
      Scene scene = tickingSheet();
      scene.precision = precision;
      scene.tolerance = 1e-5;  // adaptive methods step freely and keep their step
      Simulation simulation(scene, method);
      simulation.push(kMiddle, kPush, 40);
      tick(simulation, 20);
      const Snapshot moment = simulation.save();
      EXPECT_EQ(moment.time(), simulation.time());
      tick(simulation, 50);
      const std::uint64_t first = simulation.hash();
      const std::int64_t evaluations = simulation.forceEvaluations();
      simulation.push(2, kPush, 3);
      simulation.useStep(1.0 / 128);
      simulation.useMethod(findMethod("explicit-euler"));
      tick(simulation, 9);
      simulation.restore(moment);
      EXPECT_EQ(simulation.ticks(), 20);
      EXPECT_EQ(simulation.log().events.size(), 1U);
      tick(simulation, 50);
      EXPECT_EQ(simulation.hash(), first) << method.name;
      EXPECT_EQ(simulation.forceEvaluations(), evaluations) << method.name;
    }
  }
}

constexpr std::size_t kChanges = 6;  // of live parameters, in the scene that follows
Scene otherWorld() {
  Scene other = tickingSheet();
  other.structural = {2000, 0.3}, other.bend = {10, 0};
  other.gravity = {1, -5, 2}, other.drag = 0.02, other.tolerance = 1e-5;
  return other;
}

TEST(Edits, AnotherWorldActsFromTheNextTickOnAndIsLoggedOnce) {
  for (const Method& method : methods()) {
    Simulation simulation(tickingSheet(), method), plain(tickingSheet(), method);
    tick(simulation, 10), tick(plain, 10);
    const std::uint64_t before = simulation.hash();
    simulation.useLiveParameters(otherWorld());
    EXPECT_EQ(simulation.hash(), before) << method.name;
    EXPECT_EQ(simulation.log().events.size(), kChanges) << method.name;
    simulation.useLiveParameters(otherWorld());
    EXPECT_EQ(simulation.log().events.size(), kChanges) << method.name;
    tick(simulation, 5), tick(plain, 5);
    EXPECT_NE(simulation.hash(), plain.hash()) << method.name;
    EXPECT_EQ(simulation.status(), Status::Ok) << method.name;
    EXPECT_EQ(simulation.startScene().gravity, tickingSheet().gravity);
    EXPECT_EQ(simulation.scene().gravity, otherWorld().gravity);
  }
}

TEST(Edits, AMomentBeforeAnotherWorldComesBackWithItsOwn) {
  for (const Method& method : methods()) {
    Simulation simulation(tickingSheet(), method);
    tick(simulation, 10);
    const Snapshot moment = simulation.save();
    tick(simulation, 20);
    const std::uint64_t plain = simulation.hash();
    simulation.restore(moment);
    simulation.useLiveParameters(otherWorld());
    tick(simulation, 20);
    simulation.restore(moment);
    EXPECT_EQ(simulation.scene(), simulation.startScene());
    tick(simulation, 20);
    EXPECT_EQ(simulation.hash(), plain) << method.name;
  }
}

TEST(Edits, TheLedgerStaysBalancedWhenTheWorldChanges) {
  Simulation simulation(tickingSheet(), findMethod("rk4"), {.ledger = true});
  tick(simulation, 20);
  simulation.useLiveParameters(otherWorld());
  constexpr double kRounding = 1e-12;
  const double drift = simulation.ledger().drift;
  simulation.useLiveParameters(tickingSheet());
  simulation.useLiveParameters(otherWorld());
  EXPECT_NEAR(simulation.ledger().drift, drift, kRounding);
  tick(simulation, 100);
  constexpr double kOfTheMethod = 1e-4;  // what rk4 loses with this step
  EXPECT_LT(std::abs(simulation.ledger().drift), kOfTheMethod);
}

TEST(Edits, AReplayedLogGivesTheSameBits) {
  for (const Method& method : methods()) {
    Scene scene = tickingSheet();
    scene.tolerance = 1e-4;
    scene.pushes = {{{"bottom-left"}, {0, 0, 2}, 0.1003, 0.05}};
    Simulation live(scene, method);
    tick(live, 10);
    live.push(kMiddle, kPush, 12);
    tick(live, 5);
    live.push(3, {0, 0, -5}, 4);
    live.useStep(0.0031);
    tick(live, 20);
    live.useLiveParameters(otherWorld());
    tick(live, 3);
    live.useMethod(findMethod("leapfrog"));
    tick(live, 20);
    live.useMethod(method);
    live.push(kMiddle, kPush, 1);
    tick(live, 10);

    const EventLog log = parseEventLog(formatEventLog(live.log()), "log");
    EXPECT_EQ(log.ticks, 68);
    Simulation again(scene, method);
    again.replay(log, methods());
    for (std::int64_t n = 0; n < log.ticks; ++n) again.tick();
    EXPECT_EQ(again.hash(), live.hash()) << method.name;
    EXPECT_EQ(again.time(), live.time());
    EXPECT_EQ(again.log(), live.log());
  }
}

TEST(Edits, ATickThatTheObserverStopsHasNotBegun) {
  Scene scene = tickingSheet();
  scene.tolerance = 1e-12;
  Simulation simulation(scene, findMethod("dopri54"));
  simulation.useStep(1);  // some hundred steps of the method's own
  simulation.tick();
  const std::uint64_t hash = simulation.hash();
  simulation.push(kMiddle, kPush, 1);
  simulation.observe([] { return false; });
  simulation.tick(2);
  EXPECT_EQ(simulation.ticks(), 1);
  EXPECT_EQ(simulation.time(), 1);
  EXPECT_EQ(simulation.hash(), hash);
  simulation.observe({});
  simulation.tick();
  Simulation never(scene, findMethod("dopri54"));
  never.useStep(1);
  never.tick(), never.push(kMiddle, kPush, 1), never.tick();
  EXPECT_EQ(simulation.hash(), never.hash());
  EXPECT_EQ(simulation.log(), never.log());
}

TEST(Edits, ATickThatAPushCutsIsDoneWholeWhenTheObserverStops) {
  Scene scene = tickingSheet();
  scene.pushes = {{{"middle"}, {0, 0, 1}, 63.5 * scene.dt, 0.1}};  // the energy check after 64 steps lies inside a tick
  Simulation simulation(scene, findMethod("leapfrog")), never(scene, findMethod("leapfrog"));
  simulation.observe([] { return false; });
  tick(simulation, 100), tick(never, 100);
  EXPECT_EQ(simulation.time(), 100 * scene.dt);
  EXPECT_EQ(simulation.steps(), never.steps());
  EXPECT_EQ(simulation.hash(), never.hash());
}

TEST(Edits, ALogOfAnotherSheetMethodStepOrPrecisionIsRefused) {
  const Scene scene = tickingSheet();
  const EventLog right = Simulation(scene, findMethod("rk4")).log();
  std::vector<EventLog> wrong(5, right);
  wrong[0].columns = 4;
  wrong[1].integrator = "leapfrog";
  wrong[2].dt = 0.5;
  wrong[3].precision = Precision::Float;
  wrong[4].events = {{1, PushEvent{12, kPush, 1}}};
  Simulation simulation(scene, findMethod("rk4"));
  simulation.replay(right, methods());
  for (const EventLog& log : wrong) EXPECT_THROW(simulation.replay(log, methods()), InputError);
}

TEST(Edits, AMethodThatCannotTakeTheSceneIsRefusedAndTheOldOneStays) {
  Scene scene = softSheet(Damping::Axial);
  EXPECT_THROW(Simulation(scene, findMethod("imex")), InputError);
  Simulation simulation(scene, findMethod("rk4"));
  simulation.tick();
  EXPECT_THROW(simulation.useMethod(findMethod("imex")), InputError);
  EXPECT_EQ(simulation.method().name, "rk4");
  EXPECT_TRUE(simulation.log().events.empty());
  simulation.tick();
  EXPECT_EQ(simulation.status(), Status::Ok);
}

TEST(Edits, APushOnNobodyOrForNoTimeIsRefused) {
  Simulation simulation(tickingSheet(), findMethod("rk4"));
  EXPECT_THROW(simulation.push(-1, kPush, 1), InputError);
  EXPECT_THROW(simulation.push(12, kPush, 1), InputError);
  EXPECT_THROW(simulation.push(0, kPush, 0), InputError);
  EXPECT_THROW(simulation.useStep(0), InputError);
  EXPECT_THROW(simulation.useStep(-1), InputError);
}

TEST(Edits, AWrongStepIsRefusedWithANumberThatPeopleCanRead) {
  Simulation simulation(tickingSheet(), findMethod("rk4"));
  EXPECT_EQ(messageOf([&] { simulation.useStep(-1e-9); }), "dt: found -1e-09, allowed: above 0");
  EXPECT_EQ(messageOf([&] { simulation.useStep(-1e300); }), "dt: found -1e+300, allowed: above 0");
}

/// Ticks in calls of 1, 2, 3, ... together, with pushes, a method and a step by hand in between.
std::uint64_t hashAfterBatches(Simulation& simulation, int longest) {
  int together = 0;
  for (const std::int64_t end : {30, 75, 110, 300}) {
    while (simulation.ticks() < end) {
      together = together % longest + 1;
      simulation.tick(std::min<std::int64_t>(together, end - simulation.ticks()));
    }
    if (end == 30) simulation.push(kMiddle, kPush, 17);
    if (end == 75) simulation.useStep(simulation.dt() / 3);
    if (end == 110) simulation.useMethod(findMethod("leapfrog"));
  }
  return simulation.hash();
}

TEST(Edits, ManyTicksAtOnceGiveTheBitsOfSingleOnes) {
  for (const Method& method : methods()) {
    for (const double tolerance : {0.0, 1e-4}) {
      Scene scene = tickingSheet();
      scene.tolerance = tolerance;
      for (const double at : {20.5 * scene.dt, 24 * scene.dt}) {  // a push within a tick, and one of whole ticks
        scene.pushes.push_back({.particle = Place{.name = "middle"}, .force = {0, 1, 0}, .at = at, .duration = 0.125});
      }
      Simulation single(scene, method), batches(scene, method);
      EXPECT_EQ(hashAfterBatches(batches, 150), hashAfterBatches(single, 1)) << method.name;
      EXPECT_EQ(batches.time(), single.time());
      EXPECT_EQ(batches.log(), single.log());
      EXPECT_EQ(batches.ledger().work.sum(), single.ledger().work.sum());
    }
  }
}

TEST(Edits, AReplayInManyTicksGivesTheBitsOfTheRun) {
  const Method& method = findMethod("symplectic-euler");
  Simulation first(tickingSheet(), method), again(tickingSheet(), method);
  const std::uint64_t hash = hashAfterBatches(first, 7);
  again.replay(first.log(), methods());
  again.tick(first.ticks());
  EXPECT_EQ(again.hash(), hash);
  EXPECT_EQ(again.log(), first.log());
}

TEST(Edits, ARunThatIsLetGoOnPassesItsAlarm) {
  Scene scene = tickingSheet();
  scene.dt = 0.25;
  Simulation simulation(scene, findMethod("leapfrog"));
  simulation.tick(1000);
  const std::int64_t alarm = simulation.ticks();
  simulation.keepGoing(true);
  simulation.tick(5);
  EXPECT_EQ(simulation.ticks(), alarm + 5);
  simulation.keepGoing(false);
  simulation.tick(5);
  EXPECT_EQ(simulation.ticks(), alarm + 5);
}

TEST(Edits, AMomentTakesTheMemoryOfItsStateAtLeastAndGrowsWithTheSheet) {
  for (const Method& method : methods()) {
    Scene scene = tickingSheet();
    const auto bytesOf = [&](int columns, int rows) {
      scene.columns = columns, scene.rows = rows;
      return Simulation(scene, method).save().bytes();
    };
    const std::size_t small = bytesOf(30, 40);
    EXPECT_GE(small, 6 * sizeof(double) * 30 * 40) << method.name;
    EXPECT_GT(bytesOf(60, 80), 3 * small) << method.name;  // of four times, as rows are padded
  }
}

TEST(Edits, AMomentTakesTheMemoryOfItsScenesPushesAndTextToo) {
  Scene scene = tickingSheet();
  const std::size_t few = Simulation(scene, findMethod("leapfrog")).save().bytes();
  scene.pushes.resize(1000, {.particle = Place{.name = "middle"}, .force = {0, 1, 0}, .at = 1, .duration = 1});
  EXPECT_GT(Simulation(scene, findMethod("leapfrog")).save().bytes(), few + 100000);
}

TEST(Edits, ManyTicksAlarmWhereSingleOnesDo) {
  Scene scene = tickingSheet();
  scene.dt = 0.25;
  const Method& method = findMethod("leapfrog");
  Simulation single(scene, method), batch(scene, method);
  tick(single, 1000), batch.tick(1000);
  EXPECT_NE(single.status(), Status::Ok);
  EXPECT_EQ(batch.status(), single.status());
  EXPECT_EQ(batch.alarmTime(), single.alarmTime());
  EXPECT_EQ(batch.ticks(), single.ticks());
}

}  // namespace
}  // namespace tyg::test
