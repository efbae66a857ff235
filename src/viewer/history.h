// The last ten seconds of a running cloth: checkpoints now and then, and from one of them to any later tick by
// simulating again, which gives the same bits. Must not know: windows, clocks.
#pragma once

#include <cstdint>
#include <deque>

#include "tyg/simulation.h"

namespace tyg {

/// Follows one simulation. While `past()`, the simulation is at an earlier moment than the newest one, and tick()
/// repeats what happened then; cut() makes the present moment the newest one.
class History {
 public:
  static constexpr double kSeconds = 10;                ///< simulated, that are kept
  static constexpr std::size_t kMostBytes = 128 << 20;  ///< of all copies; but two of them there are in any case

  struct TimePoint {
    std::int64_t ticks = 0;
    double time = 0;  ///< s
  };

  /// `mostBytes`: of all copies, instead of kMostBytes.
  explicit History(std::size_t mostBytes = kMostBytes) : mostBytes_(mostBytes) {}

  /// Forgets everything; the present state is the first moment.
  void begin(const Simulation& simulation);
  /// The same for a run that a log tells of, which is all still to come: the present moment is past.
  void recall(const Simulation& simulation, EventLog log);
  /// Advances by `count` ticks: the past is computed again up to the newest moment, and from there the simulation goes
  /// on. Fewer where the alarm stops the simulation.
  void tick(Simulation& simulation, std::int64_t count);
  /// Goes back to the checkpoint nearest before `tick`, which is clamped to what is kept. From there
  /// tick(simulation, target() - simulation.ticks()) leads to it.
  void turnTo(Simulation& simulation, std::int64_t tick);
  [[nodiscard]] std::int64_t target() const { return target_; }
  /// Forgets what came after the present moment.
  void cut(const Simulation& simulation);

  [[nodiscard]] bool past() const { return past_; }
  [[nodiscard]] TimePoint first() const { return {copies_.front().ticks(), copies_.front().time()}; }
  /// The last moment that was reached.
  [[nodiscard]] TimePoint newest(const Simulation& simulation) const;
  /// The tick that begins nearest to a time (s); an estimate where the step changed between two checkpoints.
  [[nodiscard]] std::int64_t tickAt(double time, const Simulation& simulation) const;
  /// The log up to the newest moment, with its length and the hash there.
  [[nodiscard]] EventLog record(const Simulation& simulation) const;
  /// The log up to the present moment, likewise.
  [[nodiscard]] static EventLog recordTo(const Simulation& simulation);
  [[nodiscard]] std::size_t bytes() const;  ///< of all copies

 private:
  void follow(const Simulation& simulation);
  void repeatEvents(Simulation& simulation) const;
  void arrive(Simulation& simulation);

  std::size_t mostBytes_;
  std::deque<Snapshot> copies_;  ///< oldest first, never empty once begun
  bool past_ = false;
  EventLog whole_;    ///< while past: record() of the newest moment
  TimePoint newest_;  ///< while past
  std::int64_t target_ = 0;
};

}  // namespace tyg
