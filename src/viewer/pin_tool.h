// The tool that pins: a click pins the particle under the cursor where it is, or frees it.
// Must not know: windows, which button uses it.
#pragma once

#include <memory>

#include "viewer/tool.h"

namespace tyg {

std::unique_ptr<Tool> makePinTool();
/// Its icon, for the table.
std::span<const glm::vec2> pinIcon();

}  // namespace tyg
