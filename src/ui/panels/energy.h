// The energy panel: the ledger as a running plot, and the power between its parts.
// Must not know: how energies are computed, windows.
#pragma once

#include <memory>

#include "ui/panels/panel.h"

namespace tyg {

std::unique_ptr<Panel> makeEnergyPanel();

}  // namespace tyg
