// Bogacki-Shampine 3(2): third order with an embedded second-order estimate.
// Coefficients: P. Bogacki, L. F. Shampine, "A 3(2) pair of Runge-Kutta formulas", Appl. Math. Lett. 2 (1989) 321-325.
#include "integrators/embedded_rk.h"
#include "integrators/factories.h"

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

}  // namespace

template <class T>
std::unique_ptr<Integrator<T>> makeBs32(const Scene& scene, const Sheet& sheet) {
  return std::make_unique<EmbeddedRk<T, Bs32Table>>(scene, sheet);
}
template std::unique_ptr<Integrator<float>> makeBs32(const Scene&, const Sheet&);
template std::unique_ptr<Integrator<double>> makeBs32(const Scene&, const Sheet&);

}  // namespace tyg
