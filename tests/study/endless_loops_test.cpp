// Searches end although what they compare is no number, and work that would never end is refused or cut.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "study/limits/measured_limit.h"
#include "study/limits/stability.h"
#include "study/limits/wave_search.h"
#include "study/motion/reference.h"
#include "study/work/cost.h"
#include "test_systems.h"
#include "tyg/methods.h"
#include "util/calibration_clock.h"

namespace tyg::test {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Scene dampedSheet(double kd) {
  Scene scene = emptyWorld(3, 3);
  scene.structural = {1000, kd};
  scene.shear = {900, kd};
  scene.bend = {200, kd};
  scene.particleMass = 0.01;
  return scene;
}

TEST(WaveSearch, EndsWhereTheFunctionIsNoNumber) {
  const Lattice lattice(dampedSheet(0.1));
  EXPECT_TRUE(std::isinf(lowestWave(lattice, [](double, double) { return kNaN; }).value));
  const LowestWave beside = lowestWave(lattice, [](double qx, double qy) { return qx > 2 ? kNaN : -qx - qy; });
  EXPECT_NEAR(beside.qx, 2, 1e-3);
  EXPECT_NEAR(beside.qy, 3.14159265, 1e-6);
}

TEST(Limits, OfScenesWithExtremeNumbersAreFoundForEveryMethod) {
  struct Case {
    double mass, ks, kd, drag;
  };
  for (const Case& one : {Case{0.01, 1000, 0, 1e-80}, Case{1e200, 1000, 0.1, 0.01}, Case{1e-310, 1000, 0.1, 0.01},
                          Case{1e-320, 1000, 0.1, 0.01}, Case{0.01, 1e308, 0.1, 0.01}, Case{0.01, 1000, 1e8, 0.01},
                          Case{1e30, 1e-30, 1e-30, 1e-30}, Case{1e-30, 1e30, 1e30, 1e30}}) {
    Scene scene = dampedSheet(one.kd);
    scene.particleMass = one.mass, scene.structural.ks = one.ks, scene.drag = one.drag;
    for (const Method& method : methods()) {
      for (const double limit : {restLatticeLimit(scene, method), certifiedLimit(scene, method)}) {
        EXPECT_TRUE(std::isnan(limit) || limit >= 0) << method.name << " " << limit;
      }
    }
  }
}

/// h (1 + h/2 + h^2/6 + h^3/24) is the step of symplectic Euler at its limit, however large that is.
TEST(Limits, OfTheReportsMethodHoldItsEquationForSoftSpringsToo) {
  const Method &report = findMethod("report-rk4"), &euler = findMethod("symplectic-euler");
  for (const double w2 : {1e8, 1.0, 1e-8, 1e-20, 1e-40, 1e-60}) {
    const double h = report.stableStep(w2, 0), taken = h * (1 + h / 2 + h * h / 6 + h * h * h / 24);
    EXPECT_NEAR(taken / euler.stableStep(w2, 0), 1, 1e-9) << w2;
  }
}

TEST(MeasuredLimit, IsUnknownWhereThereIsNoStepToBeginWith) {
  for (const double begin : {kNaN, 0.0, -1.0, std::numeric_limits<double>::infinity()}) {
    MeasurePlan plan;
    plan.begin = begin;
    EXPECT_TRUE(std::isnan(measuredLimit(dampedSheet(0.1), findMethod("rk4"), plan))) << begin;
  }
}

TEST(Reference, ThatNobodyCouldWaitForIsRefused) {
  Scene scene = dampedSheet(1e8);
  scene.name = "damped";
  const std::string refusal = messageOf([&] { (void)makeReference(scene, 1, {}); });
  EXPECT_EQ(refusal.find("damped: found springs, damping and mass that hold dopri54 to steps of "), 0U) << refusal;
  EXPECT_NO_THROW(refuseEndlessReference(dampedSheet(10)));
}

TEST(CostMeter, PricesAnAdaptiveMethodWhoseTickWouldTakeHours) {
  Scene scene = dampedSheet(1e8);
  scene.integrator = "bs32";
  scene.dt = 0.01;
  CostMeter meter(scene, 1, calibrationClock);
  const double price = meter.secondsPerUnit(scene, 1);
  EXPECT_GT(price, 0);
  EXPECT_LT(price, 1e-3);  // s, for one evaluation of nine particles
}

}  // namespace
}  // namespace tyg::test
