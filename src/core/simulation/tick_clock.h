// The time of a run, in s and in ticks. A time is a base plus a number of ticks times dt, never a sum of steps, so that
// rounding does not add up. Must not know: what happens in a tick.
#pragma once

#include <cstdint>

#include "core/forces/step_times.h"

namespace tyg {

class TickClock {
 public:
  /// `dt`: the length of a tick, s, > 0.
  explicit TickClock(double dt) : dt_(dt) {}

  [[nodiscard]] double time() const { return time_; }  ///< s
  [[nodiscard]] std::int64_t ticks() const { return ticks_; }
  [[nodiscard]] double dt() const { return dt_; }  ///< s
  /// The time at which the present tick ends, or the one that is `ahead` ticks after it, s.
  [[nodiscard]] double tickEnd(std::int64_t ahead = 0) const {
    return baseTime_ + double(ticks_ + 1 + ahead - baseTick_) * dt_;
  }

  /// The times of steps that are one tick each, from the present tick on.
  [[nodiscard]] StepTimes stepTimes() const { return {baseTime_, ticks_ - baseTick_, dt_}; }

  /// Steps have led to this time (s), perhaps within a tick.
  void moveTo(double time) { time_ = time; }
  /// So many ticks have ended.
  void endTicks(std::int64_t count) { ticks_ += count; }
  /// The next tick begins at the present time, wherever the ones before it would have ended.
  void startTicksHere() { baseTime_ = time_, baseTick_ = ticks_; }
  /// Ticks have another length from here on, s.
  void useStep(double dt) {
    startTicksHere();
    dt_ = dt;
  }

 private:
  double time_ = 0, dt_;  // s
  std::int64_t ticks_ = 0;
  double baseTime_ = 0;  // s, at which the tick baseTick_ begins
  std::int64_t baseTick_ = 0;
};

}  // namespace tyg
