// How large a step may be: the limit that the springs of a sheet at rest set to a method.
// Must not know: deformed states, measured limits, clocks.
#pragma once

#include "tyg/integrator.h"
#include "tyg/scene.h"

namespace tyg {

/// Largest stable step (s) of a method over the waves of the scene's lattice at rest, damping and drag included. The
/// lattice is taken as unbounded, so pins and edges can only make the true limit larger. 0 where no step is stable; NaN
/// where the method has no limit or nothing on the sheet sets one (free fall).
double restLatticeLimit(const Scene& scene, const Method& method);

}  // namespace tyg
