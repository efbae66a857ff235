// The step limit at rest: the smallest stable step over all waves q = (qx, qy) in [0, pi]^2 that the lattice carries.
// Springs along one axis give 2 k (1 - cos q) there; both diagonals together give the shear terms below.
#include "study/stability.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace tyg {
namespace {

/// 1 - cos q without the cancellation near q = 0, where explicit Euler's limit d / w2 lives.
double oneMinusCos(double q) {
  const double s = std::sin(q / 2);
  return 2 * s * s;
}

/// A symmetric 2x2 matrix.
struct Symbol {
  double xx = 0, yy = 0, xy = 0;

  /// Larger and smaller eigenvalue.
  [[nodiscard]] std::array<double, 2> eigenvalues() const {
    const double mean = (xx + yy) / 2, radius = std::hypot((xx - yy) / 2, xy);
    return {mean + radius, std::max(0.0, mean - radius)};
  }
  /// The unit eigenvector of the larger eigenvalue.
  [[nodiscard]] std::array<double, 2> direction() const {
    const double angle = std::atan2(2 * xy, xx - yy) / 2;
    return {std::cos(angle), std::sin(angle)};
  }
  [[nodiscard]] double along(const std::array<double, 2>& u) const {
    return xx * u[0] * u[0] + yy * u[1] * u[1] + 2 * xy * u[0] * u[1];
  }
};

/// One constant (stiffness or damping) of every family that the sheet has room for, over the particle mass.
struct Lattice {
  double structuralX = 0, structuralY = 0, shear = 0, bendX = 0, bendY = 0;

  Lattice(const Scene& scene, double SpringFamily::*constant) {
    const double perMass = 1 / scene.particleMass;
    const bool wide = scene.columns > 1, tall = scene.rows > 1;
    if (wide) structuralX = scene.structural.*constant * perMass;
    if (tall) structuralY = scene.structural.*constant * perMass;
    if (wide && tall) shear = scene.shear.*constant * perMass;
    if (scene.columns > 2) bendX = scene.bend.*constant * perMass;
    if (scene.rows > 2) bendY = scene.bend.*constant * perMass;
  }

  /// In-plane symbol: what springs that act along themselves do to a wave.
  [[nodiscard]] Symbol inPlane(double qx, double qy) const {
    const double x = oneMinusCos(qx), y = oneMinusCos(qy);
    const double diagonal = 2 * shear * (x + y - x * y);  // 1 - cos qx cos qy
    return {2 * structuralX * x + diagonal + 2 * bendX * oneMinusCos(2 * qx),
            2 * structuralY * y + diagonal + 2 * bendY * oneMinusCos(2 * qy), 2 * shear * std::sin(qx) * std::sin(qy)};
  }
  /// The same in every direction: what the relative law's damping does.
  [[nodiscard]] double everyWay(double qx, double qy) const {
    const double x = oneMinusCos(qx), y = oneMinusCos(qy);
    return 2 * structuralX * x + 2 * structuralY * y + 4 * shear * (x + y - x * y) + 2 * bendX * oneMinusCos(2 * qx) +
           2 * bendY * oneMinusCos(2 * qy);
  }
};

/// The smallest stable step of a method over the modes of one wave.
class WaveLimit {
 public:
  WaveLimit(const Scene& scene, const Method& method)
      : stiffness_(scene, &SpringFamily::ks),
        damping_(scene, &SpringFamily::kd),
        drag_(scene.drag / scene.particleMass),
        law_(scene.damping),
        stableStep_(method.stableStep) {}

  [[nodiscard]] double operator()(double qx, double qy) const {
    return law_ == Damping::Relative ? relative(qx, qy) : axial(qx, qy);
  }

 private:
  /// Out of plane the springs at rest do not pull, and only the damping is left.
  [[nodiscard]] double relative(double qx, double qy) const {
    const double d = drag_ + damping_.everyWay(qx, qy);
    const auto [fast, slow] = stiffness_.inPlane(qx, qy).eigenvalues();
    return std::min({stableStep_(fast, d), stableStep_(slow, d), stableStep_(0, d)});
  }

  /// Damping and stiffness need not share their eigenvectors. Each mode is tried with the largest damping of its wave,
  /// which errs on the safe side where damping costs steps, and with the damping of its own direction, which is the
  /// exact one where the eigenvectors agree and the one that counts where damping is what keeps a method stable.
  [[nodiscard]] double axial(double qx, double qy) const {
    const Symbol pull = stiffness_.inPlane(qx, qy), damp = damping_.inPlane(qx, qy);
    const auto [fast, slow] = pull.eigenvalues();
    const double most = drag_ + damp.eigenvalues()[0];
    const std::array<double, 2> u = pull.direction();
    const double dFast = drag_ + damp.along(u), dSlow = drag_ + damp.along({-u[1], u[0]});
    return std::min({stableStep_(fast, most), stableStep_(slow, most), stableStep_(fast, dFast),
                     stableStep_(slow, dSlow), stableStep_(0, drag_)});
  }

  Lattice stiffness_, damping_;
  double drag_;
  Damping law_;
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

}  // namespace

double restLatticeLimit(const Scene& scene, const Method& method) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  if (method.stableStep == nullptr) return kNone;
  constexpr int kIntervals = 16;
  constexpr double kStride = std::numbers::pi / kIntervals;
  const WaveLimit limit(scene, method);

  // A lattice of one row or column carries waves along itself only.
  const int lastX = scene.columns > 1 ? kIntervals : 0, lastY = scene.rows > 1 ? kIntervals : 0;
  std::vector<Wave> waves;
  for (int j = 0; j <= lastY; ++j) {
    for (int i = 0; i <= lastX; ++i) waves.push_back({i * kStride, j * kStride, limit(i * kStride, j * kStride)});
  }
  constexpr std::size_t kStarts = 3;
  const std::size_t starts = std::min(kStarts, waves.size());
  const auto lowerFirst = [](const Wave& a, const Wave& b) { return a.limit < b.limit; };
  std::ranges::partial_sort(waves, waves.begin() + static_cast<std::ptrdiff_t>(starts), lowerFirst);
  double smallest = waves.front().limit;
  for (std::size_t k = 0; k < starts; ++k) smallest = std::min(smallest, refined(limit, waves[k], kStride / 2).limit);
  return std::isfinite(smallest) ? smallest : kNone;
}

}  // namespace tyg
