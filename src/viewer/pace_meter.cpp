// Smooths by a share of each frame's length, so that the smoothing lasts as long at every frame rate.
#include "viewer/pace_meter.h"

#include <algorithm>

namespace tyg {
namespace {

constexpr double kSmoothingSeconds = 0.5;
/// A longer frame says that nothing moved before it, not how fast frames come.
constexpr double kLongestMeasuredFrame = 0.5;
/// Frames per second: fewer are late, until there are more than a little more.
constexpr double kLate = 20, kInTime = 23;

}  // namespace

void PaceMeter::measure(double frameSeconds, double simulatingSeconds, const FrameClock& clock) {
  if (frameSeconds <= 0 || frameSeconds > kLongestMeasuredFrame) return;
  const double share = frameSeconds_ > 0 ? std::min(1.0, frameSeconds / kSmoothingSeconds) : 1;
  frameSeconds_ += share * (frameSeconds - frameSeconds_);
  simulatingSeconds_ += share * (std::min(simulatingSeconds, frameSeconds) - simulatingSeconds_);
  late_ = 1 / frameSeconds_ < (late_ ? kInTime : kLate);
  const double simulating = simulatingSeconds_ / frameSeconds_;
  // It is what is slow where it takes most of the time, or would not keep up with all of it.
  const bool isSimulating = simulating > 0.5 || (clock.behind() && clock.realTimeFactor() < clock.speed() * simulating);
  using enum Pace::Slow;
  pace_ = {.framesPerSecond = 1 / frameSeconds_,
           .simulating = simulating,
           .realTime = clock.realTimeFactor(),
           .behind = clock.behind(),
           .slow = !late_ && !clock.behind() ? Nothing
                   : isSimulating            ? Simulating
                                             : Drawing};
}

}  // namespace tyg
