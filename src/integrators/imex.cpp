// Position Verlet with the damping by the implicit midpoint rule, for the relative law, whose matrix D is constant:
//   y = x + h/2 v;  (M + h/2 D) v' = (M - h/2 D) v + h F_springs(y);  x' = y + h/2 v'
// Second order; stable to h w = 2 whatever the damping. D is factored once for each step length; of a large sheet,
// where that would take minutes, the system is solved by conjugate gradients, as long as these converge. The damping
// and the friction of contact are no such matrix: they are evaluated with v, which is first order.
#include <fmt/core.h>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <optional>

#include "core/forces/term.h"
#include "integrators/kick_and_drift.h"
#include "integrators/make.h"
#include "integrators/spring_list.h"
#include "integrators/stable_step.h"

namespace tyg {
namespace {

template <class T>
class Imex final : public Integrator<T> {
 public:
  Imex(const Scene& scene, const Sheet& sheet)
      : scene_(scene), sheet_(sheet), still_(Layout(sheet)), force_(Layout(sheet)) {
    if (scene.damping == Damping::Axial) {
      throw InputError("imex: found axial damping, allowed: relative damping (its matrix must be constant)");
    }
    refuseCellDamping(scene);
    unknown_.assign(std::size_t(still_.layout().plane), -1);
    for (int particle = 0; particle < sheet.count(); ++particle) {
      if (!std::binary_search(sheet.pins.begin(), sheet.pins.end(), particle)) {
        unknown_[std::size_t(still_.layout().at(particle))] = int(places_.size());
        places_.push_back(still_.layout().at(particle));
      }
    }
    buildDamping();
  }
  void useParameters(const Scene& scene, const Sheet& /*sheet*/) override {
    refuseCellDamping(scene);
    const bool dampsAlike = valuesOf(scene, Role::Damping) == valuesOf(scene_, Role::Damping);
    scene_ = scene;
    if (!dampsAlike) buildDamping();
  }
  Imex(const Imex& other) : Imex(other.scene_, other.sheet_) {}

  void step(Forces<T>& forces, State<T>& state, double t, double h) override {
    drift(forces, state, h / 2);
    forces.evaluate(t + h / 2, state.position, still_, force_, state.velocity);
    forces.measurePower(t, state.position, state.velocity);
    forces.addPower(h / 2);
    if (isDamped_) {
      solve(state, h);
    } else {
      kick(forces, state, force_, h);
    }
    forces.measurePower(t + h, state.position, state.velocity);
    forces.addPower(h / 2);
    drift(forces, state, h / 2);
  }
  [[nodiscard]] std::unique_ptr<Integrator<T>> clone() const override { return std::make_unique<Imex>(*this); }
  [[nodiscard]] std::size_t bytes() const override {
    const auto entries = std::size_t(damping_.nonZeros() + mass_.nonZeros());  // a copy is not factored
    return 2 * force_.bytes() + entries * (sizeof(T) + sizeof(int)) +
           places_.size() * (6 * sizeof(T) + sizeof(int) + sizeof(std::ptrdiff_t));
  }

 private:
  using Matrix = Eigen::SparseMatrix<T>;
  using Columns = Eigen::Matrix<T, Eigen::Dynamic, 3>;
  /// A damper between a particle that moves and a pin, which may have a velocity of its own.
  struct OnPin {
    int unknown = 0;
    std::ptrdiff_t pin = 0;
    T kd = 0;
  };

  static void refuseCellDamping(const Scene& scene) {
    const ForceTerm* term = cellDampingTerm(scene);
    if (term == nullptr) return;
    throw InputError(fmt::format(
        "imex: found {}, allowed: scenes without it (the matrix of the damping must be constant)", term->name));
  }
  static constexpr std::size_t kMostFactored = 256 * 256;  // particles: a factorisation of them takes a second
  static constexpr int kMostIterations = 200;

  /// D over the particles that move: the graph Laplacian weighted with kd, plus what resists single particles.
  void buildDamping() {
    std::vector<Eigen::Triplet<T>> entries;
    onPins_.clear();
    const auto add = [&](int row, int column, double value) {
      if (row >= 0 && column >= 0) entries.emplace_back(row, column, T(value));
    };
    const double ofParticles = particleDamping(scene_);
    for (std::size_t k = 0; k < places_.size(); ++k) add(int(k), int(k), ofParticles);
    isDamped_ = isDamped(scene_);
    for (const ListedSpring& spring : listSprings(scene_, sheet_)) {
      if (spring.kd <= 0) continue;
      const int a = unknown_[std::size_t(spring.first)], b = unknown_[std::size_t(spring.second)];
      if (a >= 0 && b < 0) onPins_.push_back({a, spring.second, T(spring.kd)});
      if (b >= 0 && a < 0) onPins_.push_back({b, spring.first, T(spring.kd)});
      add(a, a, spring.kd), add(b, b, spring.kd), add(a, b, -spring.kd), add(b, a, -spring.kd);
    }
    const auto size = Eigen::Index(places_.size());
    const Matrix before = damping_;
    damping_.resize(size, size);
    damping_.setFromTriplets(entries.begin(), entries.end());
    mass_.resize(size, size);
    mass_.setIdentity();
    mass_ *= T(sheet_.particleMass);
    factoredFor_ = systemFor_ = 0;
    if (isLarge()) {
      isAnalyzed_ = false;
      return;
    }
    if (isDamped_ && !(isAnalyzed_ && samePattern(before, damping_))) factor_.analyzePattern(mass_ + damping_);
    isAnalyzed_ = isDamped_;
  }

