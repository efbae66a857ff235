// The energy alarm. Damping only takes, so two sums never rise by themselves: what a cloth stores less the work
// put in, and that with what damping has lately taken. A method past its limit breaks the first where it explodes, and
// the second where it jitters: there damping burns, step by step, what the method invents, and the store stays low.
//
// Must not know: where the energies come from, methods.
#pragma once

#include "core/forces/forces.h"
#include "tyg/simulation.h"

namespace tyg {

class Alarm {
 public:
  /// A rise of K + E + G - W by this fraction of the scale, or of K + E + G - W + D with D what damping took during
  /// about the last kMemory regular looks, means that the run is unstable. How often this is wrong: docs/stability.md,
  /// "How often it is wrong", as measured by tests/benchmarks/alarm_statistics.cpp.
  static constexpr double kThreshold = 0.25;
  static constexpr double kMemory = 16;

  /// `floor` (J): what counts as a large energy in a run where nothing larger happens (a hundredth of stretch);
  /// `startEnergy` = K + E at the start.
  Alarm(double floor, double startEnergy) : floor_(floor), largest_(startEnergy) {}

  /// Takes the power (W) that damping takes at a time (s), at the regular checks alone and before check().
  /// Between two of them the loss is estimated as their distance in time times the lower of their powers: too little
  /// wherever motion dies out or swells, and hardly too little for a jitter, which goes on. Each check forgets a part
  /// 1/kMemory of D, so that small errors of the estimate do not add up over a long run; forgetting never lifts the
  /// sum.
  void lose(double power, double time);
  /// To be called for steps of h seconds. `forcing` (J/s2): the sum over the particles of |F|^2 / m, F what gravity and
  /// pushes do to a particle. A first-order method that begins to fall is ahead of the truth by n/2 of forcing h^2
  /// after n steps, with nothing else to compare it to while n is small: five of them keep the alarm quiet over the
  /// first steps, and are nothing later.
  void expect(double forcing, double h);
  /// Takes the energies of a moment (J) and returns the status of the run. May be called as often as one likes: the
  /// balance moves only with the first check after lose(), where stored and lost energy are of the same moment.
  Status check(const StoredEnergy& energy, double work);

  /// S: the largest over the run of |G|, |W| and K + E at the start, plus the floor, J.
  [[nodiscard]] double scale() const { return largest_ + floor_; }
  /// The largest rises so far of the two sums above their lowest before, as fractions of the scale and what first steps
  /// are given: what the threshold is for.
  [[nodiscard]] double storedRise() const { return stored_.largestRise; }
  [[nodiscard]] double balanceRise() const { return balance_.largestRise; }

 private:
  struct Sum {
    double lowest = 0, largestRise = 0;
    void take(double value, double large, bool first);
  };

  double floor_ = 0, largest_ = 0, firstSteps_ = 0;
  double lost_ = 0, lastPower_ = 0, lastTime_ = 0;
  Sum stored_, balance_;
  bool checked_ = false, lossIsPresent_ = true;
};

/// The alarm of a scene that starts with these energies.
Alarm makeAlarm(const Scene& scene, const Sheet& sheet, const StoredEnergy& start);

}  // namespace tyg
