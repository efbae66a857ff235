// Bogacki-Shampine 3(2): third order with an embedded second-order estimate.
// Coefficients: P. Bogacki, L. F. Shampine, "A 3(2) pair of Runge-Kutta formulas", Appl. Math. Lett. 2 (1989) 321-325.
#include "integrators/embedded_rk.h"
#include "integrators/make.h"
#include "integrators/stable_step.h"

namespace tyg {
namespace {

struct Bs32Table {
  static constexpr int kStages = 4;
  static constexpr int kRoots = 2;  // step ~ error^-1/4
  static constexpr double kA[kStages][kStages] = {
      {},
      {1.0 / 2},
      {0, 3.0 / 4},
      {2.0 / 9, 1.0 / 3, 4.0 / 9},
  };
  static constexpr double kE[kStages] = {2.0 / 9 - 7.0 / 24, 1.0 / 3 - 1.0 / 4, 4.0 / 9 - 1.0 / 3, -1.0 / 8};
};

template <class T>
using Bs32 = EmbeddedRk<T, Bs32Table>;

/// R(z) = 1 + z + z^2/2 + z^3/6.
double stableStep(double w2, double d) {
  constexpr double kGrowth[] = {1, 1, 1.0 / 2, 1.0 / 6};
  return rungeKuttaLimit(kGrowth, w2, d);
}

}  // namespace

Method bs32Method() {
  return {.name = "bs32",
          .label = "Bogacki-Shampine 3(2)",
          .scheme = "adaptive Runge-Kutta, first same as last",
          .order = 3,
          .evaluationsPerStep = 3,
          .evaluationsAtStart = 1,
          .adaptive = true,
          .stableStep = stableStep,
          .makeFloat = make<Bs32, float>,
          .makeDouble = make<Bs32, double>};
}

}  // namespace tyg
