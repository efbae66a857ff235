// The step limit at rest: the smallest stable step over all waves q = (qx, qy) in [0, pi]^2 that the lattice carries.
#include "study/stability.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "core/lattice.h"

namespace tyg {
namespace {

/// The smallest stable step of a method over the modes of one wave.
class WaveLimit {
 public:
  WaveLimit(const Scene& scene, const Method& method) : lattice_(scene), stableStep_(method.stableStep) {}

  [[nodiscard]] const Lattice& lattice() const { return lattice_; }

  [[nodiscard]] double operator()(double qx, double qy) const {
    const std::array<Mode, 5> modes = lattice_.modes(qx, qy);
    const auto limit = [&](std::size_t k) { return stableStep_(modes.at(k).w2, modes.at(k).d); };
    double smallest = std::min({limit(0), limit(1), limit(2)});
    // The last two repeat the first two where a wave has one damping only.
    if (modes[3].d != modes[0].d) smallest = std::min(smallest, limit(3));
    if (modes[4].d != modes[1].d) smallest = std::min(smallest, limit(4));
    return smallest;
  }

 private:
  Lattice lattice_;
  double (*stableStep_)(double, double);
};

struct Wave {
  double qx = 0, qy = 0, limit = 0;
};

/// Walks downhill from `best` in shrinking strides. In `best.limit` the error is of second order in the last stride.
Wave refined(const WaveLimit& limit, Wave best, double stride) {
  constexpr double kLastStride = 1e-4;
  const auto inside = [](double q) { return std::clamp(q, 0.0, std::numbers::pi); };
  while (stride > kLastStride) {
    Wave next = best;
    for (const auto& [dx, dy] : {std::array{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}, {1, -1}, {-1, 1}}) {
      const double qx = inside(best.qx + dx * stride), qy = inside(best.qy + dy * stride);
      const double here = limit(qx, qy);
      if (here < next.limit) next = {qx, qy, here};
    }
    if (next.limit == best.limit) stride /= 2;
    best = next;
  }
  return best;
}

/// The limits on a coarse grid of waves, and which of them are lowest among their neighbours.
class WaveGrid {
 public:
  static constexpr int kIntervals = 16;
  static constexpr double kStride = std::numbers::pi / kIntervals;

  explicit WaveGrid(const WaveLimit& limit)
      : lastX_(limit.lattice().wide() ? kIntervals : 0), lastY_(limit.lattice().tall() ? kIntervals : 0) {
    for (int j = 0; j <= lastY_; ++j) {
      for (int i = 0; i <= lastX_; ++i) waves_.push_back({i * kStride, j * kStride, limit(i * kStride, j * kStride)});
    }
  }

  [[nodiscard]] std::vector<Wave> valleys() const {
    std::vector<Wave> found;
    for (int j = 0; j <= lastY_; ++j) {
      for (int i = 0; i <= lastX_; ++i) {
        if (isLowest(i, j)) found.push_back(at(i, j));
      }
    }
    return found;
  }

 private:
  [[nodiscard]] const Wave& at(int i, int j) const { return waves_[static_cast<std::size_t>(j * (lastX_ + 1) + i)]; }
  [[nodiscard]] bool isLowest(int i, int j) const {
    for (int row = std::max(0, j - 1); row <= std::min(lastY_, j + 1); ++row) {
      for (int column = std::max(0, i - 1); column <= std::min(lastX_, i + 1); ++column) {
        if (at(column, row).limit < at(i, j).limit) return false;
      }
    }
    return true;
  }

  int lastX_, lastY_;
  std::vector<Wave> waves_;
};

}  // namespace

double restLatticeLimit(const Scene& scene, const Method& method) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const auto finite = [](double step) { return std::isfinite(step) ? step : kNone; };
  if (method.stableStepOfScene != nullptr) return finite(method.stableStepOfScene(scene));
  if (method.stableStep == nullptr) return kNone;
  const WaveLimit limit(scene, method);
  std::vector<Wave> valleys = WaveGrid(limit).valleys();
  // The deepest few: a shallow valley does not become the deepest one between two grid points.
  constexpr std::size_t kStarts = 4;
  std::ranges::sort(valleys, {}, &Wave::limit);
  valleys.resize(std::min(kStarts, valleys.size()));
  double smallest = std::numeric_limits<double>::infinity();
  for (const Wave& valley : valleys) smallest = std::min(smallest, refined(limit, valley, WaveGrid::kStride / 2).limit);
  return finite(smallest);
}

}  // namespace tyg
