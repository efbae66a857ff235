// The energies that a state of the sheet stores.
// Must not know: forces, methods.
#pragma once

#include <algorithm>

namespace tyg {

/// Energies stored in a state, J, and the largest spring elongation as a fraction of its rest length.
struct StoredEnergy {
  double kinetic = 0;
  double elastic = 0;
  double gravitational = 0;  ///< zero where every particle is at height zero
  double maxStretch = 0;     ///< >= 0

  /// Adds what another part of the sheet stores.
  void add(const StoredEnergy& other) {
    kinetic += other.kinetic, elastic += other.elastic, gravitational += other.gravitational;
    maxStretch = std::max(maxStretch, other.maxStretch);
  }
};

}  // namespace tyg
