// Every finer sheet is run once, and thinned to the particles that the scene's own sheet has too.
#include "study/motion/refinement.h"

#include <algorithm>
#include <string>

#include "core/scene/bodies.h"
#include "tyg/methods.h"

namespace tyg {
namespace {

/// Far below any distance between two sheets, and cheap.
constexpr double kTolerance = 1e-6;  // of the size

/// Intervals of the finer side for one of the coarse one; 0 where they do not fit.
int ratio(int coarse, int fine) {
  if (coarse == 1) return fine == 1 ? 1 : 0;
  return (fine - 1) % (coarse - 1) == 0 ? (fine - 1) / (coarse - 1) : 0;
}

std::string gridText(int columns, int rows) { return std::to_string(columns) + "x" + std::to_string(rows); }

int refinementOf(const Scene& scene, const Grid& grid) {
  const int across = ratio(scene.columns, grid.columns), down = ratio(scene.rows, grid.rows);
  if (scene.columns == 1) return grid.columns == 1 ? down : 0;
  if (scene.rows == 1) return grid.rows == 1 ? across : 0;
  return across == down ? across : 0;
}

/// The samples of those particles of the finer sheet that the coarse one has too.
SampledMotion thinned(const SampledMotion& fine, const Scene& scene, const Grid& grid) {
  const int every = refinementOf(scene, grid);
  SampledMotion coarse;
  coarse.times = fine.times;
  for (const std::vector<Vec3>& all : fine.positions) {
    std::vector<Vec3>& kept = coarse.positions.emplace_back();
    for (int row = 0; row < scene.rows; ++row) {
      for (int column = 0; column < scene.columns; ++column) {
        kept.push_back(all[static_cast<std::size_t>(row * every * grid.columns + column * every)]);
      }
    }
  }
  return coarse;
}

}  // namespace

void checkFiner(const Scene& scene, const Grid& grid) {
  if (refinementOf(scene, grid) >= 1) return;
  const auto finer = [](int count, int by) { return count == 1 ? 1 : by * (count - 1) + 1; };
  throw InputError("--sheets: found " + gridText(grid.columns, grid.rows) +
                   ", allowed are sheets that hold every particle of the " + gridText(scene.columns, scene.rows) +
                   " one, such as " + gridText(finer(scene.columns, 2), finer(scene.rows, 2)) + " or " +
                   gridText(finer(scene.columns, 4), finer(scene.rows, 4)));
}

std::vector<SheetDistance> sheetDistances(const Scene& scene, const SampledMotion& motion,
                                          const std::vector<Grid>& grids, int threads,
                                          const std::function<bool(double)>& observer) {
  double work = 0, done = 0;
  const auto workOf = [](const Grid& grid) {
    return double(grid.columns) * grid.rows * std::max(grid.columns, grid.rows);
  };
  for (const Grid& grid : grids) work += workOf(grid);
  std::vector<SheetDistance> distances;
  for (const Grid& grid : grids) {
    Scene fine = withSheet(scene, grid.columns, grid.rows);
    fine.precision = Precision::Double;
    fine.tolerance = std::min(kTolerance * makeSheet(scene).size(), largestTolerance(fine));
    const auto share = workOf(grid) / work;
    const SampledMotion run = sampledRun(
        fine, findMethod("dopri54"), motion.times,
        {.threads = threads, .observer = [&](double time) { return observer(done + share * time / scene.duration); }});
    if (run.stopped) return distances;
    distances.push_back({grid, motionError(thinned(run, scene, grid), motion)});
    done += share;
  }
  return distances;
}

}  // namespace tyg
