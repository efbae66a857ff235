// The tool that cuts: a drag draws a line across the cloth, which is cut along it when the button comes up.
// Must not know: windows, which button uses it.
#pragma once

#include <memory>

#include "viewer/tool.h"

namespace tyg {

std::unique_ptr<Tool> makeCutTool();
/// Its icon, for the table.
std::span<const glm::vec2> cutIcon();

}  // namespace tyg
