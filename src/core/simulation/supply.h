// The energy that terms such as wind have brought: exact where the ledger is followed, and otherwise estimated between
// energy checks, where it is asked for by the alarm alone. A regular type, so that a checkpoint is a copy.
// Must not know: where the power comes from.
#pragma once

#include "core/forces/power.h"

namespace tyg {

class Supply {
 public:
  using Energies = decltype(Power::supplied);  ///< J, by kSupplies

  /// The ledger is followed no longer, or not yet: from this time (s) on the energy is estimated.
  void estimateFrom(const Power& power, double time) { power_ = power.supplied, time_ = time, estimates_ = true; }
  /// From now on the integral that is given to upTo() holds what is brought.
  void followFrom(const Power& power, double time) {
    check(power, time);
    estimates_ = false;
  }
  /// An energy check: the mean of the powers then and before counts for the time between them.
  void check(const Power& power, double time) {
    if (!estimates_) return;
    estimated_ = upTo(power, time, {});
    power_ = power.supplied, time_ = time;
  }
  /// What has been brought until now, J; `power` (W) is of now, `integral` (J) of what the methods have added up.
  [[nodiscard]] Energies upTo(const Power& power, double time, const Power& integral) const {
    Energies all = estimated_;
    for (std::size_t k = 0; k < all.size(); ++k) {
      all[k] += integral.supplied[k];
      if (estimates_) all[k] += (power_[k] + power.supplied[k]) / 2 * (time - time_);
    }
    return all;
  }

 private:
  Energies estimated_{}, power_{};
  double time_ = 0;
  bool estimates_ = true;
};

}  // namespace tyg
