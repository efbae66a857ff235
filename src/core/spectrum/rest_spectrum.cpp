// Assembles K and C of the sheet at rest spring by spring, and finds their eigenvalues.
#include "core/spectrum/rest_spectrum.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCore>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/forces/term.h"
#include "core/forces/terms/springs.h"
#include "core/spectrum/eigenvalues.h"

namespace tyg {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;
using Block = Eigen::Matrix2d;

/// Adds up what springs between free particles do, as a graph Laplacian with a block per spring.
class Assembly {
 public:
  explicit Assembly(const Sheet& sheet) : unknown_(std::size_t(sheet.count()), -1) {
    for (int particle = 0; particle < sheet.count(); ++particle) {
      if (!std::ranges::binary_search(sheet.pins, particle)) unknown_[std::size_t(particle)] = free_++;
    }
  }

  void everywhere(int size, double value) {
    for (int k = 0; k < size * free_; ++k) entries_.emplace_back(k, k, value);
  }
  void spring(const SpringEnds& ends, const Block& block, int size) {
    const int a = unknown_[std::size_t(ends.first)], b = unknown_[std::size_t(ends.second)];
    add(a, a, block, size), add(b, b, block, size), add(a, b, -block, size), add(b, a, -block, size);
  }
  /// What resists the mean motion of the cell below right of a particle, at its four corners.
  void cell(const Sheet& sheet, int particle, double value) {
    const std::array corners{particle, particle + 1, particle + sheet.columns, particle + sheet.columns + 1};
    for (const int a : corners) {
      for (const int b : corners) {
        const int row = unknown_[std::size_t(a)], column = unknown_[std::size_t(b)];
        if (row >= 0 && column >= 0) entries_.emplace_back(row, column, value / 16);
      }
    }
  }
  [[nodiscard]] Matrix matrix(int size) const {
    Matrix all(size * free_, size * free_);
    all.setFromTriplets(entries_.begin(), entries_.end());
    return all;
  }

 private:
  void add(int row, int column, const Block& block, int size) {
    if (row < 0 || column < 0) return;
    for (int i = 0; i < size; ++i) {
      for (int j = 0; j < size; ++j) entries_.emplace_back(size * row + i, size * column + j, block(i, j));
    }
  }

  std::vector<int> unknown_;
  int free_ = 0;
  std::vector<Eigen::Triplet<double>> entries_;
};

/// Takes from `next` what lies along the columns of `basis`, twice against rounding; gives the shares of them.
Vector orthogonalised(const Eigen::MatrixXd& basis, Eigen::Index columns, Vector& next) {
  const auto known = basis.leftCols(columns);
  Vector shares = Vector::Zero(columns);
  for (int pass = 0; pass < 2; ++pass) {
    const Vector more = known.transpose() * next;
    next.noalias() -= known * more;
    shares += more;
  }
  return shares;
}

/// The eigenvector of the largest eigenvalue of ofK K + ofC C.
Vector topOf(const Matrix& K, const Matrix& C, const LineNormal& normal) {
  const Eigen::Index size = K.rows(), most = std::min<Eigen::Index>(size, 400);
  Eigen::MatrixXd basis(size, most);
  Vector diagonal(most), beside(most), next(size);
  for (Eigen::Index i = 0; i < size; ++i) next[i] = std::sin(1.0 + double(i) * double(i));  // touches every mode
  Eigen::Index looked = 0;  // at so many columns; looking takes their third power
  for (Eigen::Index k = 0;; ++k) {
    basis.col(k) = next.normalized();
    next = normal.ofK * (K * basis.col(k)) + normal.ofC * (C * basis.col(k));
    diagonal[k] = next.dot(basis.col(k));
    const auto known = basis.leftCols(k + 1);
    orthogonalised(basis, k + 1, next);
    beside[k] = next.norm();
    const bool last = k + 1 == most || beside[k] <= 1e-12 * std::abs(diagonal[0]);
    if (!last && k + 1 < std::max(looked + 10, looked * 5 / 4)) continue;
    looked = k + 1;
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> small;
    small.computeFromTridiagonal(diagonal.head(k + 1), beside.head(k));
    constexpr double kConverged = 1e-7;  // of the residual; the eigenvalue errs by its square
    if (last || beside[k] * std::abs(small.eigenvectors()(k, k)) < kConverged * std::abs(small.eigenvalues()[k])) {
      return known * small.eigenvectors().col(k);
    }
  }
}

}  // namespace

