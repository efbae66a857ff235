// When a scene is worth a picture.
// Must not know: what draws it.
#pragma once

#include "tyg/scene.h"

namespace tyg {

/// The moment that shows most of a scene in one picture, s: the end of its first push, else some way into the run.
double tellingMoment(const Scene& scene);

}  // namespace tyg
