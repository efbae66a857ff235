// The energy alarm: damping and drag only take, so what a cloth stores less the work put in never rises by itself.
// Must not know: where the energies come from.
#pragma once

#include "tyg/simulation.h"

namespace tyg {

class Alarm {
 public:
  /// A rise by this fraction of the scale means that the run is unstable.
  static constexpr double kThreshold = 0.2;

  /// `floor` (J): what counts as a large energy in a run where nothing larger happens (a hundredth of stretch, and the
  /// first steps of a free fall); `startEnergy` = K + E at the
  /// start.
  Alarm(double floor, double startEnergy) : floor_(floor), largest_(startEnergy) {}

  /// Takes the energies of a moment (J) and says how the run stands.
  Status look(double kinetic, double elastic, double gravitational, double work);
  /// S: the largest over the run of |G|, |W| and K + E at the start, plus the floor, J.
  [[nodiscard]] double scale() const { return largest_ + floor_; }

 private:
  double floor_ = 0, largest_ = 0;
  double lowest_ = 0;
  bool looked_ = false;
};

}  // namespace tyg
