// The control panel: everything of the scene that can be set, with its unit.
// Must not know: how a change reaches the simulation (Viewer::use), windows.
#pragma once

#include <memory>

#include "ui/panels/panel.h"

namespace tyg {

std::unique_ptr<Panel> makeControlPanel();

}  // namespace tyg
