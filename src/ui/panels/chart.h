// The chart panel: speed against accuracy of the present scene, measured beside the running cloth.
// Must not know: how the study is done, windows.
#pragma once

#include <memory>

#include "ui/panels/panel.h"

namespace tyg {

std::unique_ptr<Panel> makeChartPanel();

}  // namespace tyg
