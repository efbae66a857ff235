// The alarm at both sides of each method's limit: quiet below it, raised above it, in cloth that moves.
#include <gtest/gtest.h>

#include <random>

#include "core/simulation/alarm.h"
#include "random_cloth.h"
#include "study/limits/stability.h"
#include "test_systems.h"
#include "tyg/methods.h"
#include "tyg/simulation.h"

namespace tyg::test {
namespace {

constexpr double kBelow = 0.95;  // of the limit at rest

/// Where the alarm must go within the run. Explicit Euler's slowest waves grow slowly, and are longer than this sheet.
double above(const Method& method) { return method.name == "explicit-euler" ? 1.2 : 1.1; }

constexpr double kSeconds = 3;

/// A curtain that swings down and is poked.
Scene curtain(double kd) {
  Scene scene = emptyWorld(12, 10);
  scene.spacing = 0.1;
  scene.particleMass = 0.018;
  scene.start = Start::Flat;
  scene.pins = {{"top-left"}, {"top-right"}};
  scene.structural = {1200, kd};
  scene.shear = {900, kd};
  scene.bend = {200, kd};
  scene.gravity = {0, -9.81, 0};
  scene.pushes = {{{"middle"}, {0, 0, 2}, 0.5, 0.1}};
  scene.duration = kSeconds;
  scene.tolerance = 0;  // adaptive methods take steps of dt
  return scene;
}

struct Outcome {
  Status status;
  double at;  ///< s
};

Outcome outcome(Scene scene, const Method& method, double share) {
  scene.dt = share * restLatticeLimit(scene, method);
  Simulation simulation(scene, method);
  simulation.advanceTo(kSeconds);
  return {simulation.status(), simulation.alarmTime()};
}

bool hasLimit(const Scene& scene, const Method& method) { return restLatticeLimit(scene, method) > 0; }

TEST(Alarm, IsQuietJustBelowTheLimitOfEveryMethod) {
  for (const double kd : {0.1, 1.0}) {
    const Scene scene = curtain(kd);
    for (const Method& method : methods()) {
      if (!hasLimit(scene, method)) continue;
      EXPECT_EQ(outcome(scene, method, kBelow).status, Status::Ok) << method.name << " kd " << kd;
    }
  }
}

TEST(Alarm, IsRaisedJustAboveTheLimitOfEveryMethod) {
  for (const double kd : {0.1, 1.0}) {
    const Scene scene = curtain(kd);
    for (const Method& method : methods()) {
      if (!hasLimit(scene, method)) continue;
      EXPECT_NE(outcome(scene, method, above(method)).status, Status::Ok) << method.name << " kd " << kd;
    }
  }
}

TEST(Alarm, OfABadStepComesBeforeTheSheetHasLeftTheScreen) {
  Scene scene = curtain(0.1);
  for (const std::string_view name : {"symplectic-euler", "leapfrog", "rk4"}) {
    const Method& method = findMethod(name);
    scene.dt = 1.5 * restLatticeLimit(scene, method);
    Simulation simulation(scene, method);
    for (int frame = 0; frame < 180 && simulation.status() == Status::Ok; ++frame) {
      for (const double shown = simulation.time() + 1.0 / 60;
           simulation.time() < shown && simulation.status() == Status::Ok;) {
        simulation.tick();
      }
      if (simulation.check() != Status::Ok) break;  // the frame is not shown
      for (int i = 0; i < simulation.sheet().count(); ++i) ASSERT_LT(length(simulation.position(i)), 10) << name;
    }
    EXPECT_NE(simulation.status(), Status::Ok) << name;
  }
}

TEST(Alarm, StaysAndTellsWhen) {
  Scene scene = curtain(0.1);
  scene.dt = 1.3 * restLatticeLimit(scene, findMethod("leapfrog"));
  Simulation simulation(scene, findMethod("leapfrog"));
  EXPECT_TRUE(std::isnan(simulation.alarmTime()));
  simulation.advanceTo(kSeconds);
  ASSERT_NE(simulation.status(), Status::Ok);
  const double when = simulation.alarmTime();
  EXPECT_EQ(when, simulation.time()) << "it stood still there";
  EXPECT_LT(when, kSeconds);
  simulation.advanceTo(2 * kSeconds);
  EXPECT_EQ(simulation.alarmTime(), when);
  EXPECT_EQ(simulation.time(), when);
}

TEST(Alarm, MayBeRunPast) {
  Scene scene = curtain(0.1);
  scene.dt = 1.3 * restLatticeLimit(scene, findMethod("leapfrog"));
  Simulation simulation(scene, findMethod("leapfrog"), {.keepGoing = true});
  simulation.advanceTo(kSeconds);
  EXPECT_EQ(simulation.time(), kSeconds);
  EXPECT_NE(simulation.status(), Status::Ok);
  EXPECT_LT(simulation.alarmTime(), kSeconds);
}

TEST(Alarm, IsNotRaisedByPushesHoweverStrong) {
  Scene scene = curtain(0.1);
  scene.pushes = {{{"middle"}, {0, 0, 300}, 0.2, 0.2}, {{"bottom-left"}, {50, 200, 0}, 1, 0.5}};
  scene.dt = 1e-4;
  Simulation simulation(scene, findMethod("rk4"));
  simulation.advanceTo(2);
  EXPECT_EQ(simulation.status(), Status::Ok);
}

TEST(Alarm, HasAScaleThatDoesNotGrowForEverInAWind) {
  Scene scene = withSheet(loadScene("flutter"), 12, 8);
  scene.integrator = "leapfrog";
  const auto scaleAt = [&](double time) {
    Simulation simulation(scene, findMethod(scene.integrator));
    simulation.advanceTo(time);
    EXPECT_EQ(simulation.status(), Status::Ok);
    return simulation.ledger();
  };
  const Ledger early = scaleAt(2), late = scaleAt(20);
  EXPECT_GT(late.work["wind"], 8 * early.work["wind"]);
  EXPECT_LT(late.scale, 2 * early.scale);
}

/// A jitter past the limit whose energy damping takes as fast as the method brings it, in a wind that does the same.
TEST(Alarm, IsRaisedByAJitterInTheWindWhichItsDampingHolds) {
  Scene scene = curtain(0.6);
  scene.pushes.clear();
  scene.air = {1.2, 1.2};
  scene.winds = {{.velocity = {6, 0, 6}, .gust = {0, 0, 2}, .wavelength = 1}};
  const Method& method = findMethod("rk4");
  scene.dt = 0.9 * restLatticeLimit(scene, method);
  Simulation below(scene, method);
  below.advanceTo(kSeconds);
  EXPECT_EQ(below.status(), Status::Ok);
  scene.dt = 1.04 * restLatticeLimit(scene, method);
  Simulation above(scene, method);
  above.advanceTo(kSeconds);
  EXPECT_NE(above.status(), Status::Ok);
}

/// A jitter of a cloth that has fallen onto bodies: its energy is small beside that of the fall.
TEST(Alarm, IsRaisedByAJitterInContactWhichItsDampingHolds) {
  constexpr unsigned kSeed = 20;  // of a cloth whose jitter neither sum alone tells from a sound run
  const Method& method = findMethod("bs32");
  const double rest = restLatticeLimit(test::randomTouchingCloth(kSeed, 1), method);
  Scene scene = test::randomTouchingCloth(kSeed, 2000 * rest);
  scene.tolerance = 0;  // steps of dt
  for (const double share : {0.95, 1.05}) {
    scene.dt = share * rest;
    Simulation simulation(scene, method);
    simulation.advanceTo(scene.duration);
    EXPECT_EQ(simulation.status(), share < 1 ? Status::Ok : Status::Unstable) << share;
    const Ledger ledger = simulation.ledger();
    EXPECT_LT(ledger.storedRise, tyg::Alarm::kThresholdOfHighOrder) << share;
    EXPECT_LT(ledger.balanceRise, tyg::Alarm::kThreshold) << share;
  }
}

/// Jitters that neither sum tells.
TEST(Alarm, IsRaisedBySmallJitters) {
  struct Case {
    unsigned seed;
    const char* method;
    double above;  ///< of the limit at rest
  };
  for (const Case& jitter :
       {Case{124, "rk4", 1.05}, Case{46, "imex", 1.1}, Case{104, "rkc2", 1.1}, Case{43, "explicit-euler", 1.3}}) {
    const Method& method = findMethod(jitter.method);
    const double rest = restLatticeLimit(test::randomTouchingCloth(jitter.seed, 1), method);
    Scene scene = test::randomTouchingCloth(jitter.seed, 2000 * rest);
    for (const double share : {0.8, jitter.above}) {
      scene.dt = share * rest;
      Simulation simulation(scene, method);
      simulation.advanceTo(scene.duration);
      EXPECT_EQ(simulation.status(), share < 1 ? Status::Ok : Status::Unstable) << jitter.method << " " << share;
      const Ledger ledger = simulation.ledger();
      const double most = method.order >= 3 ? tyg::Alarm::kThresholdOfHighOrder : tyg::Alarm::kThreshold;
      EXPECT_LT(ledger.storedRise, most) << jitter.method << " " << share;
      EXPECT_LT(ledger.balanceRise, tyg::Alarm::kThreshold) << jitter.method << " " << share;
    }
  }
}

/// The energy of second-order methods swings by more than very light damping takes in eight checks.
TEST(Alarm, IsNotRaisedByTheSwingOfALightlyDampedCloth) {
  Scene scene = curtain(0);
  scene.pushes.clear();
  scene.bend = {};
  for (const double drag : {5e-5, 1e-4}) {
    scene.drag = drag;
    for (const char* name : {"leapfrog", "imex", "rk4"}) {
      scene.dt = 0.4 * restLatticeLimit(scene, findMethod(name));
      Simulation simulation(scene, findMethod(name));
      simulation.advanceTo(20);
      EXPECT_EQ(simulation.status(), Status::Ok) << name << " " << simulation.alarmTime() << " s";
    }
  }
}

/// Pins that are jerked 60 times a second in a strongly damped cloth: its checks meet the short blows of that.
TEST(Alarm, IsNotRaisedByPinsThatAreJerked) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    Scene scene = curtain(0.4);
    scene.pushes.clear();
    std::mt19937 random(seed);
    const auto speed = [&] { return double(random()) / double(std::mt19937::max()) * 2 - 1; };
    for (int k = 0; k < 120; ++k) {
      const Vec3 velocity{speed(), speed(), speed()};
      scene.moves.push_back({.what = {{"top-left"}}, .velocity = velocity, .at = 0.5 + k / 60.0, .duration = 1 / 60.0});
    }
    for (const char* name : {"leapfrog", "rk4"}) {
      scene.dt = 0.3 * restLatticeLimit(scene, findMethod(name));
      Simulation simulation(scene, findMethod(name));
      simulation.advanceTo(3);
      EXPECT_EQ(simulation.status(), Status::Ok) << name << " " << seed << " " << simulation.alarmTime() << " s";
    }
  }
}

