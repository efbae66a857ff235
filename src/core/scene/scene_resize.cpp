// The same cloth on another grid: its size and mass stay, and pins and pushes go to the nearest particles.
// Must not know: files, simulations.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/forces/parameter.h"
#include "tyg/scene.h"
#include "tyg/sheet.h"

namespace tyg {
namespace {

/// The index that lies nearest to the same fraction of the way; a single column or row becomes the first.
int scaled(int index, int oldCount, int newCount) {
  if (oldCount == 1) return 0;
  return static_cast<int>(std::lround(double(index) * (newCount - 1) / (oldCount - 1)));
}

}  // namespace

Scene withSheet(Scene scene, int columns, int rows) {
  if (columns < 1 || rows < 1 || columns > kLargestCount || rows > kLargestCount) {
    throw InputError(
        fmt::format("sheet: found {}x{}, allowed 1x1 to {}x{}", columns, rows, kLargestCount, kLargestCount));
  }
  if (columns == scene.columns && rows == scene.rows) return scene;
  const int oldLongest = std::max(scene.columns, scene.rows), newLongest = std::max(columns, rows);
  if (oldLongest == 1 || newLongest == 1) {
    throw InputError(fmt::format(
        "sheet: found {}x{} to be made {}x{}, allowed sheets of at least two particles: a single one has no "
        "size to keep",
        scene.columns, scene.rows, columns, rows));
  }

  const auto rescale = [&](Place& place) {
    if (!place.name.empty()) return;
    place.column = scaled(place.column, scene.columns, columns);
    place.row = scaled(place.row, scene.rows, rows);
  };
  for (Place& pin : scene.pins) rescale(pin);
  for (Displacement& displacement : scene.displacements) rescale(displacement.particle);
  for (Push& push : scene.pushes) rescale(push.particle);
  for (Move& move : scene.moves) std::ranges::for_each(move.what, rescale);

  // Cuts lie between particles: they are not rounded.
  const double across = scene.columns > 1 ? double(columns - 1) / (scene.columns - 1) : 1;
  const double down = scene.rows > 1 ? double(rows - 1) / (scene.rows - 1) : 1;
  for (auto& [line, at] : scene.cuts) {
    line = {across * line.fromColumn, down * line.fromRow, across * line.toColumn, down * line.toRow};
  }

  const double oldCount = double(scene.columns) * scene.rows, newCount = double(columns) * rows;
  scene.spacing *= double(oldLongest - 1) / (newLongest - 1);
  scene.particleMass *= oldCount / newCount;
  for (const Parameter& parameter : liveParameters()) {
    if (!parameter.isShareOfSheet) continue;
    const Vec3 share = parameter.get(scene);
    const double factor = oldCount / newCount;
    parameter.set(scene, {share.x * factor, share.y * factor, share.z * factor});
  }
  scene.columns = columns;
  scene.rows = rows;
  return scene;
}

}  // namespace tyg
