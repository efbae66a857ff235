// Runs the ticks that are due, as long as a frame has time for them: many in one call where they are short.
// Must not know: what is shown, why ticks are due.
#pragma once

#include <cstdint>
#include <functional>
#include <utility>

#include "tyg/simulation.h"
#include "viewer/history.h"
#include "viewer/run_listener.h"

namespace tyg {

class TickRunner {
 public:
  using Clock = std::function<double()>;     ///< s, from any start
  static constexpr double kLongestTick = 2;  ///< s of the clock: a method of free steps that takes longer has failed

  explicit TickRunner(Clock clock) : clock_(std::move(clock)) {}
  TickRunner(const TickRunner&) = delete;
  TickRunner& operator=(const TickRunner&) = delete;

  /// From now on gives up a tick of this simulation that takes longer than kLongestTick: it may choose ever smaller
  /// steps, and no frame waits for that. This object must stay where it is while the simulation lives.
  void guard(Simulation& simulation);
  /// Up to `ticks`, one at least where any are due, until `seconds` of the clock are over or the alarm stops them.
  void run(Simulation& simulation, History& history, RunListener& listener, std::int64_t ticks, double seconds);
  /// Of ticks that are run otherwise: the next one begins now.
  void begin() { tickBegan_ = clock_(); }
  /// Whether a tick was given up since the last call; the simulation is at its beginning.
  [[nodiscard]] bool takeStall() { return std::exchange(late_, false); }

 private:
  [[nodiscard]] std::int64_t ticksIn(double seconds) const;

  Clock clock_;
  double tickBegan_ = 0;    ///< s, of the clock
  double tickSeconds_ = 0;  ///< wall time of a tick, smoothed; 0 before the first
  bool late_ = false;       ///< a tick was given up
};

}  // namespace tyg
