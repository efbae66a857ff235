// The energy that terms such as wind have brought: exact, or estimated between energy checks. A regular type, so that a
// checkpoint is a copy. Must not know: where the power comes from.
#pragma once

#include "core/forces/power.h"

namespace tyg {

class Supply {
 public:
  using Energies = decltype(Power::supplied);  ///< J, by kSupplies

  /// From this time (s) on the energy is what the methods add up, or else estimated. `power` (W) and `integral` (J, of
  /// what they have added up so far) are of now.
  void follow(bool exactly, const Power& power, double time, const Power& integral) {
    brought_ = upTo(power, time, integral);
    exactly_ = exactly;
    power_ = power.supplied, time_ = time, integral_ = integral.supplied;
  }
  [[nodiscard]] bool isExact() const { return exactly_; }
  /// An energy check: where it is estimated, the mean of the powers now and before counts for the time between them.
  void check(const Power& power, double time, const Power& integral) {
    if (!exactly_) follow(false, power, time, integral);
  }
  /// What has been brought until now, J.
  [[nodiscard]] Energies upTo(const Power& power, double time, const Power& integral) const {
    Energies all = brought_;
    for (std::size_t k = 0; k < all.size(); ++k) {
      all[k] += exactly_ ? integral.supplied[k] - integral_[k] : (power_[k] + power.supplied[k]) / 2 * (time - time_);
    }
    return all;
  }

 private:
  Energies brought_{};             ///< until time_
  Energies power_{}, integral_{};  ///< at time_, W and J
  double time_ = 0;                ///< s
  bool exactly_ = false;
};

}  // namespace tyg
