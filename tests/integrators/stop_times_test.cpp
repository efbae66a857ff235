// Times that must be met exactly: the end, the edges of pushes, and what is asked for in between.
#include <gtest/gtest.h>

#include "test_systems.h"
#include "tyg/methods.h"
#include "tyg/simulation.h"

namespace tyg::test {
namespace {

TEST(StopTimes, AreMetExactlyInStepsOfAtMostDt) {
  Scene scene = softSheet(Damping::Relative);
  scene.dt = 0.01;
  for (const Method& method : methods()) {
    Simulation simulation(scene, method);
    for (const double time : {0.0001, 0.01, 1.0 / 3, 0.5, 0.500000001, 0.77}) {
      simulation.advanceTo(time);
      EXPECT_EQ(simulation.time(), time) << method.name;
    }
    if (!method.adaptive) {
      EXPECT_LE(simulation.largestStep(), scene.dt * (1 + 1e-9)) << method.name;
    }
  }
}

TEST(StopTimes, OfAWholeNumberOfStepsTakeExactlyThatNumber) {
  Scene scene = softSheet(Damping::Relative);
  for (const double dt : {0.1, 0.01, 0.003, 1.0 / 3}) {
    scene.dt = dt;
    Simulation simulation(scene, findMethod("leapfrog"));
    simulation.advanceTo(30 * dt);
    EXPECT_EQ(simulation.steps(), 30) << dt;
    EXPECT_NEAR(simulation.largestStep(), dt, 1e-12 * dt);
  }
}

TEST(StopTimes, ThatCouldNotBeReachedAreRefusedWithANumberThatPeopleCanRead) {
  Scene scene = emptyWorld(1, 1);
  scene.dt = 1e-300;
  Simulation simulation(scene, findMethod("rk4"));
  EXPECT_EQ(messageOf([&] { simulation.advanceTo(1); }),
            "dt: found 1e+300 steps to the next stop, allowed: up to 1e15");
}

TEST(StopTimes, NotAMultipleOfDtAreReachedInEqualSmallerSteps) {
  Scene scene = softSheet(Damping::Relative);
  scene.dt = 0.3;
  Simulation simulation(scene, findMethod("symplectic-euler"));
  simulation.advanceTo(1);
  EXPECT_EQ(simulation.steps(), 4);
  EXPECT_DOUBLE_EQ(simulation.largestStep(), 0.25);
}

TEST(StopTimes, CloserThanABillionthOfAStepAreOne) {
  Scene scene = emptyWorld(1, 1);
  scene.dt = 0.01;
  scene.pushes = {{{"middle"}, {1, 0, 0}, 0.05, 0.05}, {{"middle"}, {1, 0, 0}, 0.05 + 1e-13, 0.05}};
  Simulation simulation(scene, findMethod("rk4"));
  simulation.advanceTo(0.2);
  EXPECT_EQ(simulation.steps(), 20);
  EXPECT_NEAR(simulation.velocity(0).x, 2 * 0.05, 1e-12);
}

TEST(StopTimes, OfPushesGiveTheExactImpulseWhateverTheStep) {
  Scene scene = emptyWorld(1, 1);
  scene.particleMass = 2;
  scene.pushes = {{{"middle"}, {3, 0, 0}, 0.123, 0.456}};
  for (const Method& method : methods()) {
    for (const double dt : {0.01, 0.1, 1.0}) {
      scene.dt = dt;
      Simulation simulation(scene, method);
      simulation.advanceTo(1);
      if (method.name == "report-rk4") continue;  // its impulse is the report's own, h (1 + h/2 + ...)
      EXPECT_NEAR(simulation.velocity(0).x, 3 * 0.456 / 2, 1e-14) << method.name << " " << dt;
    }
  }
}

TEST(StopTimes, ThatNoToleranceWouldEverReachEndTheRunWhereItIs) {
  for (const char* name : {"bs32", "dopri54"}) {
    Scene scene = softSheet(Damping::Relative);
    scene.tolerance = 1e-300;
    Simulation precise(scene, findMethod(name), {.keepGoing = true});
    precise.advanceTo(1);
    EXPECT_LT(precise.time(), 1e-9) << name;
    EXPECT_EQ(precise.status(), Status::NotFinite) << name;
    EXPECT_EQ(precise.alarmTime(), precise.time()) << name;

    scene = oscillator(100, 1);
    scene.columns = scene.rows = 2, scene.pins = {};
    scene.precision = Precision::Float;
    scene.tolerance = 1e-4;
    scene.displacements = {{{"top-left"}, {1e30, 0, 0}}};
    Simulation far(scene, findMethod(name));
    far.advanceTo(1);
    EXPECT_EQ(far.status(), Status::NotFinite) << name;
  }
}

TEST(StopTimes, OfSamplesDoNotResetAMethod) {
  Scene scene = softSheet(Damping::Relative);
  scene.dt = 1.0 / 64;
  scene.tolerance = 0;
  for (const Method& method : methods()) {
    Simulation straight(scene, method), sampled(scene, method);
    straight.advanceTo(1);
    for (int n = 1; n <= 16; ++n) sampled.advanceTo(n / 16.0);
    EXPECT_EQ(straight.hash(), sampled.hash()) << method.name;
    EXPECT_EQ(straight.forceEvaluations(), sampled.forceEvaluations()) << method.name;
  }
}

TEST(StopTimes, ATickIsCutWhereAPushBeginsAndEndsInsideIt) {
  Scene scene = emptyWorld(1, 1);
  scene.dt = 0.25;
  scene.pushes = {{{"middle"}, {1, 0, 0}, 0.3, 0.1}};
  Simulation simulation(scene, findMethod("rk4"));
  for (int n = 1; n <= 4; ++n) {
    simulation.tick();
    EXPECT_EQ(simulation.time(), n * scene.dt);
  }
  EXPECT_EQ(simulation.steps(), 6);
  EXPECT_NEAR(simulation.velocity(0).x, 0.1, 1e-15);
  EXPECT_NEAR(simulation.position(0).x - simulation.sheet().startPosition(0).x, 0.1 * 0.05 + 0.6 * 0.1, 1e-15);
}

TEST(StopTimes, ManyTicksDoNotDrift) {
  Scene scene = emptyWorld(1, 1);
  scene.dt = 0.1;
  Simulation simulation(scene, findMethod("rk4"));
  for (int n = 0; n < 100000; ++n) simulation.tick();
  EXPECT_EQ(simulation.time(), 100000 * scene.dt);
}

TEST(StopTimes, AnObserverStopsARunEarly) {
  Scene scene = softSheet(Damping::Relative);
  scene.dt = 0.001;
  Simulation simulation(scene, findMethod("rk4"));
  int calls = 0;
  simulation.observe([&] { return ++calls < 3; });
  simulation.advanceTo(1);
  EXPECT_EQ(calls, 3);
  EXPECT_LT(simulation.time(), 0.5);
  simulation.observe(nullptr);
  simulation.advanceTo(1);
  EXPECT_EQ(simulation.time(), 1);
}

TEST(StopTimes, ADisplacementComesBeforeTheStart) {
  Scene scene = emptyWorld(2, 2);
  scene.displacements = {{{"bottom-left"}, {0.25, 0, -1}}};
  const Simulation simulation(scene, findMethod("rk4"));
  const Vec3 start = simulation.sheet().startPosition(2);
  EXPECT_EQ(simulation.position(2), start + (Vec3{0.25, 0, -1}));
  EXPECT_EQ(simulation.position(3), simulation.sheet().startPosition(3));
}

}  // namespace
}  // namespace tyg::test
