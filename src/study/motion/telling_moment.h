// The time at which one picture shows most of a scene.
// Must not know: what draws it.
#pragma once

#include "tyg/scene.h"

namespace tyg {

/// In s: the end of the scene's first push; without a push, 0.45 s or the end of the run if that is earlier.
double tellingMoment(const Scene& scene);

}  // namespace tyg