struct RestSpectrum::Matrices {
  Matrix K, C;        // in the plane: two unknowns per free particle
  Matrix outOfPlane;  // of C: one
};

std::optional<Scene> RestSpectrum::smallSheet(const Scene& scene) {
  if (scene.columns * scene.rows <= kMostParticles) return scene;
  constexpr int kNarrow = 8;  // edges along it shift the limit by more than a hundredth
  if (std::min(scene.columns, scene.rows) > kNarrow) return {};
  Scene piece = scene;
  piece.pins.clear();
  int& longSide = scene.columns > scene.rows ? piece.columns : piece.rows;
  longSide = kMostParticles / std::min(scene.columns, scene.rows);
  return piece;
}

RestSpectrum::RestSpectrum(const Scene& scene) {
  const Sheet sheet = makeSheet(scene);
  Assembly stiffness(sheet), damping(sheet), across(sheet);
  const double perMass = 1 / sheet.particleMass;
  damping.everywhere(2, perMass * particleDamping(scene));
  across.everywhere(1, perMass * particleDamping(scene));
  const double ofCells = perMass * cellDamping(scene);
  for (int particle = 0; ofCells > 0 && particle + sheet.columns < sheet.count(); ++particle) {
    if (particle % sheet.columns + 1 < sheet.columns) across.cell(sheet, particle, ofCells);
  }
  for (const Family family : kFamilies) {
    const SpringFamily& springs = familyOf(scene, family);
    if (!springs.present()) continue;
    for (const SpringEnds& ends : springsOf(sheet, family)) {
      const Vec3 from = sheet.startPosition(ends.first), to = sheet.startPosition(ends.second);
      const double down = sheet.start == Start::Flat ? to.z - from.z : to.y - from.y;
      const Eigen::Vector2d along = Eigen::Vector2d(to.x - from.x, down).normalized();
      const Block pull = along * along.transpose();
      const bool relative = scene.damping == Damping::Relative;
      stiffness.spring(ends, perMass * springs.ks * pull, 2);
      damping.spring(ends, perMass * springs.kd * (relative ? Block(Block::Identity()) : pull), 2);
      if (relative) across.spring(ends, perMass * springs.kd * Block::Identity(), 1);
    }
  }
  matrices_ = std::make_shared<Matrices>(Matrices{stiffness.matrix(2), damping.matrix(2), across.matrix(1)});
}

Mode RestSpectrum::farthest(const LineNormal& normal) const {
  if (matrices_->K.rows() == 0) return {};
  const Vector u = topOf(matrices_->K, matrices_->C, normal);
  return {std::max(0.0, u.dot(matrices_->K * u)), std::max(0.0, u.dot(matrices_->C * u))};
}

Mode RestSpectrum::mostDampedOutOfPlane() const {
  if (matrices_->outOfPlane.rows() == 0 || matrices_->outOfPlane.nonZeros() == 0) return {};
  const Vector u = topOf(matrices_->outOfPlane, matrices_->outOfPlane, {0, 1});
  return {0, std::max(0.0, u.dot(matrices_->outOfPlane * u))};
}

