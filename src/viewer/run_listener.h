// What a run tells those who act on its cloth: the tools, and the part that keeps the settings in use.
// Must not know: who listens.
#pragma once

#include <cstdint>

namespace tyg {

class Simulation;

class RunListener {
 public:
  RunListener() = default;
  virtual ~RunListener() = default;
  RunListener(const RunListener&) = delete;
  RunListener& operator=(const RunListener&) = delete;

  /// Before ticks at the newest time, not while the past is simulated again; `due` of them are left in this frame. May
  /// act on the simulation. Returns how many ticks may pass at most, 1 at least, before it must be asked again.
  virtual std::int64_t beforeTicks(Simulation& simulation, std::int64_t due) = 0;
  /// Whether something acts on the cloth at this tick that moves it: such a cloth does not fall asleep.
  [[nodiscard]] virtual bool actsAt(std::int64_t tick) const = 0;
  /// The simulation came to a time that had another method, step or live parameters.
  virtual void settingsReturned() = 0;
  /// A new run waits for its start: what was held is let go of.
  virtual void runBegan() = 0;
};

}  // namespace tyg
