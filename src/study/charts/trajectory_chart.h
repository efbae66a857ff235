// The chart of trajectories, drawn by gnuplot from the rows.
// Must not know: files, how gnuplot is run.
#pragma once

#include <string>

#include "study/motion/trajectories.h"

namespace tyg {

/// A gnuplot script that draws plot.svg and plot.png from plot.csv, all in its own folder.
std::string trajectoryScript(const TrajectoryStudy& study);

}  // namespace tyg
