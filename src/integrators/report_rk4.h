// The step that the 2017 report's Runge-Kutta really takes.
#pragma once

namespace tyg {

/// The report's equations 5-6 as printed: k1 = f, k2 = f + h/2 k1, k3 = f + h/2 k2, k4 = f + h k3 and
/// y' = y + h/6 (k1 + 2 k2 + 2 k3 + k4). The state never moves between the stages, so all of them hold the same f, and
/// the sum is y' = y + H f with H = h (1 + h/2 + h^2/6 + h^3/24), whatever unit h is given in.
constexpr double reportRk4Step(double h) { return h * (1 + h / 2 + h * h / 6 + h * h * h / 24); }

}  // namespace tyg
