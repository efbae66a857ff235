// The table of methods: one line each.
#include <algorithm>
#include <array>
#include <string>

#include "core/text.h"
#include "integrators/factories.h"
#include "tyg/methods.h"

namespace tyg {
namespace {

// name, label, scheme, order, evaluations per step and more of them at a start, adaptive, largest stable step of a mode
// and of a scene, makers
// clang-format off
constexpr std::array kMethods = {
    Method{"explicit-euler", "Explicit Euler", "x' = x + h v; v' = v + h a(x, v)",
           1, 1, 0, false, stableStepExplicitEuler, nullptr, makeExplicitEuler<float>, makeExplicitEuler<double>},
    Method{"symplectic-euler", "Symplectic Euler", "v' = v + h a(x, v); x' = x + h v'",
           1, 1, 0, false, stableStepSymplecticEuler, nullptr, makeSymplecticEuler<float>, makeSymplecticEuler<double>},
    Method{"report-rk4", "RK4 as the report printed it", "symplectic Euler with h (1 + h/2 + h^2/6 + h^3/24)",
           1, 1, 0, false, stableStepReportRk4, nullptr, makeReportRk4<float>, makeReportRk4<double>},
    Method{"leapfrog", "Leapfrog", "velocity Verlet; damping at the predicted velocity",
           2, 1, 1, false, stableStepLeapfrog, nullptr, makeLeapfrog<float>, makeLeapfrog<double>},
    Method{"rk4", "Runge-Kutta 4", "the classical Runge-Kutta method on (x, v)",
           4, 4, 0, false, stableStepRk4, nullptr, makeRk4<float>, makeRk4<double>},
    Method{"bs32", "Bogacki-Shampine 3(2)", "adaptive Runge-Kutta, first same as last",
           3, 3, 1, true, stableStepBs32, nullptr, makeBs32<float>, makeBs32<double>},
    Method{"dopri54", "Dormand-Prince 5(4)", "adaptive Runge-Kutta, first same as last",
           5, 6, 1, true, stableStepDopri54, nullptr, makeDopri54<float>, makeDopri54<double>},
    Method{"rkc2", "Runge-Kutta-Chebyshev 2", "as many stages as the damping needs",
           2, -1, 0, false, nullptr, stableStepRkc2, makeRkc2<float>, makeRkc2<double>},
    Method{"imex", "IMEX", "position Verlet, damping by implicit midpoint",
           2, 1, 0, false, stableStepImex, nullptr, makeImex<float>, makeImex<double>},
    Method{"backward-euler", "Backward Euler", "Baraff-Witkin: one linearised solve a step",
           1, 1, 0, false, nullptr, nullptr, makeBackwardEuler<float>, makeBackwardEuler<double>},
    Method{"xpbd", "XPBD", "compliant constraints, small steps, one sweep",
           1, 0, 0, false, nullptr, nullptr, makeXpbd<float>, makeXpbd<double>},
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

const Method& findMethod(std::string_view name, std::string_view key) {
  for (const Method& method : kMethods) {
    if (method.name == name) return method;
  }
  throw InputError(std::string(key) + ": found \"" + std::string(name) + "\", allowed: " + joined(kNames));
}

}  // namespace tyg
