// Which grids a sheet may be computed on so that both of its sides stay: cells stay square.
// Must not know: where the numbers come from, windows.
#pragma once

#include <string>
#include <vector>

#include "tyg/scene.h"

namespace tyg {

struct Grid {
  int columns = 1, rows = 1;
  bool operator==(const Grid&) const = default;
};

/// Whether the grid has the sides of the scene's sheet, to within half a cell. Both must have more than one particle.
bool keepsSides(const Scene& scene, const Grid& grid);
/// The grid with these columns, and the one with these rows, that keep the sides and have no count above `most`; where
/// there is none, the sheet's own. `grid` must have counts of at least 1, the sheet more than one particle.
std::vector<Grid> nearestGrids(const Scene& scene, const Grid& grid, int most);
/// A sentence about a grid that does not keep the sides, with those that do.
std::string otherSides(const Scene& scene, const Grid& grid, int most);

}  // namespace tyg
