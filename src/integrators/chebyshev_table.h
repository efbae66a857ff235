// The numbers of an s-stage Runge-Kutta-Chebyshev step.
#pragma once

#include <vector>

#include "integrators/chebyshev.h"

namespace tyg {

/// b_j, T_j(w0) and the shift and scale of the argument, for j = 0..s (Sommeijer, Shampine, Verwer 1998, eq. 2.3-2.4):
/// w0 = 1 + eps / s^2, w1 = T's(w0) / T''s(w0), b_j = T''_j(w0) / T'_j(w0)^2, b_0 = b_1 = b_2.
struct ChebyshevTable {
  explicit ChebyshevTable(const ChebyshevStages& stages);
  double w0 = 0, w1 = 0;
  std::vector<double> b, value;
};

}  // namespace tyg
