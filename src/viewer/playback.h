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
  /// Does nothing where there is no replay.
  void endReplay() {
    if (replaying_) clock_.setSpeed(speedBefore_);
    replaying_ = false;
  }
  [[nodiscard]] bool replaying() const { return replaying_; }
  [[nodiscard]] FrameClock& clock() { return clock_; }
  [[nodiscard]] const FrameClock& clock() const { return clock_; }

 private:
  static constexpr double kSlowest = 1.0 / 64;
  FrameClock clock_;
  bool replaying_ = false;
  double speedBefore_ = 1;  ///< that a replay goes back to
};

}  // namespace tyg