TEST(Alarm, IsTheSameWhetherOrNotTheLedgerIsFollowed) {
  Scene scene = withSheet(loadScene("flag"), 8, 6);
  const Method& method = findMethod("rk4");
  for (const double share : {1.05, 1.12}) {
    scene.dt = share * restLatticeLimit(scene, method);
    Simulation without(scene, method), with(scene, method, {.ledger = true});
    without.advanceTo(2), with.advanceTo(2);
    EXPECT_NE(without.status(), Status::Ok) << share;
    EXPECT_EQ(without.alarmTime(), with.alarmTime()) << share;
  }
}

/// Between two energy checks a body may have hit and gone.
TEST(Alarm, IsNotRaisedByBlowsOfABodyThatMoves) {
  Scene scene = curtain(0.1);
  scene.pushes.clear(), scene.pins.clear();
  scene.bodies = {{.shape = Shape::Plane, .at = {0, -0.2, 0}, .name = "floor"}};
  scene.contact = {.stiffness = 2000, .layer = 0.01, .damping = 0.1};
  fillContact(scene);
  for (int k = 0; k < 5; ++k) scene.moves.push_back({{}, {0, k % 2 == 0 ? 3.0 : -3.0, 0}, 0.3 * k, 0.1, "floor"});
  for (const char* name : {"symplectic-euler", "leapfrog", "rk4"}) {
    scene.dt = 5e-4;
    Simulation simulation(scene, findMethod(name)), exact(scene, findMethod(name), {.ledger = true});
    simulation.advanceTo(2), exact.advanceTo(2);
    EXPECT_EQ(simulation.status(), Status::Ok) << name << " " << simulation.alarmTime();
    EXPECT_EQ(simulation.hash(), exact.hash()) << name;
    EXPECT_GT(std::abs(exact.ledger().work["bodies"]), 0.1 * exact.ledger().scale) << name;
    EXPECT_NEAR(simulation.ledger().work["bodies"] / exact.ledger().work["bodies"], 1, 1e-9) << name;
  }
}

