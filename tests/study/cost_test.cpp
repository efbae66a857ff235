// Prices of work, by a clock that runs with the work itself.
#include "study/work/cost.h"

#include <gtest/gtest.h>

#include "study/motion/resampled.h"
#include "test_systems.h"
#include "tyg/methods.h"

namespace tyg::test {
namespace {

Scene sheetFor(const std::string& method) {
  Scene scene = softSheet(Damping::Relative);
  scene.integrator = method;
  scene.dt = 1e-3;
  return scene;
}

/// A clock that is read once at the start, once at each energy check, every 64 steps, and once at the end of a burst.
CostMeter::Clock ticking(double tick) {
  return [now = 0.0, tick](int) mutable { return now += tick; };
}

TEST(CostMeter, GivesTheSameAnswerToTheSameQuestion) {
  CostMeter meter(sheetFor("rk4"), 1, ticking(1e-3));
  const double first = meter.secondsPerUnit(sheetFor("leapfrog"), 1);
  EXPECT_GT(first, 0);
  Scene other = sheetFor("leapfrog");
  other.dt = 5e-4;  // a shorter step of the same kind costs the same
  EXPECT_EQ(meter.secondsPerUnit(other, 1), first);
}

TEST(CostMeter, AStepThatTakesFourEvaluationsCostsFourTimesAsManyUnits) {
  // By this clock 64 steps take equally long whatever they do: a unit of rk4 then costs a quarter of one of leapfrog.
  constexpr double kStartEvaluation = 0.02;  // leapfrog makes one more, once
  CostMeter meter(sheetFor("rk4"), 1, ticking(1e-3));
  const double ratio = meter.secondsPerUnit(sheetFor("leapfrog"), 1) / meter.secondsPerUnit(sheetFor("rk4"), 1);
  EXPECT_NEAR(ratio, 4, 4 * kStartEvaluation);
}

TEST(CostMeter, MethodsWithoutForceEvaluationsArePricedByTheStep) {
  CostMeter meter(sheetFor("symplectic-euler"), 1, ticking(1e-3));
  const double step = meter.secondsPerUnit(sheetFor("symplectic-euler"), 1);
  EXPECT_NEAR(meter.secondsPerUnit(sheetFor("xpbd"), 1) / step, 1, 1e-9);
  SampledMotion run;
  run.steps = 10;
  EXPECT_EQ(workOf(findMethod("xpbd"), run), 10);
}

TEST(CostMeter, ADisturbedBurstDoesNotCount) {
  int calls = 0;
  double now = 0;
  // At every seventh reading another program has had the machine.
  CostMeter noisy(sheetFor("rk4"), 1, [&](int) { return now += ++calls % 7 == 0 ? 50e-3 : 1e-3; });
  CostMeter quiet(sheetFor("rk4"), 1, ticking(1e-3));
  const Scene scene = sheetFor("leapfrog");
  constexpr double kStartEvaluation = 0.02;  // the first burst has one more
  EXPECT_NEAR(noisy.secondsPerUnit(scene, 1) / quiet.secondsPerUnit(scene, 1), 1, kStartEvaluation);
}

TEST(Resampled, ASheetOnHalfItsGridComesBackBetweenItsParticles) {
  Scene fine = emptyWorld(5, 3), coarse = emptyWorld(3, 2);
  SampledMotion motion;
  motion.times = {1};
  motion.positions = {{{0, 0, 0}, {2, 0, 0}, {4, 0, 0}, {0, 2, 1}, {2, 2, 1}, {4, 2, 1}}};
  const SampledMotion all = resampled(motion, coarse, fine);
  ASSERT_EQ(all.positions[0].size(), 15U);
  EXPECT_EQ(all.positions[0][1], (Vec3{1, 0, 0}));
  EXPECT_EQ(all.positions[0][8], (Vec3{3, 1, 0.5}));
  EXPECT_EQ(all.positions[0][14], (Vec3{4, 2, 1}));
  const SampledMotion back = resampled(all, fine, coarse);
  EXPECT_EQ(back.positions, motion.positions);
}

TEST(Resampled, UpToATimeLeavesTheLaterSamplesOut) {
  SampledMotion motion;
  motion.times = {1, 2, 3};
  motion.positions.resize(3);
  EXPECT_EQ(upTo(2, motion).positions.size(), 2U);
  EXPECT_EQ(upTo(0.5, motion).times.size(), 0U);
}

}  // namespace
}  // namespace tyg::test
