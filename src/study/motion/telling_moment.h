// The time at which one picture shows most of a scene.
// Must not know: what draws it.
#pragma once

#include "tyg/scene.h"

namespace tyg {

/// In s: the end of the scene's first push, else of its first motion of pins or bodies, else 1.5 s after its first wind
/// began or its end; without any of these 0.45 s, or 1 s where there are bodies. The end of the run where that is
/// earlier.
double tellingMoment(const Scene& scene);

}  // namespace tyg
