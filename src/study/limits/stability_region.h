// Where a method is stable in the plane of z = h mu, and the roots mu of a scene's own modes to hold against it.
// Must not know: how either is drawn, files.
#pragma once

#include <complex>
#include <vector>

#include "integrators/chebyshev.h"
#include "tyg/method.h"
#include "tyg/scene.h"

namespace tyg {

/// The roots mu (1/s) of the scene's modes at rest: all of them for a small sheet, else those of the waves that fit
/// into the sheet.
std::vector<std::complex<double>> sceneRoots(const Scene& scene);
/// Those of a particle that rests on a body; none where nothing holds particles.
std::vector<std::complex<double>> heldRoots(const Scene& scene);

/// The stable part of the plane of z = h mu, as far as damping only takes (Re z <= 0).
struct StabilityRegion {
  std::vector<std::complex<double>> edge;  ///< from the upper imaginary axis to the lower one; empty: no edge
  double onRealAxis = 0;                   ///< the largest -z of a damped motion without springs; may be infinite
  ChebyshevStages stages;                  ///< of a method that chooses them by the step
};
/// At a step h (s). Methods of two roots at once (symplectic Euler, leapfrog) are drawn for conjugate pairs.
StabilityRegion regionOf(const Method& method, const Scene& scene, double h);

/// Is the motion exp(mu t) bounded at steps of h, when its root is a mode of its own? `held`: one of heldRoots().
bool holdsAt(const Method& method, const StabilityRegion& region, const std::complex<double>& mu, double h,
             bool held = false);

}  // namespace tyg
