// How fast time passes on the screen: the frame clock, and the slow speed of a replay, which goes back to what it was.
// Must not know: the simulation, what is replayed.
#pragma once

#include <algorithm>

#include "view/frame_clock.h"

namespace tyg {

class Playback {
 public:
  /// `tick`: its length, s.
  explicit Playback(double tick) : clock_(tick) {}

  /// Slower or faster, up to real time. A person's choice outlasts the replay in which it is made.
  void changeSpeed(double factor) {
    clock_.setSpeed(std::clamp(clock_.speed() * factor, kSlowest, 1.0));
    speedBefore_ = clock_.speed();
  }
  static constexpr double kSlowly = 0.125;
  /// From now on the past is shown again, no faster than this.
  void beginReplay(double speed = kSlowly) {
    replaying_ = true;
    speedBefore_ = clock_.speed();
    clock_.setSpeed(std::min(speedBefore_, speed));
  }
  /// From now on time passes no faster than this, as for a cloth that breaks.
  void slowDown(double speed) {
    if (!slowed_) speedBefore_ = clock_.speed();
    slowed_ = true;
    clock_.setSpeed(std::clamp(std::min(speedBefore_, speed), kSlowestBreak, 1.0));
  }
  /// Ends a replay, or that slowness; does nothing where there is neither.
  void endReplay() {
    if (replaying_ || slowed_) clock_.setSpeed(speedBefore_);
    replaying_ = slowed_ = false;
  }
  [[nodiscard]] bool replaying() const { return replaying_; }
  [[nodiscard]] FrameClock& clock() { return clock_; }
  [[nodiscard]] const FrameClock& clock() const { return clock_; }

 private:
  static constexpr double kSlowest = 1.0 / 64, kSlowestBreak = 1.0 / 4096;
  FrameClock clock_;
  bool replaying_ = false, slowed_ = false;
  double speedBefore_ = 1;  ///< that a replay goes back to
};

}  // namespace tyg
