// A text in a panel, as wide as the panel and broken at spaces alone. Must not know: what it says.
#pragma once

#include <string_view>

#include "ui/panels/style.h"

namespace tyg {

/// Between ImGui's Begin and End. Words that are wider than the panel are broken, so that nothing of them is lost.
void paragraph(std::string_view text, Colour colour);

}  // namespace tyg
