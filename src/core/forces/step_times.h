// When each of several equal steps begins: from one formula, so that steps in one call and steps one by one see the
// same times. Must not know: what a step does.
#pragma once

#include <cstdint>

namespace tyg {

struct StepTimes {
  double base = 0;         ///< s
  std::int64_t first = 0;  ///< steps between the base and the first of these
  double h = 0;            ///< s, each

  /// The time at which step k of these begins, s.
  [[nodiscard]] double at(int k) const { return base + double(first + k) * h; }
};

}  // namespace tyg
