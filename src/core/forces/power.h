// The power that goes in and out of the cloth besides what it stores, and energies that add up from it.
// Must not know: what causes it.
#pragma once

#include <array>
#include <cstddef>

#include "core/forces/terms/all_terms.h"

namespace tyg {

/// In W, or in J where it is summed over time.
struct Power {
  double lost = 0;                                  ///< taken by damping, drag and air, >= 0
  std::array<double, kSupplies.size()> supplied{};  ///< brought by terms, by kSupplies
  double pins = 0;                                  ///< brought by pins that move

  /// Adds another one, `times` over.
  void add(const Power& other, double times = 1) {
    lost += times * other.lost;
    for (std::size_t k = 0; k < supplied.size(); ++k) supplied[k] += times * other.supplied[k];
    pins += times * other.pins;
  }
};

}  // namespace tyg