  [[nodiscard]] bool isLarge() const { return places_.size() > kMostFactored; }

  /// (M + h/2 D)^-1 times the impulse. Which way it is solved depends on nothing but the present step, so that a copy
  /// goes on with the same bits.
  Columns solved(double h) {
    if (isLarge()) {
      if (std::optional<Columns> solution = iterated(h)) return *std::move(solution);
    }
    if (!isAnalyzed_) factor_.analyzePattern(mass_ + damping_);
    isAnalyzed_ = true;
    if (h != factoredFor_) {
      factor_.factorize(mass_ + T(h / 2) * damping_);
      factoredFor_ = h;
    }
    return factor_.solve(impulse_);
  }

  /// The same by conjugate gradients; nothing where the damping is too strong for a few of them.
  std::optional<Columns> iterated(double h) {
    if (h != systemFor_) system_ = mass_ + T(h / 2) * damping_;
    systemFor_ = h;
    Eigen::ConjugateGradient<Matrix, Eigen::Lower | Eigen::Upper> gradients(system_);
    gradients.setTolerance(sizeof(T) == sizeof(float) ? T(1e-6) : T(1e-12));
    gradients.setMaxIterations(kMostIterations);
    Columns solution = gradients.solve(impulse_);
    if (gradients.info() != Eigen::Success) return std::nullopt;
    return solution;
  }

  static bool samePattern(const Matrix& a, const Matrix& b) {
    return a.cols() == b.cols() && a.nonZeros() == b.nonZeros() &&
           std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.cols() + 1, b.outerIndexPtr()) &&
           std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(), b.innerIndexPtr());
  }

  /// Solved for the change of the velocity, (M + h/2 D) (v' - v) = h (F - D v), whose rounding is the smaller one.
  void solve(State<T>& state, double h) {
    const auto size = Eigen::Index(places_.size());
    velocity_.resize(size, 3);
    const std::ptrdiff_t plane = state.velocity.layout().plane;
    T* v = state.velocity.x();
    const T* f = force_.x();
    for (Eigen::Index k = 0; k < size; ++k) {
      for (int axis = 0; axis < 3; ++axis) velocity_(k, axis) = v[axis * plane + places_[std::size_t(k)]];
    }
    impulse_ = -T(h) * (damping_ * velocity_);
    for (Eigen::Index k = 0; k < size; ++k) {
      for (int axis = 0; axis < 3; ++axis) impulse_(k, axis) += T(h) * f[axis * plane + places_[std::size_t(k)]];
    }
    for (const OnPin& spring : onPins_) {
      for (int axis = 0; axis < 3; ++axis) {
        const T ofPin = v[axis * plane + spring.pin];
        if (ofPin != 0) impulse_(spring.unknown, axis) += T(h) * spring.kd * ofPin;
      }
    }
    impulse_ = solved(h);
    for (Eigen::Index k = 0; k < size; ++k) {
      for (int axis = 0; axis < 3; ++axis) v[axis * plane + places_[std::size_t(k)]] += impulse_(k, axis);
    }
  }

  Scene scene_;
  Sheet sheet_;
  VectorField<T> still_, force_;
  std::vector<int> unknown_;            // by place: index of the unknown, or -1 at pins and padding
  std::vector<std::ptrdiff_t> places_;  // by unknown: its place
  std::vector<OnPin> onPins_;
  bool isDamped_ = false, isAnalyzed_ = false;
  Matrix damping_, mass_, system_;
  Eigen::SimplicialLDLT<Matrix> factor_;
  double factoredFor_ = 0, systemFor_ = 0;  // s, steps
  Columns velocity_, impulse_;
};

/// Damping by contact acts explicitly, with the velocity at the start of the step: x'' + d x' + w2 x = 0 then has the
/// step matrix of symplectic Euler, seen half a step later.
double stableStepWhereHeld(double w2, double d) { return positiveRoot(w2, 2 * d); }

/// Damping by the midpoint rule only ever shrinks a mode; the springs alone set h^2 w2 <= 4.
double stableStep(double w2, double /*d*/) { return positiveRoot(w2, 0); }

}  // namespace

Method imexMethod() {
  return {.name = "imex",
          .label = "IMEX",
          .scheme = "position Verlet, damping by implicit midpoint; order 1 where contact has damping or friction",
          .order = 2,
          .evaluationsPerStep = 1,
          .stableStep = stableStep,
          .stableStepWhereHeld = stableStepWhereHeld,
          .solves = true,
          .makeFloat = make<Imex, float>,
          .makeDouble = make<Imex, double>};
}

}  // namespace tyg
