// Largest stable steps for one mode x'' + d x' + w2 x = 0, from each method's amplification of it.
// Roots of the mode: mu = (-d +- sqrt(d^2 - 4 w2)) / 2.
#include <cmath>
#include <complex>
#include <limits>
#include <span>

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

/// Coefficients of z^0, z^1, ... in the growth R(z) of y' = mu y over a step with z = h mu.
constexpr double kRk4[] = {1, 1, 1.0 / 2, 1.0 / 6, 1.0 / 24};
constexpr double kBs32[] = {1, 1, 1.0 / 2, 1.0 / 6};
constexpr double kDopri54[] = {1, 1, 1.0 / 2, 1.0 / 6, 1.0 / 24, 1.0 / 120, 1.0 / 600};

double growth(std::span<const double> polynomial, const Complex& z) {
  Complex sum = 0;
  for (std::size_t k = polynomial.size(); k-- > 0;) sum = sum * z + polynomial[k];
  return std::abs(sum);
}

/// The first h with |R(h mu)| > 1 along the ray through mu: outward in small strides, then by bisection.
double rungeKuttaLimit(std::span<const double> polynomial, double w2, double d) {
  const Complex mu = fastRoot(w2, d);
  const double size = std::abs(mu);
  if (size == 0) return kEveryStep;
  if (!std::isfinite(size)) return 0;
  const Complex direction = mu / size;
  constexpr double kRounding = 1e-12, kStride = 0.05;
  const auto grows = [&](double radius) { return growth(polynomial, radius * direction) > 1 + kRounding; };
  double outside = kStride;
  while (!grows(outside)) outside += kStride;
  double inside = outside - kStride;
  for (int k = 0; k < 40; ++k) {
    const double middle = (inside + outside) / 2;
    (grows(middle) ? outside : inside) = middle;
  }
  return inside / size;
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

double stableStepRk4(double w2, double d) { return rungeKuttaLimit(kRk4, w2, d); }
double stableStepBs32(double w2, double d) { return rungeKuttaLimit(kBs32, w2, d); }
double stableStepDopri54(double w2, double d) { return rungeKuttaLimit(kDopri54, w2, d); }

// Damping by the midpoint rule only ever shrinks a mode; the springs alone set h^2 w2 <= 4.
double stableStepImex(double w2, double /*d*/) { return positiveRoot(w2, 0); }

}  // namespace tyg
