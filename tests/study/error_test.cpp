// The error measure, on made-up motions whose distance is known, and the times at which motions are compared.
#include "study/motion/error.h"

#include <gtest/gtest.h>

#include <cmath>

#include "test_systems.h"
#include "tyg/methods.h"

namespace tyg::test {
namespace {

/// Four particles at two times, all where they started.
SampledMotion still() {
  SampledMotion motion;
  motion.times = {1, 2};
  motion.positions.assign(2, {{0, 0, 0}, {1, 0, 0}, {0, -1, 0}, {1, -1, 0}});
  return motion;
}

TEST(Error, OfASheetShiftedAsAWholeIsTheShift) {
  SampledMotion moved = still();
  for (Vec3& at : moved.positions[1]) at = at + Vec3{3, 4, 0};
  const Distance error = motionError(moved, still());
  EXPECT_DOUBLE_EQ(error.rms, 5);
  EXPECT_DOUBLE_EQ(error.largest, 5);
}

TEST(Error, OfOneStrayParticleIsSharedOutAsARootMeanSquare) {
  SampledMotion moved = still();
  moved.positions[0][2].z = 2;
  const Distance error = motionError(moved, still());
  EXPECT_DOUBLE_EQ(error.rms, 1);  // sqrt(2^2 / 4)
  EXPECT_DOUBLE_EQ(error.largest, 2);
}

TEST(Error, IsTheLargestOverTheSampleTimesOfEachDistanceByItself) {
  SampledMotion moved = still();
  moved.positions[0][1].x += 0.4;                                 // rms 0.2, largest 0.4
  for (Vec3& at : moved.positions[1]) at = at + Vec3{0, 0, 0.3};  // rms 0.3, largest 0.3
  const Distance error = motionError(moved, still());
  EXPECT_DOUBLE_EQ(error.rms, 0.3);
  EXPECT_DOUBLE_EQ(error.largest, 0.4);
}

TEST(Error, OfAMotionThatEndedEarlyIsUnknown) {
  SampledMotion moved = still();
  moved.positions.pop_back();
  EXPECT_TRUE(std::isnan(motionError(moved, still()).rms));
}

TEST(Error, OfFreeFallByTheSymplecticEulerMethodIsHalfAStepOfSpeed) {
  // After n steps it stands at g h^2 n (n + 1) / 2, the truth is at g (n h)^2 / 2: ahead by g h t / 2.
  Scene scene = freeFall();
  scene.dt = 0.05;
  const std::vector<double> times{0.5, 1};
  SampledMotion truth;
  for (const double t : times) truth.positions.push_back({{0, -9.81 * t * t / 2, 0}});
  const SampledMotion run = sampledRun(scene, findMethod("symplectic-euler"), times);
  EXPECT_NEAR(motionError(run, truth).rms, 9.81 * 0.05 * 1 / 2, 1e-12);
}

TEST(SampleTimes, AreTwentyWhereNothingPushes) {
  Scene scene = freeFall();
  scene.duration = 3;
  const std::vector<double> times = sampleTimes(scene);
  ASSERT_EQ(times.size(), 20U);
  EXPECT_DOUBLE_EQ(times[0], 0.15);
  EXPECT_EQ(times.back(), 3);
}

TEST(SampleTimes, FallOnTheEdgesOfPushes) {
  Scene scene = freeFall();
  scene.duration = 3;
  scene.pushes = {{{"top-left"}, {1, 0, 0}, 0.1, 0.3}, {{"top-left"}, {1, 0, 0}, 0.6, 0.3}};
  EXPECT_EQ(sampleTimes(scene).size(), 30U);
}

TEST(SampleTimes, AreTwentyWhereNoNumberOfThemMeetsAPush) {
  Scene scene = freeFall();
  scene.duration = 1;
  scene.pushes = {{{"top-left"}, {1, 0, 0}, std::sqrt(0.5), 0.1}};
  EXPECT_EQ(sampleTimes(scene).size(), 20U);
}

}  // namespace
}  // namespace tyg::test
