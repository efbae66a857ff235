// The hand: a click pushes the particle under the cursor away from the eye, and holding the button still goes on; a
// drag grabs the particle, or the body. Must not know: windows, which button uses it.
#pragma once

#include <memory>

#include "viewer/tool.h"

namespace tyg {

std::unique_ptr<Tool> makeHandTool();
/// Its icon, for the table.
std::span<const glm::vec2> handIcon();

}  // namespace tyg
