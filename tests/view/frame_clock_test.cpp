// The fixed tick: the same states at every frame rate, and what happens when the machine is too slow.
#include "view/frame_clock.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace tyg {
namespace {

long ticksAfter(FrameClock& clock, double framesPerSecond, int seconds) {
  long ticks = 0;
  for (int frame = 0; frame < static_cast<int>(framesPerSecond) * seconds; ++frame) {
    const int due = clock.due(1 / framesPerSecond);
    clock.ran(due);
    ticks += due;
  }
  return ticks;
}

TEST(FrameClock, GivesTheSameTicksAtThirtySixtyAndOneHundredFortyFourFrames) {
  for (const double tick : {0.002, 0.001, 0.0007, 0.03}) {
    for (const int seconds : {1, 7, 60}) {
      FrameClock slow(tick), usual(tick), fast(tick);
      const long expected = std::lround(std::floor(seconds / tick + 1e-6));
      EXPECT_EQ(ticksAfter(slow, 30, seconds), expected);
      EXPECT_EQ(ticksAfter(usual, 60, seconds), expected);
      EXPECT_EQ(ticksAfter(fast, 144, seconds), expected);
    }
  }
}

TEST(FrameClock, FiveFramesASecondLoseNoTime) {
  FrameClock clock(0.001);
  EXPECT_EQ(ticksAfter(clock, 5, 10), 10000);
  EXPECT_FALSE(clock.behind());
}

TEST(FrameClock, SlowMotionRunsAQuarterOfTheTicks) {
  FrameClock clock(0.001);
  clock.setSpeed(0.25);
  EXPECT_EQ(ticksAfter(clock, 60, 4), 1000);
  EXPECT_FALSE(clock.behind());
}

TEST(FrameClock, DropsTimeAfterALongPause) {
  FrameClock clock(0.001);
  EXPECT_EQ(clock.due(30), 250);
  clock.ran(250);
  EXPECT_EQ(clock.due(0.010), 10) << "the pause must not be caught up later";
}

TEST(FrameClock, SaysHowSlowAMachineIsThatRunsAThirdOfWhatIsDue) {
  constexpr double kSmoothed = 0.02;  // what is left of the start after ten smoothing times, and whole ticks
  FrameClock clock(0.0001);
  for (int frame = 0; frame < 300; ++frame) clock.ran(clock.due(1.0 / 60) / 3);
  EXPECT_NEAR(clock.realTimeFactor(), 1.0 / 3, kSmoothed);
  EXPECT_TRUE(clock.behind());
  clock.restart();
  EXPECT_FALSE(clock.behind());
}

TEST(FrameClock, TakesStrangeTimesAsNothing) {
  FrameClock clock(0.001);
  EXPECT_EQ(clock.due(-1), 0);
  EXPECT_EQ(clock.due(std::numeric_limits<double>::quiet_NaN()), 0);
  EXPECT_EQ(clock.due(std::numeric_limits<double>::infinity()), 0);
  EXPECT_EQ(clock.due(0.005), 5);
}

TEST(FrameClock, ATickLongerThanTheCapStillComes) {
  FrameClock clock(0.5);
  EXPECT_EQ(ticksAfter(clock, 60, 10), 20);
}

TEST(FrameClock, RefusesTicksAndSpeedsThatAreNotPositive) {
  EXPECT_THROW(FrameClock(0), std::invalid_argument);
  FrameClock clock(0.001);
  EXPECT_THROW(clock.setTick(std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
  EXPECT_THROW(clock.setSpeed(-1), std::invalid_argument);
}

}  // namespace
}  // namespace tyg
