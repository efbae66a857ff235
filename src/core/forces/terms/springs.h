// The springs of a sheet, by family. Their forces are fused: row_forces.h computes them along a row, row_energy.h adds
// up their energy and the power of their damping. Here is what both read.
#pragma once

#include <array>

#include "core/forces/terms/term_list.h"
#include "tyg/sheet.h"

namespace tyg {

struct ForceTerm;

/// The law of one family: force = (ks - ksTimesRest / length) * direction + damping.
template <class T>
struct SpringLaw {
  T ks = 0, ksTimesRest = 0, kd = 0;  ///< N/m, N, N s/m
  T rest = 0;                         ///< m
};

inline constexpr std::array kFamilies{Family::Structural, Family::Shear, Family::Bend};
/// The springs of `family` that this scene has.
const SpringFamily& familyOf(const Scene& scene, Family family);
/// The largest ks/kd of a family, 1/s: whichever of the springs are left, no motion has more stiffness for its damping.
/// Infinite where a family is not damped.
double mostStiffnessPerDamping(const Scene& scene);

template <Family family>
struct Springs {
  static constexpr TermPlace kPlace = TermPlace::Springs;
  static constexpr EnergyStore kStore{.name = "elastic", .holder = "springs"};
  static const ForceTerm kTerm;

  template <class T>
  struct Numbers {
    SpringLaw<T> law;
  };
  template <class T>
  static Numbers<T> numbersOf(const Scene& scene, const Sheet& sheet) {
    const SpringFamily& springs = familyOf(scene, family);
    const double rest = restLength(sheet, family);
    return {{T(springs.ks), T(springs.ks * rest), T(springs.kd), T(rest)}};
  }
};

using StructuralSprings = Springs<Family::Structural>;
using ShearSprings = Springs<Family::Shear>;
using BendSprings = Springs<Family::Bend>;
template <>
const ForceTerm StructuralSprings::kTerm;
template <>
const ForceTerm ShearSprings::kTerm;
template <>
const ForceTerm BendSprings::kTerm;

}  // namespace tyg
