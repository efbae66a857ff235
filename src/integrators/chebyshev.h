// The stability polynomials of the second-order Runge-Kutta-Chebyshev methods, and how many stages a scene needs.
#pragma once

#include <complex>
#include <span>

#include "core/lattice.h"

namespace tyg {

constexpr int kMostChebyshevStages = 100;

/// P_s(z) = a_s + b_s T_s(w0 + w1 z) with the damping eps = 2/13 (Sommeijer, Shampine, Verwer 1998, eq. 2.2-2.4).
std::complex<double> chebyshevGrowth(int stages, std::complex<double> z);

/// The fewest stages, 2 to kMostChebyshevStages, with |P_s(h mu)| <= 1 for both roots mu of every mode; 0 where none
/// does.
int chebyshevStages(std::span<const Mode> modes, double h);

}  // namespace tyg
