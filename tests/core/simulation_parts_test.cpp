// The parts of a simulation, each on its own: clock, replay, energy watch, live parameters.
#include <gtest/gtest.h>

#include <cmath>

#include "core/forces/parameter.h"
#include "core/simulation/energy_watch.h"
#include "core/simulation/live_parameters.h"
#include "core/simulation/replay.h"
#include "core/simulation/tick_clock.h"
#include "test_systems.h"
#include "tyg/methods.h"

namespace tyg::test {
namespace {

TEST(TickClock, TellsTheEndOfATickFromTheStartAndNotFromASumOfTicks) {
  TickClock clock(0.1);
  for (int tick = 0; tick < 1000; ++tick) clock.moveTo(clock.tickEnd()), clock.endTicks(1);
  EXPECT_EQ(clock.time(), 1000 * 0.1);
  EXPECT_EQ(clock.ticks(), 1000);
  EXPECT_EQ(clock.tickEnd(9), 1010 * 0.1);
}

TEST(TickClock, CountsFromThePresentTimeAfterAnotherStepOrAStopWithinATick) {
  TickClock clock(0.5);
  clock.moveTo(0.5), clock.endTicks(1);
  clock.useStep(0.25);
  EXPECT_EQ(clock.tickEnd(), 0.75);
  clock.moveTo(0.625);
  EXPECT_EQ(clock.tickEnd(), 0.75);
  clock.startTicksHere();
  EXPECT_EQ(clock.tickEnd(), 0.875);
  EXPECT_EQ(clock.ticks(), 1);
}

TEST(Replay, HandsOutEachEventOnceWhenItsTickHasCome) {
  const Event push{3, PushEvent{}}, step{3, StepEvent{0.5}}, last{9, StepEvent{0.25}};
  Replay replay({push, step, last}, {});
  EXPECT_EQ(replay.takeDue(2), nullptr);
  EXPECT_EQ(replay.ticksToNext(1, 100), 2);
  EXPECT_EQ(*replay.takeDue(3), push);
  const Replay copy = replay;
  EXPECT_EQ(*replay.takeDue(3), step);
  EXPECT_EQ(*Replay(copy).takeDue(3), step);
  EXPECT_EQ(replay.takeDue(8), nullptr);
  EXPECT_EQ(replay.ticksToNext(8, 100), 1);
  EXPECT_EQ(*replay.takeDue(20), last);
  EXPECT_EQ(replay.takeDue(20), nullptr);
  EXPECT_EQ(replay.ticksToNext(20, 100), 100);
}

TEST(Replay, RefusesAMethodThatIsNotAmongThoseGiven) {
  EXPECT_NO_THROW(Replay({{0, MethodEvent{"rk4"}}}, methods()));
  EXPECT_THROW(Replay({{0, MethodEvent{"rk5"}}}, methods()), InputError);
}

/// A watch of a sheet at rest, whose scale is the energy of a hundredth of stretch.
EnergyWatch quietWatch(bool followsLedger, int order = 1) {
  const Scene scene = softSheet(Damping::Relative);
  return {scene, makeSheet(scene), {}, order, followsLedger};
}

StoredEnergy elastic(double joules) {
  StoredEnergy energy;
  energy.of<StructuralSprings>() = joules;
  return energy;
}

TEST(EnergyWatch, KeepsTheFirstAlarmAndItsTime) {
  EnergyWatch watch = quietWatch(false);
  watch.check({});
  EXPECT_EQ(watch.status(), Status::Ok);
  EXPECT_TRUE(std::isnan(watch.alarmTime()));
  const double large = watch.ledger({}).scale;
  watch.check({.stored = elastic(large), .time = 2});
  watch.check({.stored = elastic(NAN), .time = 3});
  watch.check({.time = 4});
  EXPECT_EQ(watch.status(), Status::NotFinite);
  EXPECT_EQ(watch.alarmTime(), 2);
}

TEST(EnergyWatch, AllowsALowOrderMoreThanAHighOne) {
  for (const int order : {1, 2, 3, 5}) {
    EnergyWatch watch = quietWatch(false, order);
    const double large = watch.ledger({}).scale;
    watch.check({.stored = elastic(large / 33), .time = 1});
    EXPECT_EQ(watch.status(), Status::Ok) << order;
    watch.check({.stored = elastic(large / 31), .time = 2});
    EXPECT_EQ(watch.status(), order < 3 ? Status::Ok : Status::Unstable) << order;
    watch.check({.stored = elastic(large / 3.9), .time = 3});
    EXPECT_EQ(watch.status(), Status::Unstable) << order;
  }
}

TEST(EnergyWatch, DoesNotBlameAMethodForTheRisesOfTheOneBefore) {
  EnergyWatch watch = quietWatch(false, 1);
  const double large = watch.ledger({}).scale;
  watch.check({.stored = elastic(large / 5), .time = 1});
  watch.useOrder(4);
  watch.check({.stored = elastic(large / 5), .time = 2});
  EXPECT_EQ(watch.status(), Status::Ok);
  watch.check({.stored = elastic(large / 4), .time = 3});
  EXPECT_EQ(watch.status(), Status::Unstable);
}

TEST(EnergyWatch, ForgetsWhatDampingTookLongAgo) {
  for (const bool isMore : {false, true}) {
    EnergyWatch watch = quietWatch(false);
    const double large = watch.ledger({}).scale;
    // Damping takes a fifth of the scale in as many checks as are remembered, and the stored energy hardly falls.
    const double power = (isMore ? 1.5 : 1) * large / (5 * Alarm::kMemory), fall = 1e-6 * large;
    for (int check = 1; check <= 100; ++check) {
      for (int step = 0; step < 4 && watch.suspects(); ++step) watch.sample(power);
      watch.lose(power, check, Alarm::Taken::AsMuch);
      watch.check({.stored = elastic(-fall * check), .time = double(check)});
    }
    EXPECT_EQ(watch.status(), isMore ? Status::Unstable : Status::Ok);
  }
}

TEST(EnergyWatch, DoesNotBelieveTheLossOfBlowsThatTheChecksHappenToMeet) {
  for (const bool lasts : {false, true}) {
    EnergyWatch watch = quietWatch(false);
    const double large = watch.ledger({}).scale, power = large / 3, fall = 1e-6 * large;
    bool suspected = false;
    for (int check = 1; check <= 100; ++check) {
      for (int step = 1; step <= 8 && watch.suspects(); ++step) watch.sample(lasts || step == 8 ? power : 0);
      watch.lose(power, check, Alarm::Taken::AsMuch);
      watch.check({.stored = elastic(-fall * check), .time = double(check)});
      suspected = suspected || watch.suspects();
    }
    EXPECT_TRUE(suspected);
    EXPECT_EQ(watch.status(), lasts ? Status::Unstable : Status::Ok);
  }
}

/// A second between two checks, and steps whose power is told where it is asked for.
struct Checks {
  int order = 2;
  double power = 0;    ///< W, that damping takes at the checks
  double sampled = 0;  ///< W, after each step
  double fall = 0;     ///< J, of the stored energy from check to check
  int pause = 0;       ///< the check that the stored energy falls by all of `power`
  Alarm::Taken taken = Alarm::Taken::AsMuch;
};

/// The check that raises the alarm; 0: none of a hundred.
int raisedAt(const Checks& checks) {
  EnergyWatch watch = quietWatch(false, checks.order);
  double stored = 0;
  for (int check = 1; check <= 100; ++check) {
    for (int step = 0; step < 4 && watch.suspects(); ++step) watch.sample(checks.sampled);
    watch.lose(checks.power, check, checks.taken);
    stored -= check == checks.pause ? checks.power : checks.fall;
    watch.check({.stored = elastic(stored), .time = double(check)});
    if (watch.status() != Status::Ok) return check;
  }
  return 0;
}

TEST(EnergyWatch, HearsASteadyRiseThatDampingHides) {
  const double large = quietWatch(false).ledger({}).scale, rise = 1.1 * Alarm::kSteadyRise * large, power = large / 10;
  // The first check has none before it, and the rise to the second one is estimated.
  constexpr int kFirst = 2 + Alarm::kSteadyChecks;
  const Checks steady{.power = power, .sampled = power, .fall = power - rise};
  EXPECT_EQ(raisedAt(steady), kFirst);
  const auto but = [&](const auto& change) {
    Checks checks = steady;
    change(checks);
    return raisedAt(checks);
  };
  EXPECT_EQ(but([&](Checks& c) { c.fall = power - 0.8 * rise; }), 0) << "it is too small";
  EXPECT_EQ(but([&](Checks& c) { c.sampled = power + Alarm::kThreshold * large; }), 0) << "it is too large";
  EXPECT_EQ(but([&](Checks& c) { c.order = 1; }), 0) << "a method of order 1 is not that exact";
  EXPECT_EQ(but([&](Checks& c) { c.pause = kFirst - 1; }), 2 * kFirst - 2) << "it begins anew";
  EXPECT_EQ(but([&](Checks& c) { c.sampled = power - rise; }), 0) << "it is estimated alone";
  EXPECT_EQ(but([&](Checks& c) { c.taken = Alarm::Taken::Less; }), 0) << "damping may take less";
  EXPECT_EQ(but([&](Checks& c) { c.taken = Alarm::Taken::Unknown; }), 0) << "the loss is not known";
}

TEST(EnergyWatch, BelievesARiseThatIsMostOfTheLossWhereDampingMayTakeLess) {
  const double large = quietWatch(false).ledger({}).scale, least = Alarm::kSteadyRiseOfLess * large;
  constexpr int kFirst = 2 + Alarm::kSteadyChecks;
  const auto at = [&](double power, double rise) {
    return raisedAt({.power = power, .sampled = power, .fall = power - rise, .taken = Alarm::Taken::Less});
  };
  EXPECT_EQ(at(1.5 * least, 1.1 * least), kFirst);
  EXPECT_EQ(at(1.5 * least, 0.9 * least), 0) << "it is too small";
  EXPECT_EQ(at(3 * least, 1.1 * least), 0) << "it may be the method's error";
}

TEST(EnergyWatch, AsksWhereTheLossIsThatDampingTook) {
  const double large = quietWatch(false).ledger({}).scale;
  constexpr int kFirst = 1 + Alarm::kSteadyChecks;  // the first check has none before it
  const auto at = [&](int order, double power, double fall, Alarm::Taken taken = Alarm::Taken::AsMuch) {
    return raisedAt(
        {.order = order, .power = power * large, .sampled = power * large, .fall = fall * large, .taken = taken});
  };
  const double least = Alarm::kLeastLoss, leastOfLow = Alarm::kLeastLossOfLowOrder;
  for (const Alarm::Taken taken : {Alarm::Taken::AsMuch, Alarm::Taken::Less}) {
    EXPECT_EQ(at(3, 1.1 * least, 0, taken), kFirst);
    for (const int order : {1, 2}) EXPECT_EQ(at(order, 1.1 * leastOfLow, 0, taken), kFirst);
  }
  EXPECT_EQ(at(3, 0.9 * least, 0), 0) << "it is too small";
  for (const int order : {1, 2}) EXPECT_EQ(at(order, 0.9 * leastOfLow, 0), 0) << "it is too small";
  EXPECT_EQ(at(3, 1.1 * least, 1e-6), 0) << "some of it is missing";
  EXPECT_EQ(at(3, 1.1 * least, 0, Alarm::Taken::Unknown), 0) << "it is not known";
}

/// A first-order method's energy swings by itself, and may be where it was eight checks before.
TEST(EnergyWatch, LetsTheEnergyOfAFirstOrderMethodSwing) {
  for (const int order : {1, 2}) {
    EnergyWatch watch = quietWatch(false, order);
    const double large = watch.ledger({}).scale, power = 2 * Alarm::kLeastLossOfLowOrder * large;
    for (int check = 1; check <= 20; ++check) {
      watch.lose(power, check, Alarm::Taken::AsMuch);
      watch.check({.stored = elastic(check % 4 == 0 ? -power : 0), .time = double(check)});
    }
    EXPECT_EQ(watch.status(), order == 1 ? Status::Ok : Status::Unstable);
  }
}

/// What another method has stored at the checks before is not compared with.
TEST(EnergyWatch, CountsAMissingLossFromWhereTheMethodSteps) {
  EnergyWatch watch = quietWatch(false, 3);
  const double large = watch.ledger({}).scale, power = 2 * Alarm::kLeastLoss * large;
  for (int check = 1; check <= 12; ++check) {
    if (check == 7) watch.useOrder(4);
    watch.lose(power, check, Alarm::Taken::AsMuch);
    watch.check({.time = double(check)});
  }
  EXPECT_EQ(watch.status(), Status::Ok);
}

TEST(EnergyWatch, CountsTheDriftFromWhereTheLedgerIsFollowed) {
  EnergyWatch watch = quietWatch(false);
  const double scale = watch.ledger({}).scale;
  const EnergySample now{.stored = {.kinetic = 0.1 * scale}, .pushes = 0.05 * scale};
  EXPECT_EQ(watch.ledger(now).drift, 0);
  watch.followLedger(true, now);
  EXPECT_EQ(watch.ledger(now).drift, 0);
  EnergySample later = now;
  later.stored.kinetic -= 0.04 * scale, later.passed.lost += 0.03 * scale;
  const Ledger ledger = watch.ledger(later);
  constexpr double kRounding = 1e-12;
  EXPECT_NEAR(ledger.drift * ledger.scale, -0.01 * scale, kRounding * scale);
}

TEST(EnergyWatch, AfterOtherLiveParametersWhatIsStoredCountsAnew) {
  const Scene scene = softSheet(Damping::Relative);
  EnergyWatch watch = quietWatch(false);
  StoredEnergy stored = elastic(1e6), start;
  stored.of<Gravity>() = start.of<Gravity>() = 7;
  watch.begin(scene, makeSheet(scene), start, stored);
  EXPECT_EQ(watch.mechanical(stored), 1e6);
  watch.check({.stored = stored});
  EXPECT_EQ(watch.status(), Status::Ok);
}

TEST(LiveParameters, ChangesTurnOneSceneIntoTheOther) {
  Scene from = softSheet(Damping::Relative);
  from.bodies.resize(6);
  Scene to = from;
  for (const Parameter& parameter : liveParameters()) {
    const Vec3 old = parameter.get(from);
    parameter.set(to, {old.x + 1, old.y, old.z});
    EXPECT_FALSE(sameLiveParameters(from, to)) << parameter.key;
    Scene built = from;
    for (const WorldEvent& change : changesBetween(from, to)) findParameter(change.parameter)->set(built, change.value);
    EXPECT_EQ(built, to) << parameter.key;
  }
  EXPECT_EQ(changesBetween(from, to).size(), liveParameters().size());
  Scene copied = from;
  copyLiveParameters(to, copied);
  EXPECT_TRUE(sameLiveParameters(copied, to));
  setLiveValues(copied, liveValues(from));
  EXPECT_EQ(copied, from);
}

}  // namespace
}  // namespace tyg::test
