// What of a failure is to be seen beside its sentence: the motion that fails first, by its name and as a pattern, and
// while the cloth breaks its kinetic energy. Must not know: what the ways out are.
#pragma once

#include "ui/overlay.h"

namespace tyg {

/// In the upper right corner of what is free, which goes from `upper` to `lower`; nothing where there is nothing to
/// tell, or no room for it beside or above the cloth. Returns the width that it takes beside the cloth and the height
/// above it, one of them 0, or both where nothing was drawn.
ImVec2 drawFailurePicture(TextWriter writer, ImVec2 upper, ImVec2 lower, const Viewer& viewer);

}  // namespace tyg