/// A sheet that slides down a slope and bounces while it does: each of the first checks meets a bounce.
TEST(Alarm, IsNotRaisedWhereChecksMeetShortBlows) {
  Scene scene = emptyWorld(8, 8);
  scene.spacing = 0.1, scene.particleMass = 0.01;
  scene.start = Start::Flat;
  scene.structural = {50, 0.01}, scene.shear = {25, 0.01};
  scene.gravity = {9.81 * std::sin(0.35), -9.81 * std::cos(0.35), 0};
  scene.bodies = {{.shape = Shape::Plane, .at = {0, -0.0053, 0}}};
  scene.contact = {.stiffness = 500, .friction = 0.3, .grip = 1};
  fillContact(scene);
  scene.dt = 0.001;
  for (const char* name : {"leapfrog", "rk4"}) {
    Simulation simulation(scene, findMethod(name));
    simulation.advanceTo(1);
    EXPECT_EQ(simulation.status(), Status::Ok) << name << " " << simulation.alarmTime();
  }
}

TEST(Alarm, IsNotRaisedByTheFirstStepsOfAPushWithNothingElseToCompareThemTo) {
  Scene scene = emptyWorld(1, 1);
  scene.pushes = {{{"middle"}, {1, 0, 0}, 0, 1}};
  scene.dt = 0.1;
  for (const int steps : {1, 2, 3, 5}) {
    Simulation simulation(scene, findMethod("explicit-euler"));
    simulation.advanceTo(steps * scene.dt);
    EXPECT_EQ(simulation.check(), Status::Ok) << steps << " steps";
  }
}

TEST(Alarm, OfAMethodThatChoosesItsStepsTakesNoHeedOfAStepThatItDoesNotUse) {
  Scene scene = curtain(0.1);
  scene.tolerance = 1e-4;
  const auto ledger = [&](double dt) {
    scene.dt = dt;
    Simulation simulation(scene, findMethod("dopri54"), {.ledger = true});
    simulation.advanceTo(0.2);
    return simulation.ledger();
  };
  const Ledger small = ledger(0.002), large = ledger(100);
  EXPECT_EQ(large.drift, small.drift);
  EXPECT_EQ(large.storedRise, small.storedRise);
}

TEST(Alarm, IsNotRaisedByLookingOftenAtAFallThatDragSlows) {
  Scene scene = freeFall();
  scene.drag = 20;
  scene.dt = 0.002;
  Simulation simulation(scene, findMethod("rk4"), {.threads = 1});
  for (int frame = 1; frame <= 120; ++frame) simulation.advanceTo(frame / 60.0);
  EXPECT_EQ(simulation.status(), Status::Ok) << simulation.alarmTime() << " s";
}

}  // namespace
}  // namespace tyg::test