double RestSpectrum::mostStiffnessPerDamping() const {
  const Eigen::Index size = matrices_->K.rows();
  const Eigen::MatrixXd K(matrices_->K);
  Eigen::MatrixXd C(matrices_->C);
  if (size == 0 || K.norm() == 0) return 0;
  constexpr double kInfinity = std::numeric_limits<double>::infinity(), kTiny = 1e-9;
  if (C.norm() == 0) return kInfinity;
  C.diagonal().array() += kTiny * C.norm();  // motions that neither strain nor damp, rigid ones above all, get 0
  // The ratios u.Ku / u.Cu are the eigenvalues of B^T K B, where B B^T is the inverse of C. Eigen has a class for pairs
  // of matrices too, but it would take seconds more to compile.
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> damped(C);
  const Eigen::MatrixXd B = damped.eigenvectors() * damped.eigenvalues().cwiseSqrt().cwiseInverse().asDiagonal();
  const Eigen::MatrixXd product = K.lazyProduct(B), reduced = B.transpose().lazyProduct(product);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> pencil(reduced, Eigen::EigenvaluesOnly);
  const double most = pencil.eigenvalues()[size - 1];
  return most * kTiny * C.norm() < 1e-3 * K.norm() / double(size) ? most : kInfinity;
}

/// The fastest rate w of the sheet, in which (w x, v)' = (w v, -K (w x) / w - C v): both halves have one unit, so that
/// rounding is as small a part of the roots however long the unit of time is. 0 where nothing moves by itself.
double RestSpectrum::fastestRate() const { return std::sqrt(farthest({1, 0}).w2) + farthest({0, 1}).d; }

/// An Arnoldi iteration (Arnoldi 1951), whose Ritz values reach the outermost roots first.
std::vector<std::complex<double>> RestSpectrum::outerRoots() const {
  const Eigen::Index size = matrices_->K.rows(), most = std::min<Eigen::Index>(2 * size, kMostProducts);
  std::vector<std::complex<double>> outer;
  if (size == 0) return outer;
  const double w = fastestRate();
  if (!(w > 0) || !std::isfinite(w)) return outer;
  Eigen::MatrixXd basis(2 * size, most), small = Eigen::MatrixXd::Zero(most, most);
  Vector next(2 * size);
  for (Eigen::Index i = 0; i < 2 * size; ++i) next[i] = std::sin(1.0 + double(i) * double(i));  // touches every mode
  Eigen::Index count = 0;
  while (count < most) {
    const double length = next.norm();
    if (count > 0) small(count, count - 1) = length;
    if (count > 0 && length < 1e-12 * w) break;
    basis.col(count) = next / length;
    const auto x = basis.col(count).head(size), v = basis.col(count).tail(size);
    next.head(size) = w * v;
    next.tail(size) = -(matrices_->K * x) / w - matrices_->C * v;
    ++count;
    small.col(count - 1).head(count) = orthogonalised(basis, count, next);
  }
  const Eigen::MatrixXd ritz = small.topLeftCorner(count, count);
  const std::vector<std::complex<double>> found = eigenvaluesOf({ritz.data(), std::size_t(ritz.size())}, int(count));
  outer.insert(outer.end(), found.begin(), found.end());
  return outer;
}

/// The eigenvalues of the motion in the plane; 0 and -d for every d of the damping out of it.
std::vector<std::complex<double>> RestSpectrum::roots() const {
  const Eigen::Index size = matrices_->K.rows();
  if (size == 0) return {};
  Eigen::MatrixXd motion = Eigen::MatrixXd::Zero(2 * size, 2 * size);
  const double fastest = fastestRate(), w = fastest > 0 && std::isfinite(fastest) ? fastest : 1;
  motion.topRightCorner(size, size).diagonal().setConstant(w);
  motion.bottomLeftCorner(size, size) = -Eigen::MatrixXd(matrices_->K) / w;
  motion.bottomRightCorner(size, size) = -Eigen::MatrixXd(matrices_->C);
  std::vector<std::complex<double>> all = eigenvaluesOf({motion.data(), std::size_t(motion.size())}, int(2 * size));
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> across(Eigen::MatrixXd(matrices_->outOfPlane),
                                                              Eigen::EigenvaluesOnly);
  for (const double d : across.eigenvalues()) all.emplace_back(-d, 0);
  return all;
}

}  // namespace tyg
