// Runs whose error stops meaning something before their end: which they are, and what can still be said of them.
// Must not know: how rows come about, how they are drawn.
#pragma once

#include <string>
#include <vector>

#include "study/motion/bulk.h"
#include "study/work/work_rows.h"

namespace tyg {

/// A row with a horizon shorter than its run, and how far its sheet as a whole is from the reference's after it.
struct PastHorizon {
  WorkRow row;
  BulkDistance distance;
  BulkDistance band;  ///< the same for the reference's twin: what a disturbance too small to be seen makes of the sheet
};

/// As CSV:
/// scene,integrator,precision,dt,tolerance,horizon_s,centre_m,centre_band_m,gyration_m,gyration_band_m,energy_J,
/// energy_band_J.
std::string pastHorizonCsv(const std::vector<PastHorizon>& runs);

/// One line for each precision: of how many runs the horizon was passed, how far they are at most from the reference as
/// wholes, how far the twin is, and how many runs are no further than it.
std::vector<std::string> pastHorizonLines(const std::vector<PastHorizon>& runs);

/// One line for each precision in which some run of `duration` seconds has a shorter horizon: from when to when.
std::vector<std::string> horizonLines(const std::vector<WorkRow>& rows, double duration);

}  // namespace tyg
