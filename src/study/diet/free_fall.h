// Whether a sheet that falls freely meets a body on its way, told without running it.
// Must not know: words, results.
#pragma once

#include "tyg/scene.h"

namespace tyg {

/// Whether a sheet at rest that nothing but its weight moves may touch a body within its run. Where that is not
/// certain it may: where bodies move, and where it passes one by less than a layer of contact.
bool mayFallOntoABody(const Scene& scene);

}  // namespace tyg
