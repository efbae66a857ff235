// The energy alarm. Damping and drag only take, so two sums never rise by themselves: what a cloth stores less the work
// put in, and that sum with what damping has taken since. A method past its limit breaks the first where it explodes
// and the second where it jitters: there the damping burns, step by step, what the method invents, and the store stays
// low. Must not know: where the energies come from, methods.
#pragma once

#include "tyg/forces.h"
#include "tyg/simulation.h"

namespace tyg {

class Alarm {
 public:
  /// A rise of K + E + G - W by this fraction of the scale means that the run is unstable.
  static constexpr double kStoredThreshold = 0.1;
  /// The same for K + E + G - W + D. Higher, since D is an estimate, and since a method that is stable may yet take
  /// less from the fastest waves than damping should.
  static constexpr double kBalanceThreshold = 0.3;

  /// `floor` (J): what counts as a large energy in a run where nothing larger happens (a hundredth of stretch, and the
  /// first steps of a free fall); `startEnergy` = K + E at the start.
  Alarm(double floor, double startEnergy) : floor_(floor), largest_(startEnergy) {}

  /// Takes the power (W) that damping and drag take at a time (s). For the regular looks alone, before look(): the loss
  /// between two of them is estimated as their distance in time times the lower of their powers. That errs low wherever
  /// motion dies out or swells, and hardly at all for a jitter, which goes on.
  void lose(double power, double time);
  /// Takes the energies of a moment (J) and says how the run stands. May be called as often as one likes.
  Status look(const StoredEnergy& energy, double work);

  /// S: the largest over the run of |G|, |W| and K + E at the start, plus the floor, J.
  [[nodiscard]] double scale() const { return largest_ + floor_; }
  /// The largest rises so far of the two sums above their lowest before, as fractions of the scale: what the thresholds
  /// are for.
  [[nodiscard]] double storedRise() const { return stored_.largestRise; }
  [[nodiscard]] double balanceRise() const { return balance_.largestRise; }

 private:
  struct Sum {
    double lowest = 0, largestRise = 0;
    void take(double value, double scale, bool first);
  };

  double floor_ = 0, largest_ = 0;
  double lost_ = 0, lastPower_ = 0, lastTime_ = 0;
  Sum stored_, balance_;
  bool looked_ = false;
};

/// The alarm of a scene that starts with these energies.
Alarm makeAlarm(const Scene& scene, const Sheet& sheet, const StoredEnergy& start);

}  // namespace tyg
