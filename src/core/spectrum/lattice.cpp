// Lattice symbols as 2x2 matrices of a wave in the plane, and what its springs do to it out of it.
#include "core/spectrum/lattice.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/forces/term.h"
#include "core/spectrum/eigenvalues.h"

namespace tyg {
namespace {

/// 1 - cos q without the cancellation near q = 0, where explicit Euler's limit d / w2 lives.
double oneMinusCos(double q) {
  const double s = std::sin(q / 2);
  return 2 * s * s;
}

}  // namespace

std::array<std::complex<double>, 2> rootsOf(const Mode& mode) {
  using Complex = std::complex<double>;
  const double discriminant = mode.discriminant();
  if (discriminant >= 0) {
    const double fast = -(mode.d + std::sqrt(discriminant)) / 2;
    return {Complex(fast, 0), Complex(fast < 0 ? mode.w2 / fast : 0, 0)};
  }
  const Complex upper(-mode.d / 2, std::sqrt(-discriminant) / 2);
  return {upper, std::conj(upper)};
}

/// A symmetric 2x2 matrix.
struct Lattice::Symbol {
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

Lattice::Lattice(const Scene& scene)
    : wide_(scene.columns > 1),
      tall_(scene.rows > 1),
      law_(scene.damping),
      particleDamping_(particleDamping(scene) / scene.particleMass),
      cellDamping_(wide_ && tall_ ? cellDamping(scene) / scene.particleMass : 0),
      stiffness_(constantsOf(scene, &SpringFamily::ks)),
      damping_(constantsOf(scene, &SpringFamily::kd)) {
  const ParticleHold hold = holdingTerm(scene).hold;
  heldStiffness_ = hold.times * hold.stiffness / scene.particleMass;
  heldDamping_ = hold.times * std::max(hold.damping, hold.across) / scene.particleMass;
}

Lattice::Constants Lattice::constantsOf(const Scene& scene, double SpringFamily::*constant) {
  const double perMass = 1 / scene.particleMass;
  const bool wide = scene.columns > 1, tall = scene.rows > 1;
  Constants k;
  if (wide) k.structuralX = scene.structural.*constant * perMass;
  if (tall) k.structuralY = scene.structural.*constant * perMass;
  if (wide && tall) k.shear = scene.shear.*constant * perMass;
  if (scene.columns > 2) k.bendX = scene.bend.*constant * perMass;
  if (scene.rows > 2) k.bendY = scene.bend.*constant * perMass;
  return k;
}

/// What springs that act along themselves do to a wave in the plane.
Lattice::Symbol Lattice::inPlane(const Constants& k, double qx, double qy) {
  const double x = oneMinusCos(qx), y = oneMinusCos(qy);
  const double diagonal = 2 * k.shear * (x + y - x * y);  // 1 - cos qx cos qy
  return {2 * k.structuralX * x + diagonal + 2 * k.bendX * oneMinusCos(2 * qx),
          2 * k.structuralY * y + diagonal + 2 * k.bendY * oneMinusCos(2 * qy),
          2 * k.shear * std::sin(qx) * std::sin(qy)};
}

/// The same in every direction: what the relative law's damping does.
double Lattice::everyWay(const Constants& k, double qx, double qy) {
  const double x = oneMinusCos(qx), y = oneMinusCos(qy);
  return 2 * k.structuralX * x + 2 * k.structuralY * y + 4 * k.shear * (x + y - x * y) +
         2 * k.bendX * oneMinusCos(2 * qx) + 2 * k.bendY * oneMinusCos(2 * qy);
}

double Lattice::ofCells(double qx, double qy) const {
  const double x = std::cos(qx / 2), y = std::cos(qy / 2);
  return cellDamping_ * x * x * y * y;
}

std::array<Mode, 5> Lattice::modes(double qx, double qy) const {
  const double air = ofCells(qx, qy);
  const Symbol pull = inPlane(stiffness_, qx, qy);
  const auto [fast, slow] = pull.eigenvalues();
  if (law_ == Damping::Relative) {
    const double d = particleDamping_ + everyWay(damping_, qx, qy);
    return {{{fast, d}, {slow, d}, {0, d + air}, {fast, d + air}, {slow, d + air}}};
  }
  const Symbol damp = inPlane(damping_, qx, qy);
  const double most = particleDamping_ + damp.eigenvalues()[0];
  const std::array<double, 2> u = pull.direction();
  const double dFast = particleDamping_ + damp.along(u), dSlow = particleDamping_ + damp.along({-u[1], u[0]});
  return {{{fast, most + air}, {slow, most + air}, {0, particleDamping_ + air}, {fast, dFast}, {slow, dSlow}}};
}

Lattice::Symbol Lattice::dampingInPlane(double qx, double qy) const {
  Symbol damp;
  if (law_ == Damping::Axial) {
    damp = inPlane(damping_, qx, qy);
  } else {
    damp.xx = damp.yy = everyWay(damping_, qx, qy);
  }
  damp.xx += particleDamping_, damp.yy += particleDamping_;
  return damp;
}

Mode Lattice::farthestInPlane(double ofK, double ofC, double qx, double qy) const {
  const Symbol K = inPlane(stiffness_, qx, qy), C = dampingInPlane(qx, qy);
  const Symbol sum{ofK * K.xx + ofC * C.xx, ofK * K.yy + ofC * C.yy, ofK * K.xy + ofC * C.xy};
  const std::array<double, 2> u = sum.direction();
  return {std::max(0.0, K.along(u)), std::max(0.0, C.along(u))};
}

/// The eigenvalues of (w x, v)' = (w v, -K x / w - C v), which has one unit with w the fastest rate.
std::array<std::complex<double>, 4> Lattice::rootsInPlane(double qx, double qy) const {
  const Symbol K = inPlane(stiffness_, qx, qy), C = dampingInPlane(qx, qy);
  const double w = std::sqrt(K.eigenvalues()[0]) + C.eigenvalues()[0];
  if (!(w > 0) || !std::isfinite(w)) return {};
  const std::array<double, 16> columns{0, 0, -K.xx / w, -K.xy / w, 0, 0, -K.xy / w, -K.yy / w,
                                       w, 0, -C.xx,     -C.xy,     0, w, -C.xy,     -C.yy};
  const std::vector<std::complex<double>> roots = eigenvaluesOf(columns, 4);
  return {roots[0], roots[1], roots[2], roots[3]};
}

}  // namespace tyg
