// Where a sheet passes through itself: nothing in the model keeps its parts from doing so.
// Must not know: simulations, words of reports.
#pragma once

#include <optional>
#include <span>

#include "tyg/sheet.h"

namespace tyg {

/// Two cells, an edge of the first of which passes through the other. Each by the column and the row of the particle at
/// its upper left corner.
struct CrossingCells {
  int column = 0, row = 0, otherColumn = 0, otherRow = 0;
};

/// The first of the cells, row by row, that passes through another; nothing where none does. Each cell is two
/// triangles, cut from its upper right to its lower left corner, and passes through another where one of its edges
/// meets the inside of one of these; touching, and lying in one plane, does not count. Cells that share a corner are
/// not compared, and cells that were cut are not there. `positions`: of every particle, m; crossings with numbers that
/// are not finite are none. Time: n log n in the number of cells, unless most of the sheet lies in one place.
std::optional<CrossingCells> firstCrossing(const Sheet& sheet, std::span<const Vec3> positions);

}  // namespace tyg
