// A grid is described by its cells: one less a side than particles.
#include "core/scene/same_sides.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "util/text.h"

namespace tyg {

bool keepsSides(const Scene& scene, const Grid& grid) {
  const double wide = scene.columns - 1, tall = scene.rows - 1;
  const double cell = std::max(wide, tall) / std::max({grid.columns - 1, grid.rows - 1, 1});
  constexpr double kHalf = 0.5 + 1e-9;
  return std::abs((grid.columns - 1) * cell - wide) <= kHalf * cell &&
         std::abs((grid.rows - 1) * cell - tall) <= kHalf * cell;
}

std::vector<Grid> nearestGrids(const Scene& scene, const Grid& grid, int most) {
  std::vector<Grid> fitting;
  const auto offer = [&](double columns, double rows) {
    if (!(columns >= 1 && columns <= most && rows >= 1 && rows <= most)) return;
    const Grid offered{int(columns), int(rows)};
    if (keepsSides(scene, offered) && std::ranges::find(fitting, offered) == fitting.end()) fitting.push_back(offered);
  };
  const double tallness = double(scene.rows - 1) / std::max(scene.columns - 1, 1);
  const double width = double(scene.columns - 1) / std::max(scene.rows - 1, 1);
  offer(grid.columns, std::round((grid.columns - 1) * tallness) + 1);
  offer(std::round((grid.rows - 1) * width) + 1, grid.rows);
  if (fitting.empty()) fitting.push_back({scene.columns, scene.rows});
  return fitting;
}

std::string otherSides(const Scene& scene, const Grid& grid, int most) {
  std::vector<std::string> names;
  for (const Grid& fitting : nearestGrids(scene, grid, most)) {
    names.push_back(fmt::format("{}x{}", fitting.columns, fitting.rows));
  }
  return fmt::format(
      "found {}x{}, which is not the shape of a sheet of {}x{} particles; allowed are grids with its sides, the "
      "nearest "
      "of which {} {}",
      grid.columns, grid.rows, scene.columns, scene.rows, names.size() > 1 ? "are" : "is", joined(names));
}

}  // namespace tyg
