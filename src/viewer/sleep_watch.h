// Tells when a running cloth has come to rest, so that no more ticks need to be simulated.
// Must not know: windows, what wakes the cloth.
#pragma once

#include <optional>

#include "tyg/simulation.h"

namespace tyg {

class SleepWatch {
 public:
  /// At rest: no particle has moved faster than kStillSpeed (m/s) for kStillSeconds (simulated s).
  static constexpr double kStillSpeed = 1e-3, kStillSeconds = 1;

  /// After ticks that end with this kinetic energy, J.
  void follow(const Simulation& simulation, double kinetic);
  /// Something was done to the cloth, or acts on it: it is awake.
  void wake() { stillSince_.reset(); }
  /// `time`: the simulated time that is shown, s.
  [[nodiscard]] bool asleep(double time) const { return stillSince_ && time - *stillSince_ >= kStillSeconds; }

 private:
  std::optional<double> stillSince_;  ///< simulated s; nothing while it moves
};

}  // namespace tyg
