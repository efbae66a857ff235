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

/// What is slow after a second of such frames, of which so much went into simulating, s.
Pace::Slow slowOf(PaceMeter& meter, double frame, double simulating) {
  const FrameClock clock(0.002);
  for (double time = 0; time < 1.5; time += frame) meter.measure(frame, simulating, clock);
  return meter.pace().slow;
}

TEST(PaceMeter, SaysWhetherDrawingOrSimulatingMakesFramesLate) {
  PaceMeter meter;
  EXPECT_EQ(slowOf(meter, kFrame, 0.9 * kFrame), Pace::Slow::Nothing) << "all in time";
  EXPECT_EQ(slowOf(meter, 0.1, 0.01), Pace::Slow::Drawing);
  EXPECT_EQ(slowOf(meter, 0.1, 0.09), Pace::Slow::Simulating);
  EXPECT_EQ(slowOf(meter, kFrame, 0.01), Pace::Slow::Nothing);
}

TEST(PaceMeter, DoesNotFlutterWhereFramesAreJustInTime) {
  PaceMeter meter;
  EXPECT_EQ(slowOf(meter, 1 / 21.5, 0), Pace::Slow::Nothing);
  EXPECT_EQ(slowOf(meter, 1 / 15.0, 0), Pace::Slow::Drawing);
  EXPECT_EQ(slowOf(meter, 1 / 21.5, 0), Pace::Slow::Drawing) << "until they are clearly in time";
  EXPECT_EQ(slowOf(meter, 1 / 30.0, 0), Pace::Slow::Nothing);
}

TEST(PaceMeter, SaysThatSimulatingIsSlowWhereTimeFallsBehindAtQuickFrames) {
  FrameClock clock(0.0001);
  PaceMeter meter;
  for (int frame = 0; frame < 120; ++frame) {
    clock.ran(clock.due(kFrame) / 3);
    meter.measure(kFrame, 0.7 * kFrame, clock);
  }
  EXPECT_EQ(meter.pace().slow, Pace::Slow::Simulating);
}

}  // namespace
}  // namespace tyg
