// A coarse grid over all waves finds the valleys of the function, and a descent from the deepest of them the lowest
// point.
#include "study/limits/wave_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

namespace tyg {
namespace {

/// Goes downhill from `best` in strides that shrink. The error of the value is of second order in the last stride.
LowestWave refined(const WaveFunction& function, LowestWave best, double stride) {
  constexpr double kLastStride = 1e-4;
  constexpr int kMostMoves = 10000;  // hundreds are usual
  const auto inside = [](double q) { return std::clamp(q, 0.0, std::numbers::pi); };
  for (int move = 0; stride > kLastStride && move < kMostMoves; ++move) {
    LowestWave next = best;
    for (const auto& [dx, dy] : {std::array{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}, {1, -1}, {-1, 1}}) {
      const double qx = inside(best.qx + dx * stride), qy = inside(best.qy + dy * stride);
      const double here = function(qx, qy);
      if (here < next.value) next = {qx, qy, here};
    }
    if (!(next.value < best.value)) stride /= 2;
    best = next;
  }
  return best;
}

/// The values on a coarse grid of waves, and which of them are lowest among their neighbours.
class WaveGrid {
 public:
  static constexpr int kIntervals = 16;
  static constexpr double kStride = std::numbers::pi / kIntervals;

  WaveGrid(const Lattice& lattice, const WaveFunction& function)
      : lastX_(lattice.wide() ? kIntervals : 0), lastY_(lattice.tall() ? kIntervals : 0) {
    lattice.forWaves(kIntervals, [&](double qx, double qy) { waves_.push_back({qx, qy, function(qx, qy)}); });
  }

  [[nodiscard]] std::vector<LowestWave> valleys() const {
    std::vector<LowestWave> found;
    for (int j = 0; j <= lastY_; ++j) {
      for (int i = 0; i <= lastX_; ++i) {
        if (isLowest(i, j)) found.push_back(at(i, j));
      }
    }
    return found;
  }

 private:
  [[nodiscard]] const LowestWave& at(int i, int j) const {
    return waves_[static_cast<std::size_t>(j * (lastX_ + 1) + i)];
  }
  [[nodiscard]] bool isLowest(int i, int j) const {
    for (int row = std::max(0, j - 1); row <= std::min(lastY_, j + 1); ++row) {
      for (int column = std::max(0, i - 1); column <= std::min(lastX_, i + 1); ++column) {
        if (at(column, row).value < at(i, j).value) return false;
      }
    }
    return true;
  }

  int lastX_, lastY_;
  std::vector<LowestWave> waves_;
};

}  // namespace

LowestWave lowestWave(const Lattice& lattice, const WaveFunction& values) {
  // What is no number is nowhere lowest: comparing it would neither sort the valleys nor end the descent.
  const WaveFunction function = [&](double qx, double qy) {
    const double value = values(qx, qy);
    return std::isnan(value) ? std::numeric_limits<double>::infinity() : value;
  };
  std::vector<LowestWave> valleys = WaveGrid(lattice, function).valleys();
  // The deepest few: a shallow valley does not become the deepest one between two grid points.
  constexpr std::size_t kStarts = 4;
  std::ranges::sort(valleys, {}, &LowestWave::value);
  valleys.resize(std::min(kStarts, valleys.size()));
  LowestWave lowest;
  lowest.value = std::numeric_limits<double>::infinity();
  for (const LowestWave& valley : valleys) {
    const LowestWave bottom = refined(function, valley, WaveGrid::kStride / 2);
    if (bottom.value < lowest.value) lowest = bottom;
  }
  return lowest;
}

}  // namespace tyg
