// Gravity: the same force on every particle, added before pinned particles are taken out.
#pragma once

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

  static constexpr EnergyStore kStore{.name = "gravitational", .holder = "gravity", .startsAtZero = true};
  /// Energy of the particles of one row, J.
  template <class Row>
  static double storedIn(const Row& row, const Numbers<double>& numbers) {
    const double(&weight)[3] = numbers.weight;
    return -row.sumOverParticles([&](const auto& position, const auto& /*velocity*/) {
      return (weight[0] * position.x + weight[1] * position.y) + weight[2] * position.z;
    });
  }
};

}  // namespace tyg
