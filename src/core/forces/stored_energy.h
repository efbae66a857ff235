// The energies that a state of the sheet stores.
// Must not know: forces, methods.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/forces/terms/all_terms.h"

namespace tyg {

/// Energies stored in a state, J, and the largest spring elongation as a fraction of its rest length.
struct StoredEnergy {
  double kinetic = 0;
  std::array<double, kStores.count> stored{};  ///< by kStores; without a natural zero: 0 at the origin
  double maxStretch = 0;                       ///< >= 0

  /// What terms such as this one store.
  template <class Term>
  [[nodiscard]] double& of() {
    return stored[kStores.indexOf(Term::kStore)];
  }
  template <class Term>
  [[nodiscard]] double of() const {
    return stored[kStores.indexOf(Term::kStore)];
  }
  /// Kinetic and all that is stored.
  [[nodiscard]] double sum() const {
    double sum = kinetic;
    for (const double store : stored) sum += store;
    return sum;
  }
  /// The part of sum() that has a natural zero, and the size of the rest, which counts from the start of a run.
  [[nodiscard]] double withNaturalZero() const {
    double sum = kinetic;
    for (std::size_t k = 0; k < stored.size(); ++k) sum += kStores.list[k].startsAtZero ? 0 : stored[k];
    return sum;
  }
  [[nodiscard]] double sizeSinceStart() const {
    double sum = 0;
    for (std::size_t k = 0; k < stored.size(); ++k) sum += kStores.list[k].startsAtZero ? std::abs(stored[k]) : 0;
    return sum;
  }
  /// The same energies, of which those without a natural zero count from `start`.
  [[nodiscard]] StoredEnergy since(const StoredEnergy& start) const {
    StoredEnergy energy = *this;
    for (std::size_t k = 0; k < stored.size(); ++k)
      energy.stored[k] -= kStores.list[k].startsAtZero ? start.stored[k] : 0;
    return energy;
  }
  /// Adds what another part of the sheet stores.
  void add(const StoredEnergy& other) {
    kinetic += other.kinetic;
    for (std::size_t k = 0; k < stored.size(); ++k) stored[k] += other.stored[k];
    maxStretch = std::max(maxStretch, other.maxStretch);
  }
};

}  // namespace tyg
