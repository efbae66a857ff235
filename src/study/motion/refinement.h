// How far a sheet is from finer sheets of the same cloth: what an error in time has to be compared with.
// Must not know: methods under study, charts, clocks.
#pragma once

#include <functional>
#include <vector>

#include "study/motion/error.h"

namespace tyg {

struct Grid {
  int columns = 1, rows = 1;
};

/// A finer sheet, and its largest distance over the sample times from the scene's own sheet, over the particles
/// that both have.
struct SheetDistance {
  Grid grid;
  Distance distance;  ///< m; NaN where the finer sheet's run failed
};

/// Throws InputError where a grid does not hold every particle of the scene's sheet: each side must have the same whole
/// number of intervals for one of the scene's.
void checkFiner(const Scene& scene, const Grid& grid);

/// `motion` is the scene's, sampled at sampleTimes(scene). `observer` gets the fraction done and may return false to
/// stop; the grids finished so far are then given back.
std::vector<SheetDistance> sheetDistances(const Scene& scene, const SampledMotion& motion,
                                          const std::vector<Grid>& grids, int threads,
                                          const std::function<bool(double fraction)>& observer);

}  // namespace tyg
