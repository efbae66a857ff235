// What the methods' largest stable steps for one mode x'' + d x' + w2 x = 0 are worked out with.
// Must not know: scenes, steppers.
#pragma once

#include <limits>
#include <span>

namespace tyg {

/// The limit of a mode that every step keeps bounded, s.
inline constexpr double kEveryStep = std::numeric_limits<double>::infinity();

/// The positive root of w2 h^2 + b h = 4, s: where |eigenvalues| of the step matrix of a leapfrog-like method reach 1.
double positiveRoot(double w2, double b);

/// The first step (s) at which a Runge-Kutta method grows, |R(h mu)| > 1 for the faster root mu; `growth` holds the
/// coefficients of z^0, z^1, ... of R(z), by which y' = mu y grows over a step with z = h mu.
double rungeKuttaLimit(std::span<const double> growth, double w2, double d);

/// Explicit Euler undamped: every step multiplies the fastest mode by sqrt(1 + h^2 w^2), so that over T seconds a
/// growth by G is survived up to about h = 2 ln(G) / (w^2 T), in s. `w2` in 1/s2, `seconds` the T, both > 0; `growth`
/// > 1.
double survivedStep(double w2, double seconds, double growth);

}  // namespace tyg
