// The traces panel, the report's figure 4 live: x, y and z of up to four particles against time.
// Must not know: the simulation's insides, windows.
#pragma once

#include <memory>

#include "ui/panels/panel.h"

namespace tyg {

std::unique_ptr<Panel> makeTracesPanel();

}  // namespace tyg
