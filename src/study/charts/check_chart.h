// A chart of how wrong a motion is over time, and how well its explanation fits.
// Must not know: files, how the rows came about.
#pragma once

#include <string>

#include "study/check/motion_check.h"

namespace tyg {

/// A gnuplot script that draws check.svg and check.png from check.csv (t,error_m,explained_m,floor_m).
std::string checkScript(const MotionCheck& check);

}  // namespace tyg
