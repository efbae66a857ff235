// Dormand-Prince 5(4): fifth order with an embedded fourth-order estimate.
// Coefficients: J. R. Dormand, P. J. Prince, "A family of embedded Runge-Kutta formulae", J. Comput. Appl. Math. 6
// (1980) 19-26, table 2.
#include "integrators/embedded_rk.h"
#include "integrators/make.h"
#include "integrators/stable_step.h"

namespace tyg {
namespace {

struct Dopri54Table {
  static constexpr int kStages = 7;
  static constexpr int kRoots = 3;  // step ~ error^-1/8
  static constexpr double kA[kStages][kStages] = {
      {},
      {1.0 / 5},
      {3.0 / 40, 9.0 / 40},
      {44.0 / 45, -56.0 / 15, 32.0 / 9},
      {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
      {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
      {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84},
  };
  static constexpr double kE[kStages] = {71.0 / 57600,      0,          -71.0 / 16695, 71.0 / 1920,
                                         -17253.0 / 339200, 22.0 / 525, -1.0 / 40};
};

template <class T>
using Dopri54 = EmbeddedRk<T, Dopri54Table>;

/// R(z) = 1 + z + z^2/2 + z^3/6 + z^4/24 + z^5/120 + z^6/600.
double stableStep(double w2, double d) {
  constexpr double kGrowth[] = {1, 1, 1.0 / 2, 1.0 / 6, 1.0 / 24, 1.0 / 120, 1.0 / 600};
  return rungeKuttaLimit(kGrowth, w2, d);
}

std::string noteOnLimit(const LimitFinding& finding) {
  if (finding.damped || !(finding.predicted > 0)) return "";
  return "dopri54 without damping: just past its limit the fastest mode grows by less than a ten-thousandth a step; "
         "what holds above the prediction is what the run was too short to show.";
}

}  // namespace

Method dopri54Method() {
  return {.name = "dopri54",
          .label = "Dormand-Prince 5(4)",
          .scheme = "adaptive Runge-Kutta, first same as last",
          .order = 5,
          .evaluationsPerStep = 6,
          .evaluationsAtStart = 1,
          .adaptive = true,
          .stableStep = stableStep,
          .noteOnLimit = noteOnLimit,
          .makeFloat = make<Dopri54, float>,
          .makeDouble = make<Dopri54, double>};
}

}  // namespace tyg
