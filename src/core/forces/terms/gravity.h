// Gravity: the same force on every particle, added before pinned particles are taken out.
#pragma once

#include "core/forces/stored_energy.h"
#include "core/forces/terms/term_list.h"
#include "tyg/sheet.h"

namespace tyg {

struct ForceTerm;

struct Gravity {
  static constexpr TermPlace kPlace = TermPlace::Always;
  static const ForceTerm kTerm;

  template <class T>
  struct Numbers {
    T weight[3] = {};  ///< of one particle, N
  };
  template <class T>
  static Numbers<T> numbersOf(const Scene& scene, const Sheet& sheet) {
    const double mass = sheet.particleMass;
    return {{T(mass * scene.gravity.x), T(mass * scene.gravity.y), T(mass * scene.gravity.z)}};
  }

  static constexpr double StoredEnergy::*kStored = &StoredEnergy::gravitational;
  /// Energy of the particles of one row, J.
  template <class Row>
  static double storedIn(const Row& row, const Numbers<double>& numbers) {
    const double(&weight)[3] = numbers.weight;
    return -row.sumOverPositions(
        [&](const auto& at) { return (weight[0] * at.x + weight[1] * at.y) + weight[2] * at.z; });
  }
};

}  // namespace tyg
