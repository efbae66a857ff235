// What of a failure is to be seen beside its sentence: the motion that fails first, by its name and as a pattern, and
// while the cloth breaks its kinetic energy. Must not know: what the ways out are.
#pragma once

#include "ui/overlay.h"

namespace tyg {

/// At the right edge, with its upper right corner there, and no higher than `room`; nothing where there is nothing to
/// tell, or no room for it.
void drawFailurePicture(TextWriter writer, ImVec2 corner, float room, const Viewer& viewer);

}  // namespace tyg
