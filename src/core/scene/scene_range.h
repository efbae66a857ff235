// The sizes that the numbers of a scene may have: within them everything that follows from them (frequencies, energies,
// step limits and their squares) is a finite number of ordinary precision.
// Must not know: files, methods, what a simulation does with a scene.
#pragma once

#include "tyg/scene.h"

namespace tyg {

/// A number of the scene is 0 or of a size between these two, in its SI unit. The step and the tolerance are not part
/// of this: where they are too small for a run to end, the run says so.
inline constexpr double kSmallestNumber = 1e-30, kLargestNumber = 1e30;

/// Throws InputError with the scene's name, the key, what was found and what is allowed, where a number of the scene is
/// not finite, or too large or too small to compute with. Parts of vectors may be as small as they like.
void refuseExtremes(const Scene& scene);
/// The same for the parameters of force terms alone, which may change while the cloth moves.
void refuseExtremeParameters(const Scene& scene);

}  // namespace tyg
