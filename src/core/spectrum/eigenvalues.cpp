// By the QR algorithm on the Hessenberg form, as Eigen has it.
#include "core/spectrum/eigenvalues.h"

#include <Eigen/Eigenvalues>

namespace tyg {

std::vector<std::complex<double>> eigenvaluesOf(std::span<const double> columns, int size) {
  const Eigen::MatrixXd matrix = Eigen::Map<const Eigen::MatrixXd>(columns.data(), size, size);
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(matrix, false);
  return {solver.eigenvalues().begin(), solver.eigenvalues().end()};
}

}  // namespace tyg
