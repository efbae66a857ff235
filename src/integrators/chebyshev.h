// The stability polynomials of the second-order Runge-Kutta-Chebyshev methods, and how many stages a scene needs.
#pragma once

#include <complex>
#include <span>
#include <vector>

#include "core/spectrum/lattice.h"

namespace tyg {

constexpr int kMostChebyshevStages = 100;

/// Which of the methods: how many stages, and how strongly damped, eps of w0 = 1 + eps / s^2. The authors' 2/13 reaches
/// farthest along the real axis; a larger one gives reach away for width, as waves that still oscillate need it
/// (Verwer, Sommeijer, Hundsdorfer, "RKC time-stepping for advection-diffusion-reaction problems", 2004, take 10).
struct ChebyshevStages {
  int count = 0;  ///< 2 to kMostChebyshevStages; 0: none holds
  double eps = 2.0 / 13;
};

/// P_s(z) = a_s + b_s T_s(w0 + w1 z) (Sommeijer, Shampine, Verwer 1998, eq. 2.2-2.4).
std::complex<double> chebyshevGrowth(const ChebyshevStages& stages, std::complex<double> z);

/// What stages are chosen for: the waves of the sheet at rest on a grid of phases; under the relative law, whose
/// damping no deformation changes, each phase also with the largest stiffness that any deformation gives it; and for
/// each stiffness the least damping that a motion of it has, since there is less at the edges of a sheet than inside.
/// `inPieces`: springs are gone, and a motion may have no more damping than that of the least damped family.
std::vector<Mode> chebyshevModes(const Scene& scene, bool inPieces);

/// The fewest stages, and of those the least damped, with |P_s(h mu)| <= 1 for both roots mu of every mode.
ChebyshevStages chebyshevStages(std::span<const Mode> modes, double h);

/// The same question without the answer: whether any stages hold. Quick where it is asked for many steps.
class ChebyshevReach {
 public:
  explicit ChebyshevReach(std::span<const Mode> modes);
  /// Whether chebyshevStages() of these modes would find some for h (s).
  bool holds(double h);

 private:
  std::vector<std::complex<double>> roots_;  // the one that failed last is the first
  double fastest_ = 0;                       // 1/s
};

}  // namespace tyg
