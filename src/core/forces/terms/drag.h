// Drag of air at rest: a force -drag * v on every particle.
#pragma once

#include "core/forces/terms/term_list.h"
#include "tyg/sheet.h"

namespace tyg {

struct ForceTerm;

struct Drag {
  static constexpr TermPlace kPlace = TermPlace::Particles;
  static const ForceTerm kTerm;

  template <class T>
  struct Numbers {
    T drag = 0;  ///< N s/m
  };
  template <class T>
  static Numbers<T> numbersOf(const Scene& scene, const Sheet& /*sheet*/) {
    return {T(scene.drag)};
  }

  /// The force f on some particles with the drag added; isFree is 0 for a pinned one, else 1.
  template <class Vector, class Lanes, class T>
  [[gnu::always_inline]] static Vector addTo(const Vector& f, const Lanes& isFree, const Vector& /*position*/,
                                             const Vector& velocity, const Numbers<T>& numbers) {
    return f - (isFree * numbers.drag) * velocity;
  }
  /// Power that is taken from the particles of one row, W.
  template <class Row>
  static double powerIn(const Row& row, const Numbers<double>& numbers) {
    if (!(numbers.drag > 0)) return 0;
    return numbers.drag * row.sumOverParticles(
                              [](const auto& /*position*/, const auto& velocity) { return dotOf(velocity, velocity); });
  }
};

}  // namespace tyg
