// The level lines of a method's stableStep(w2, d): which mixture of stiffness and damping limits its step.
// Must not know: scenes, spectra.
#pragma once

#include "core/spectrum/lattice.h"
#include "tyg/method.h"

namespace tyg {

/// The normal of a level line, up to a positive factor: the limiting mode among many has the largest ofK w2 + ofC d.
struct LineNormal {
  double ofK = 1;  ///< of stiffness
  double ofC = 0;  ///< of damping, 1/s per unit of ofK
};

/// The normal at a mode that stiffness puts at the limit, scaled to ofK = 1; damping that helps is left out.
LineNormal normalOfStiff(const Method& method, const Mode& mode);
/// The normal at a mode that damping puts at the limit, scaled to ofC = 1. Stiffness that helps (it slows a strongly
/// damped mode down) has a weight below 0 there; stiffness that harms is left to the other one.
LineNormal normalOfDamped(const Method& method, const Mode& mode);

/// Whether one normal finds the limiting mode of all: the level lines are straight, as those of symplectic Euler and
/// leapfrog, or damping up to `d` (1/s) sets no limit at all.
bool hasStraightLevelLines(const Method& method, double d);

}  // namespace tyg
