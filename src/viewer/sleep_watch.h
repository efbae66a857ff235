// Tells when a running cloth has come to rest, so that no more ticks need to be simulated.
// Must not know: windows, what wakes the cloth.
#pragma once

#include <optional>

#include "tyg/simulation.h"

namespace tyg {

/// At rest means that nothing which can be seen is still to come. The fastest speeds of two windows of time, one after
/// the other and each as long as the cloth's slowest swing, tell how fast the motion dies away, and with that how far
/// any particle will still go. A motion that grows or goes on steadily, however slow it is, is no rest. All of this is
/// relative to the cloth's size and to its own times.
class SleepWatch {
 public:
  static constexpr double kUnseen = 1e-3;  ///< of the sheet's size, about a pixel: a motion that nobody sees

  /// After ticks that end with this kinetic energy, J.
  void follow(const Simulation& simulation, double kinetic);
  /// Something was done to the cloth, or acts on it: it is awake.
  void wake() { *this = {}; }
  /// `time`: the simulated time that is shown, s.
  [[nodiscard]] bool asleep(double time) const { return asleepSince_ && time >= *asleepSince_; }

  /// The length of a window, s: a whole swing of the sheet under its weight or its springs, whichever is longer; where
  /// it has neither, the time in which drag stops it.
  static double windowOf(const Simulation& simulation);

 private:
  [[nodiscard]] bool comesToRest(const Simulation& simulation, double window) const;

  std::optional<double> windowBegan_, asleepSince_;  ///< simulated s
  std::optional<double> before_;                     ///< fastest speed in the last whole window, m/s
  double now_ = 0;                                   ///< the same of the present window
};

}  // namespace tyg
