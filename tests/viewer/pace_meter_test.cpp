// How fast frames come: smoothed, and not misled by a rest.
#include "viewer/pace_meter.h"

#include <gtest/gtest.h>

namespace tyg {
namespace {

constexpr double kFrame = 1.0 / 60;
constexpr double kRounding = 1e-9;

TEST(PaceMeter, TellsTheRateAndTheShareOfEvenFrames) {
  const FrameClock clock(0.002);
  PaceMeter meter;
  EXPECT_EQ(meter.pace().framesPerSecond, 0);
  for (int frame = 0; frame < 60; ++frame) meter.measure(kFrame, 0.25 * kFrame, clock);
  EXPECT_NEAR(meter.pace().framesPerSecond, 60, 60 * kRounding);
  EXPECT_NEAR(meter.pace().simulating, 0.25, kRounding);
  EXPECT_NEAR(meter.otherSeconds(), 0.75 * kFrame, kRounding);
}

TEST(PaceMeter, FollowsAChangeWithinAboutASecond) {
  const FrameClock clock(0.002);
  PaceMeter meter;
  meter.measure(kFrame, 0, clock);
  meter.measure(2 * kFrame, 0, clock);
  EXPECT_GT(meter.pace().framesPerSecond, 50) << "one slow frame is not a slow machine";
  for (int frame = 0; frame < 60; ++frame) meter.measure(2 * kFrame, 0, clock);
  EXPECT_NEAR(meter.pace().framesPerSecond, 30, 1);
}

TEST(PaceMeter, LeavesOutAFrameAfterARest) {
  const FrameClock clock(0.002);
  PaceMeter meter;
  meter.measure(kFrame, 0, clock);
  meter.measure(20, 0, clock);
  EXPECT_NEAR(meter.pace().framesPerSecond, 60, 60 * kRounding);
}

}  // namespace
}  // namespace tyg
