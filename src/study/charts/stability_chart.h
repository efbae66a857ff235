// The chart of step limits: predicted beside measured, and every method's stability region with the scene's own modes.
// Must not know: files, how gnuplot is run.
#pragma once

#include <string>

#include "study/limits/stability_study.h"

namespace tyg {

/// A gnuplot script that draws `svg` and `png`, the names that are defined when it is run.
std::string stabilityScript(const StabilityStudy& study);

}  // namespace tyg
