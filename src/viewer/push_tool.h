// The tool that pushes: a click pushes the particle under the cursor away from the eye, and holding the button goes on.
// Must not know: windows, which button uses it.
#pragma once

#include <memory>

#include "viewer/tool.h"

namespace tyg {

std::unique_ptr<Tool> makePushTool();
/// N: the force of a click where tools act with their usual strength: seen everywhere, and it tears nothing.
double usualPush(const Sheet& sheet);

}  // namespace tyg
