// Bilinear interpolation between the particles of a grid, in whole numbers as far as they go.
#include "study/motion/resampled.h"

#include <algorithm>

namespace tyg {
namespace {

/// Of `from` columns (or rows), the two that the k-th of `to` lies between, and the fraction of the distance to the
/// second.
struct Between {
  int first = 0, second = 0;
  double share = 0;
};

Between between(int k, int to, int from) {
  if (to == 1 || from == 1) return {};
  // In whole numbers, so that particles that both grids have are met exactly.
  const int scaled = k * (from - 1), first = scaled / (to - 1);
  return {first, std::min(first + 1, from - 1), static_cast<double>(scaled % (to - 1)) / (to - 1)};
}

Vec3 mixed(const Vec3& a, const Vec3& b, double share) {
  if (share == 0) return a;
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y), a.z + share * (b.z - a.z)};
}

}  // namespace

SampledMotion resampled(const SampledMotion& motion, const Scene& from, const Scene& to) {
  SampledMotion other = motion;
  if (from.columns == to.columns && from.rows == to.rows) return other;
  for (std::vector<Vec3>& positions : other.positions) {
    const std::vector<Vec3> old = std::move(positions);
    const auto at = [&](int column, int row) { return old[static_cast<std::size_t>(row * from.columns + column)]; };
    positions.clear();
    for (int r = 0; r < to.rows; ++r) {
      const Between row = between(r, to.rows, from.rows);
      for (int c = 0; c < to.columns; ++c) {
        const Between column = between(c, to.columns, from.columns);
        const Vec3 above = mixed(at(column.first, row.first), at(column.second, row.first), column.share);
        const Vec3 below = mixed(at(column.first, row.second), at(column.second, row.second), column.share);
        positions.push_back(mixed(above, below, row.share));
      }
    }
  }
  return other;
}

SampledMotion upTo(double time, SampledMotion motion) {
  const auto end = std::ranges::upper_bound(motion.times, time);
  const auto count = static_cast<std::size_t>(end - motion.times.begin());
  motion.times.resize(count);
  motion.positions.resize(std::min(count, motion.positions.size()));
  return motion;
}

}  // namespace tyg
