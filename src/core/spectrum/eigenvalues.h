// Eigenvalues of matrices that need not be symmetric. They have a file of their own because the library's
// code takes seconds to compile wherever it is used. Must not know: what the matrices are.
#pragma once

#include <complex>
#include <span>
#include <vector>

namespace tyg {

/// Of a square matrix, column by column; size * size finite numbers.
std::vector<std::complex<double>> eigenvaluesOf(std::span<const double> columns, int size);

}  // namespace tyg
