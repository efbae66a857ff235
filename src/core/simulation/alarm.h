// The energy alarm. Damping only takes energy away, so two sums never rise by themselves in a real cloth. The first is
// the energy that the cloth stores, less the work put in. The second is the first plus the energy that damping has
// taken lately. Where a method past its limit explodes, the first sum rises. Where it only jitters, damping takes away
// the energy that the method adds at every step, so that the stored energy stays small. Then the second sum rises, and
// the first one does not fall although damping takes energy.
//
// Must not know: where the energies come from, methods.
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "core/forces/forces.h"
#include "tyg/simulation.h"

namespace tyg {

class Alarm {
 public:
  /// A rise of K + E + G - W by this fraction of the scale, or of K + E + G - W + D with D what damping took during
  /// about the last kMemory regular checks, means that the run is unstable. How often this is wrong: docs/stability.md,
  /// "How often it is wrong", as measured by tests/benchmarks/alarm_statistics.cpp.
  static constexpr double kThreshold = 0.25;
  /// The same for the first sum of a method of order 3 or higher. Below its limit such a method changes the energy so
  /// little that a rise of this size is no error of a sound run.
  static constexpr double kThresholdOfHighOrder = 1.0 / 32;
  static constexpr double kMemory = 16;
  /// Of the estimated power: the mean power until the next check that confirms the estimate.
  static constexpr double kConfirmed = 0.5;
  /// A steady rise: with a method of order 2 or higher a run is unstable as well where the stored energy, less the work
  /// put in, and what damping took in between rise by this fraction of the scale, but less than kThreshold, from one
  /// regular check to the next, kSteadyChecks times in a row, after one rise that is estimated. A blow does not last as
  /// long, and below its limit the energy of such a method does not go on rising. Larger rises are those of stiff
  /// dampers, which take less than their power tells.
  static constexpr double kSteadyRise = 1.0 / 256;
  /// Steps that take less than damping would leave a rise in sound runs too, but never so large a part of the loss. The
  /// rise of those must be more than this fraction of the scale, and more than kSurplus of what damping took.
  static constexpr double kSteadyRiseOfLess = 1.0 / 1024, kSurplus = 0.5;
  /// A missing loss: a run is unstable as well where damping takes more than this fraction of the scale between regular
  /// checks, kSteadyChecks times in a row, and the stored energy, less the work put in, is no lower after these than
  /// before. The stored energy of a method of order 1 or 2 swings by itself, by more than light damping takes. There
  /// damping must take more, and with order 1 the energy must not fall between any two of these checks.
  static constexpr double kLeastLoss = 1.0 / 32768, kLeastLossOfLowOrder = 1.0 / 1024;
  static constexpr int kSteadyChecks = 8;

  /// `floor` (J): what counts as a large energy in a run where nothing larger happens (a hundredth of stretch);
  /// `startEnergy` = K + E at the start; `order` of the method.
  Alarm(double floor, double startEnergy, int order) : floor_(floor), largest_(startEnergy), order_(order) {
    storedBefore_.fill(kUnknown);
  }

  /// From here on another method steps, of this order. Its rises count from here.
  void useOrder(int order);
  /// How much of the energy that damping would take the steps really take.
  enum class Taken : std::uint8_t {
    AsMuch,   ///< about all of it
    Less,     ///< less of fast waves, as methods do that stay stable however large the damping is
    Unknown,  ///< steps that a method chooses itself, and methods without a limit
  };
  /// Takes the power (W) that damping takes at a time (s), at the regular checks alone and before check().
  /// The energy lost between two checks is estimated as the time between them times the lower of the two powers. That
  /// is too little where the motion dies out or grows, and nearly right for a jitter, which stays the same. It is too
  /// much where both powers are those of short blows, of bodies or of pins that are jerked. So a rise of the second sum
  /// is only a suspicion until the next check. If the mean of the powers of the steps in between is less than
  /// kConfirmed of the estimate, the sum begins anew. Each check takes a part 1/kMemory off D, so that small errors of
  /// the estimate do not add up over a long run; this only lowers the sum, and so never sets off the alarm. What winds,
  /// pins and bodies have brought is not taken off: it is lost all the time, and without it the sum would fall for ever
  /// while a cloth jitters in the wind. Of steps that take less the second sum does not use the power, and of those of
  /// which that is unknown no rule does.
  void lose(double power, double time, Taken taken);
  /// Whether sample() is to be called with the power (W) after every step until the next regular check, its own too.
  [[nodiscard]] bool suspects() const { return suspects_ || seesRise_; }
  void sample(double power) { sampled_ += power, ++samples_; }
  /// To be called for steps of h seconds. `forcing` (J/s2): the sum over the particles of |F|^2 / m, F what steady
  /// forces and pushes do to a particle. A first-order method that begins to fall is ahead of the truth by n/2 of
  /// forcing h^2 after n steps, with nothing else to compare it to while n is small: five of them keep the alarm quiet
  /// over the first steps, and are nothing later.
  void expect(double forcing, double h);
  /// Takes the energies at one time (J) and returns the status of the run. May be called as often as one likes: the
  /// balance changes only with the first check after lose(), when stored and lost energy are of the same time. Of
  /// `work`, `flowing` is what winds, bodies and moving pins have done: it may grow for ever while all of it is lost
  /// again.
  Status check(const StoredEnergy& energy, double work, double flowing = 0);

  /// S: the largest over the run of |G|, the |W| of pushes, what else did work during about the last kMemory regular
  /// checks, and K + E at the start, plus the floor, J.
  [[nodiscard]] double scale() const { return largest_ + floor_; }
  [[nodiscard]] int order() const { return order_; }
  /// The largest rises so far of the two sums, as fractions of the scale and what first steps are given: what the
  /// thresholds are for.
  [[nodiscard]] double storedRise() const { return stored_.largestRise; }
  [[nodiscard]] double balanceRise() const { return balance_.largestRise; }

 private:
  /// A sum that must not rise above its lowest value before.
  struct Sum {
    double lowest = std::numeric_limits<double>::infinity(), largestRise = 0;
    double riseTo(double value, double large);
  };
  [[nodiscard]] bool risesSteadily(double stored, double large);
  [[nodiscard]] bool keepsWhatIsLost(double stored, double large);
  [[nodiscard]] bool changesSteadily(double stored, double large);

  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

  double floor_ = 0, largest_ = 0, firstSteps_ = 0;
  double flowedLately_ = 0, flowedBefore_ = 0;
  double lost_ = 0, lastPower_ = 0, lastTime_ = 0;
  double estimated_ = 0, sampled_ = 0;  // W, between the last two checks, and the sum of the samples since
  int samples_ = 0;
  double takenSince_ = 0;        // J, since the regular check before, from the power at its end; 0 if unknown
  double lostSince_ = kUnknown;  // J, the same from the mean power where that was sampled; NaN if unknown
  std::array<double, kSteadyChecks> storedBefore_{};  // J, at the last regular checks, the latest first
  int steadyRises_ = 0, keptLosses_ = 0;              // in a row, up to the last regular check
  bool isSampled_ = false, seesRise_ = false, takesLess_ = false;
  int order_ = 1;
  Sum stored_, balance_;
  bool checked_ = false, lossIsPresent_ = true, suspects_ = false, isSure_ = false;
};

/// The alarm of a scene that starts with these energies and is stepped by a method of this order.
Alarm makeAlarm(const Scene& scene, const Sheet& sheet, const StoredEnergy& start, int order);

}  // namespace tyg
