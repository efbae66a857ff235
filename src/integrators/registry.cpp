// The table of methods: one line each.
#include <algorithm>
#include <array>
#include <string>

#include "integrators/factories.h"
#include "tyg/methods.h"

namespace tyg {
namespace {

// name, label, scheme, order, evaluations per step and more of them at a start, adaptive, largest stable step, makers
// clang-format off
constexpr std::array kMethods = {
    Method{"explicit-euler", "Explicit Euler", "x' = x + h v; v' = v + h a(x, v)",
           1, 1, 0, false, stableStepExplicitEuler, makeExplicitEuler<float>, makeExplicitEuler<double>},
    Method{"symplectic-euler", "Symplectic Euler", "v' = v + h a(x, v); x' = x + h v'",
           1, 1, 0, false, stableStepSymplecticEuler, makeSymplecticEuler<float>, makeSymplecticEuler<double>},
    Method{"report-rk4", "RK4 as the report printed it", "symplectic Euler with h (1 + h/2 + h^2/6 + h^3/24)",
           1, 1, 0, false, stableStepReportRk4, makeReportRk4<float>, makeReportRk4<double>},
    Method{"leapfrog", "Leapfrog", "velocity Verlet; damping at the predicted velocity",
           2, 1, 1, false, stableStepLeapfrog, makeLeapfrog<float>, makeLeapfrog<double>},
    Method{"rk4", "Runge-Kutta 4", "the classical Runge-Kutta method on (x, v)",
           4, 4, 0, false, stableStepRk4, makeRk4<float>, makeRk4<double>},
};
// clang-format on

constexpr auto kNames = [] {
  std::array<std::string_view, kMethods.size()> names;
  std::transform(kMethods.begin(), kMethods.end(), names.begin(), [](const Method& method) { return method.name; });
  return names;
}();

}  // namespace

std::span<const Method> methods() { return kMethods; }
std::span<const std::string_view> methodNames() { return kNames; }

const Method& findMethod(std::string_view name) {
  for (const Method& method : kMethods) {
    if (method.name == name) return method;
  }
  std::string allowed;
  for (const std::string_view known : kNames) allowed += (allowed.empty() ? "" : ", ") + std::string(known);
  throw InputError("integrator: found \"" + std::string(name) + "\", allowed: " + allowed);
}

}  // namespace tyg
