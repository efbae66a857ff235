// Largest stable steps for one mode x'' + d x' + w2 x = 0, from each method's amplification of it.
// Roots of the mode: mu = (-d +- sqrt(d^2 - 4 w2)) / 2.
#include <cmath>
#include <complex>
#include <limits>

#include "integrators/factories.h"
#include "integrators/report_rk4.h"

namespace tyg {
namespace {

constexpr double kEveryStep = std::numeric_limits<double>::infinity();

using Complex = std::complex<double>;

/// The root of larger magnitude (either of a complex pair), 1/s.
Complex fastRoot(double w2, double d) {
  const double discriminant = d * d - 4 * w2;
  if (discriminant >= 0) return {-(d + std::sqrt(discriminant)) / 2, 0};
  return {-d / 2, std::sqrt(-discriminant) / 2};
}

/// The positive root of w2 h^2 + b h = 4: where |eigenvalues| of the step matrix reach 1.
double positiveRoot(double w2, double b) {
  if (w2 == 0 && b == 0) return kEveryStep;
  return 8 / (b + std::sqrt(b * b + 16 * w2));
}

/// |R(z)| of the classical Runge-Kutta method, R(z) = 1 + z + z^2/2 + z^3/6 + z^4/24.
double rk4Growth(const Complex& z) {
  return std::abs(1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0))));
}

}  // namespace

// |1 + h mu| <= 1. Complex pair: |1 + h mu|^2 = 1 - h d + h^2 w2, so h <= d / w2; real: h <= 2 / |mu|.
double stableStepExplicitEuler(double w2, double d) {
  const Complex mu = fastRoot(w2, d);
  if (mu.imag() != 0) return d / w2;
  return mu.real() == 0 ? kEveryStep : 2 / -mu.real();
}

// Step matrix: determinant 1 - h d, trace 2 - h d - h^2 w2; both eigenvalues within the unit circle while
// h^2 w2 + 2 h d <= 4.
double stableStepSymplecticEuler(double w2, double d) { return positiveRoot(w2, 2 * d); }

// With the damping at the predicted velocity: h^2 w2 + 4 h d <= 4, where h d = 1 bounds the pure damping mode.
double stableStepLeapfrog(double w2, double d) { return positiveRoot(w2, 4 * d); }

// Symplectic Euler's limit holds for the scaled step H(h); solved for h by Newton's method (H is convex).
double stableStepReportRk4(double w2, double d) {
  const double limit = stableStepSymplecticEuler(w2, d);
  if (limit == kEveryStep) return kEveryStep;
  double h = limit;
  for (int k = 0; k < 50; ++k) h -= (reportRk4Step(h) - limit) / (1 + h + h * h / 2 + h * h * h / 6);
  return h;
}

// |R(h mu)| <= 1 along the ray through mu, found by bisection: the region is star-shaped seen from 0.
double stableStepRk4(double w2, double d) {
  const Complex mu = fastRoot(w2, d);
  const double size = std::abs(mu);
  if (size == 0) return kEveryStep;
  const Complex direction = mu / size;
  constexpr double kRounding = 1e-12;
  double inside = 0, outside = 4;  // |R| exceeds 1 everywhere on |z| = 4, Re z <= 0
  for (int k = 0; k < 50; ++k) {
    const double middle = (inside + outside) / 2;
    (rk4Growth(middle * direction) <= 1 + kRounding ? inside : outside) = middle;
  }
  return inside / size;
}

}  // namespace tyg
