// What the rows and the chart of trajectories both need.
#pragma once

#include "study/charts/trajectory_plot.h"

namespace tyg {

/// How far a run's particle is from the finest run's at the same sample, m; NaN where the finest run ended before.
double distanceFromFinest(const TrajectoryStudy& study, std::size_t run, std::size_t particle, std::size_t time);

}  // namespace tyg
