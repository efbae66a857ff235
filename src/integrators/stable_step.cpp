// Limits of a single mode: in closed form where its roots allow that, else outward along the ray through the root until
// a step makes the mode grow.
#include "integrators/stable_step.h"

#include <cmath>
#include <complex>

#include "core/spectrum/lattice.h"

namespace tyg {
namespace {

using Complex = std::complex<double>;

double sizeOf(std::span<const double> growth, const Complex& z) {
  Complex sum = 0;
  for (std::size_t k = growth.size(); k-- > 0;) sum = sum * z + growth[k];
  return std::abs(sum);
}

}  // namespace

double positiveRoot(double w2, double b) {
  if (w2 == 0 && b == 0) return kEveryStep;
  return 8 / (b + std::sqrt(b * b + 16 * w2));
}

// Along the ray through mu outward in small strides, then by bisection.
double rungeKuttaLimit(std::span<const double> growth, double w2, double d) {
  const Complex mu = rootsOf({w2, d})[0];
  const double size = std::abs(mu);
  if (size == 0) return kEveryStep;
  if (!std::isfinite(size)) return 0;
  const Complex direction = mu / size;
  constexpr double kRounding = 1e-12, kStride = 0.05;
  // What is no number counts as growth, so that the way outward has an end.
  const auto grows = [&](double radius) { return !(sizeOf(growth, radius * direction) <= 1 + kRounding); };
  double outside = kStride;
  while (!grows(outside)) outside += kStride;
  double inside = outside - kStride;
  for (int k = 0; k < 40; ++k) {
    const double middle = (inside + outside) / 2;
    (grows(middle) ? outside : inside) = middle;
  }
  return inside / size;
}

double survivedStep(double w2, double seconds, double growth) { return 2 * std::log(growth) / (w2 * seconds); }

}  // namespace tyg
