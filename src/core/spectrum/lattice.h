// The waves of a sheet at rest, taken as unbounded: how fast each oscillates and how strongly it is damped.
// Must not know: methods, deformed states. Pins and edges can only make the true spectrum smaller.
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <limits>
#include <numbers>

#include "tyg/scene.h"

namespace tyg {

/// x'' + d x' + w2 x = 0.
struct Mode {
  double w2 = 0;  ///< 1/s2
  double d = 0;   ///< 1/s

  /// Negative: the mode oscillates; else it creeps back.
  [[nodiscard]] double discriminant() const { return d * d - 4 * w2; }
};

/// The two mu = (-d +- sqrt(d^2 - 4 w2)) / 2 of a mode's motions exp(mu t), 1/s: of real ones the faster first, the
/// other from their product w2, where the difference would cancel; of a pair the one above the real axis first.
std::array<std::complex<double>, 2> rootsOf(const Mode& mode);

/// A wave of the lattice by its phases from column to column and from row to row, in [0, pi], and one of its modes.
struct LatticeWave {
  double qx = 0, qy = 0;
  Mode mode;
};

/// The lattice symbols of a scene (docs/model.md, section 8): springs along one axis give 2 k (1 - cos q) there; both
/// diagonals together give the shear terms. Only springs that the sheet has room for count.
class Lattice {
 public:
  explicit Lattice(const Scene& scene);

  /// A lattice of one row or column carries waves along itself only.
  [[nodiscard]] bool wide() const { return wide_; }
  [[nodiscard]] bool tall() const { return tall_; }

  /// Calls `visit(qx, qy)` for the waves of a grid of `intervals` + 1 phases an axis over [0, pi], row by row.
  template <class Visit>
  void forWaves(int intervals, const Visit& visit) const {
    const double stride = std::numbers::pi / intervals;
    for (int j = 0; j <= (tall_ ? intervals : 0); ++j) {
      for (int i = 0; i <= (wide_ ? intervals : 0); ++i) visit(i * stride, j * stride);
    }
  }

  /// The modes of the wave with phase qx from column to column and qy from row to row, each in [0, pi]. In plane two;
  /// out of plane springs at rest do not pull and only damping is left. Under the axial law damping and stiffness need
  /// not share their eigenvectors: each in-plane mode then comes twice, with the largest damping of its wave, which
  /// errs on the safe side where damping costs steps, and with the damping of its own direction, which is exact where
  /// the eigenvectors agree and counts where damping is what keeps a method stable.
  [[nodiscard]] std::array<Mode, 5> modes(double qx, double qy) const;
  static constexpr std::size_t kOutOfPlane = 2;  ///< of modes()

  /// Of the motions of this wave in the plane, whatever the law: the unit vector u with the largest u.(ofK K + ofC C)
  /// u, as the mode w2 = u.Ku, d = u.Cu.
  [[nodiscard]] Mode farthestInPlane(double ofK, double ofC, double qx, double qy) const;
  /// The roots mu of the motions like exp(mu t) of this wave in the plane, 1/s.
  [[nodiscard]] std::array<std::complex<double>, 4> rootsInPlane(double qx, double qy) const;

  /// A mode that no motion of this wave exceeds in stiffness or damping, however the sheet is deformed: a spring pulls
  /// with no more than ks in every direction (its Hessian never exceeds ks times the graph Laplacian), and either law
  /// of damping with no more than kd; contact adds no more than every body at once (docs/model.md, section 8).
  [[nodiscard]] Mode anyDeformation(double qx, double qy) const {
    return {heldStiffness_ + everyWay(stiffness_, qx, qy),
            heldDamping_ + particleDamping_ + everyWay(damping_, qx, qy) + ofCells(qx, qy)};
  }

 private:
  /// One constant (stiffness or damping) of every family, over the particle mass.
  struct Constants {
    double structuralX = 0, structuralY = 0, shear = 0, bendX = 0, bendY = 0;
  };
  struct Symbol;
  static Constants constantsOf(const Scene& scene, double SpringFamily::*constant);
  static Symbol inPlane(const Constants& k, double qx, double qy);
  [[nodiscard]] Symbol dampingInPlane(double qx, double qy) const;
  static double everyWay(const Constants& k, double qx, double qy);

  /// 1/s: a cell moves with the mean of its corners, and only along its normal.
  [[nodiscard]] double ofCells(double qx, double qy) const;

  bool wide_, tall_;
  Damping law_;
  double particleDamping_, cellDamping_;        // 1/s
  double heldStiffness_ = 0, heldDamping_ = 0;  // 1/s2 and 1/s, of what holds single particles, at most
  Constants stiffness_, damping_;
};

/// The wave, among those of a grid, and the mode of it that reaches farthest by a measure of modes.
template <class Measure>
LatticeWave extremeWave(const Lattice& lattice, const Measure& reach) {
  constexpr int kIntervals = 16;
  LatticeWave best;
  double farthest = -std::numeric_limits<double>::infinity();
  lattice.forWaves(kIntervals, [&](double qx, double qy) {
    for (const Mode& mode : lattice.modes(qx, qy)) {
      if (reach(mode) <= farthest) continue;
      farthest = reach(mode);
      best = {qx, qy, mode};
    }
  });
  return best;
}

}  // namespace tyg
