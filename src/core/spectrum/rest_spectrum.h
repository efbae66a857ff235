// The spectrum of the finite sheet at rest, with its edges and pins: what the waves of the unbounded lattice only
// bound. Must not know: moving states, measured limits.
#pragma once

#include <complex>
#include <memory>
#include <optional>
#include <vector>

#include "core/spectrum/lattice.h"
#include "core/spectrum/level_line.h"
#include "tyg/scene.h"

namespace tyg {

/// x'' = -K x - C x' for small motions of the particles that are free, out of and in the plane of the sheet apart.
class RestSpectrum {
 public:
  static constexpr int kMostParticles = 16 * 16;  ///< a few hundredths of a second; beyond, edges hardly matter
  static constexpr int kMostDense = 64;           ///< particles up to which all eigenvalues are worked out

  /// Takes up to a second for 64 x 64 particles.
  explicit RestSpectrum(const Scene& scene);
  /// A scene of at most kMostParticles particles whose spectrum is that of the scene's own sheet: the scene itself
  /// where it is small enough, a shorter piece of a long and narrow sheet; nothing where the unbounded lattice is
  /// right.
  static std::optional<Scene> smallSheet(const Scene& scene);

  /// The in-plane motion u of unit length with the largest u.(ofK K + ofC C) u, as the mode w2 = u.Ku, d = u.Cu; by a
  /// Lanczos iteration (Lanczos 1950) that runs until it has converged.
  [[nodiscard]] Mode farthest(const LineNormal& normal) const;
  /// The largest damping out of the plane, where springs at rest do not pull.
  [[nodiscard]] Mode mostDampedOutOfPlane() const;
  /// The largest u.Ku / u.Cu of any in-plane motion, 1/s: no mode has more stiffness for its damping. Infinite where a
  /// motion has stiffness alone. For a sheet of at most kMostDense particles.
  [[nodiscard]] double mostStiffnessPerDamping() const;
  /// All roots mu of the motions like exp(mu t), 1/s, of a sheet of at most kMostDense particles.
  [[nodiscard]] std::vector<std::complex<double>> roots() const;
  /// Approximations to the roots of in-plane motions, in one of which those that lie outermost in the complex plane,
  /// and so leave a method's region first, are right to about a thousandth; for a sheet of any size.
  [[nodiscard]] std::vector<std::complex<double>> outerRoots() const;
  static constexpr int kMostProducts = 80;  ///< with K and C, of outerRoots()

 private:
  [[nodiscard]] double fastestRate() const;

  struct Matrices;  // Eigen's, which nobody else needs to compile
  std::shared_ptr<const Matrices> matrices_;
};

}  // namespace tyg
