// Backward Euler with one linearised solve (Baraff and Witkin, "Large steps in cloth simulation", 1998, eq. 6):
//   (M - h dF/dv - h^2 dF/dx) dv = h (F + h dF/dx v), F at t + h;  v' = v + dv;  x' = x + h v'
// A spring's stiffness matrix is ks (n n' + max(0, 1 - L0/|L|) (I - n n')): clamped, so that compressed springs keep
// the system positive definite. A term of cells gives its damping along each cell's normal, and contact the stiffness
// and the damping of each particle that touches a body. Solved by conjugate gradients with 3x3 block Jacobi
// preconditioning, one block a particle.
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/forces/point_math.h"
#include "core/forces/term.h"
#include "integrators/make.h"
#include "integrators/spring_list.h"

namespace tyg {
namespace {

template <class T>
class BackwardEuler final : public Integrator<T> {
 public:
  BackwardEuler(const Scene& scene, const Sheet& sheet)
      : scene_(scene),
        springs_(listSprings(scene, sheet)),
        axial_(scene.damping == Damping::Axial),
        particleDamping_(T(particleDamping(scene))),
        cellDamping_(cellDampingTerm(scene) != nullptr),
        mass_(T(sheet.particleMass)),
        missing_(sheet.missing),
        force_(Layout(sheet)) {
    const Layout& layout = force_.layout();
    index_.assign(std::size_t(layout.plane), -1);
    for (int particle = 0; particle < sheet.count(); ++particle) {
      index_[std::size_t(layout.at(particle))] = particle;
      places_.push_back(layout.at(particle));
    }
    const std::size_t count = places_.size();
    for (Vectors* v : {&solution_, &residual_, &preconditioned_, &direction_, &image_, &velocity_}) {
      v->assign(count, Vector::Zero());
    }
    inverse_.assign(count, Block::Zero());
    fitBlocks();
  }

  void step(Forces<T>& forces, State<T>& state, double t, double h) override {
    forces.evaluate(t + h, state.position, state.velocity, force_);
    linearise(state, T(h));
    lineariseCells(forces, state, t + h, T(h));
    lineariseTouches(forces, state, t + h, T(h));
    prepare(forces, state, T(h));
    solve(forces.freeMask());
    const std::ptrdiff_t plane = force_.layout().plane;
    T *x = state.position.x(), *v = state.velocity.x();
    for (std::size_t k = 0; k < places_.size(); ++k) {
      for (int axis = 0; axis < 3; ++axis) {
        const std::ptrdiff_t i = axis * plane + places_[k];
        v[i] += solution_[k][axis];
        x[i] += T(h) * v[i];
      }
    }
    forces.measurePower(t + h, state.position, state.velocity);
    forces.addPower(h);
  }
  void useParameters(const Scene& scene, const Sheet& sheet) override {
    relistSprings(springs_, scene_, scene, sheet);
    scene_ = scene;
    particleDamping_ = T(particleDamping(scene));
    cellDamping_ = cellDampingTerm(scene) != nullptr;
    fitBlocks();
  }
  [[nodiscard]] std::unique_ptr<Integrator<T>> clone() const override { return std::make_unique<BackwardEuler>(*this); }
  [[nodiscard]] std::size_t bytes() const override {
    return force_.bytes() + springs_.size() * sizeof(ListedSpring) + places_.size() * sizeof(std::ptrdiff_t) +
           (stiffness_.size() + damping_.size() + inverse_.size()) * sizeof(Block) +
           6 * solution_.size() * sizeof(solution_[0]);
  }

 private:
  using Vector = Eigen::Matrix<T, 3, 1>;
  using Block = Eigen::Matrix<T, 3, 3>;
  using Vectors = std::vector<Vector>;
  struct OnCell {
    int particle = 0;  ///< at its upper left corner
    Vector g;
  };
  /// What touches one particle: h^2 K and h C.
  struct OnParticle {
    std::size_t particle = 0;
    Block stiffness, damping;
  };
  /// Arithmetic for terms, of one cell at a time.
  struct VectorMath {
    static T all(T number) { return number; }
    static Vector all3(const T (&numbers)[3]) { return {numbers[0], numbers[1], numbers[2]}; }
    static T root(T a) { return std::sqrt(a); }
    static T size(T a) { return std::abs(a); }
    static T nearestWhole(T a) { return std::nearbyint(a); }
    static T dot(const Vector& a, const Vector& b) { return a.dot(b); }
    static Vector cross(const Vector& a, const Vector& b) {
      return {a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(), a.x() * b.y() - a.y() * b.x()};
    }
  };
  static Vector vectorOf(const Point<T>& point) { return {point.x, point.y, point.z}; }
  static Point<T> pointAt(const VectorField<T>& field, std::ptrdiff_t i) {
    return {field.x()[i], field.y()[i], field.z()[i]};
  }

  void fitBlocks() {
    stiffness_.resize(springs_.size());
    damping_.resize(springs_.size());
  }

  /// h^2 K and h C of every spring.
  void linearise(const State<T>& state, T h) {
    for (std::size_t s = 0; s < springs_.size(); ++s) {
      const ListedSpring& spring = springs_[s];
      const Vector d = at(state.position, spring.first) - at(state.position, spring.second);
      const T length = d.norm();
      const Block along = length > 0 ? Block(d * d.transpose() / (length * length)) : Block(Block::Zero());
      const T across = length > 0 ? std::max(T(0), 1 - T(spring.rest) / length) : T(0);
      const Block k = along + across * (Block::Identity() - along);
      stiffness_[s] = (h * h * T(spring.ks)) * k;
      damping_[s] = (h * T(spring.kd)) * (axial_ ? along : Block(Block::Identity()));
    }
  }

  /// For each cell and each term of cells the vector g of rootOfDamping(), times the root of h.
  void lineariseCells(const Forces<T>& forces, const State<T>& state, double time, T h) {
    onCells_.clear();
    if (!cellDamping_) return;
    const AllTerms::Numbers<T> numbers = forces.numbersAt(time);
    const int columns = force_.layout().columns, rows = force_.layout().rows;
    for (int particle = 0; particle + columns < columns * rows; ++particle) {
      if (particle % columns + 1 == columns || missing_.has(particle, Missing::Cell)) continue;
      const auto corners = [&](const VectorField<T>& field) {
        const auto corner = [&](int k) { return at(field, places_[std::size_t(k)]); };
        return Corners<Vector>{corner(particle), corner(particle + 1), corner(particle + columns),
                               corner(particle + columns + 1)};
      };
      const Corners<Vector> x = corners(state.position), v = corners(state.velocity);
      AllTerms::forEach([&]<class Term>() {
        if constexpr (Term::kPlace == TermPlace::Cells) {
          const typename Term::template Numbers<T>& known = numbers;
          onCells_.push_back({particle, std::sqrt(h) * Term::rootOfDamping(VectorMath(), x, v, known)});
        }
      });
    }
  }
  /// With the normal held, and without the curvature of the surface, which would make the push weaker across it.
  void lineariseTouches(const Forces<T>& forces, const State<T>& state, double time, T h) {
    onParticles_.clear();
    if (holdingTerm(scene_).term == nullptr) return;
    const AllTerms::Numbers<T> numbers = forces.numbersAt(time);
    const T* isFree = forces.freeMask();
    for (std::size_t k = 0; k < places_.size(); ++k) {
      const std::ptrdiff_t i = places_[k];
      if (isFree[i] == 0) continue;
      AllTerms::forEach([&]<class Term>() {
        if constexpr (Term::kPlace == TermPlace::Blocks) {
          const typename Term::template Numbers<T>& known = numbers;
          Term::forTouches(
              PointMath<T>(), pointAt(state.position, i), pointAt(state.velocity, i), known,
              [&](const auto& touch, T stiffness) {
                const Vector n = vectorOf(touch.normal);
                const Block along = n * n.transpose();
                onParticles_.push_back({k, (h * h * stiffness) * along,
                                        h * (touch.damping * along + touch.friction * (Block::Identity() - along))});
              });
        }
      });
    }
  }
  [[nodiscard]] std::array<std::size_t, 4> cornersOf(int particle) const {
    const auto a = std::size_t(particle), below = a + std::size_t(force_.layout().columns);
    return {a, a + 1, below, below + 1};
  }

  /// The right-hand side h F + h dF/dx h v as the first residual, and the preconditioner.
  void prepare(const Forces<T>& forces, const State<T>& state, T h) {
    const T* isFree = forces.freeMask();
    for (std::size_t k = 0; k < places_.size(); ++k) {
      velocity_[k] = at(state.velocity, places_[k]);
      residual_[k] = h * at(force_, places_[k]);
      inverse_[k] = (mass_ + h * particleDamping_) * Block::Identity();
    }
    for (std::size_t s = 0; s < springs_.size(); ++s) {
      const auto [a, b] = ends(s);
      const Vector pull = stiffness_[s] * (velocity_[a] - velocity_[b]);
      residual_[a] -= pull;
      residual_[b] += pull;
      inverse_[a] += stiffness_[s] + damping_[s];
      inverse_[b] += stiffness_[s] + damping_[s];
    }
    for (const OnParticle& touch : onParticles_) {
      residual_[touch.particle] -= touch.stiffness * velocity_[touch.particle];
      inverse_[touch.particle] += touch.stiffness + touch.damping;
    }
    for (const OnCell& cell : onCells_) {
      for (const std::size_t corner : cornersOf(cell.particle)) inverse_[corner] += cell.g * cell.g.transpose();
    }
    diagonal_ = mass_ + h * particleDamping_;
    for (std::size_t k = 0; k < places_.size(); ++k) {
      inverse_[k] = isFree[places_[k]] * inverse_[k].inverse().eval();
      residual_[k] *= isFree[places_[k]];
      solution_[k].setZero();
    }
  }

  /// Conjugate gradients (Hestenes and Stiefel 1952) on the particles that move.
  void solve(const T* isFree) {
    constexpr T kTolerance = sizeof(T) == sizeof(float) ? T(1e-5) : T(1e-8);
    constexpr int kMostIterations = 400;
    precondition();
    direction_ = preconditioned_;
    T rho = dot(residual_, preconditioned_);
    const T enough = kTolerance * kTolerance * rho;
    for (int k = 0; k < kMostIterations && rho > enough; ++k) {
      apply(isFree);
      const T alpha = rho / dot(direction_, image_);
      for (std::size_t i = 0; i < solution_.size(); ++i) {
        solution_[i] += alpha * direction_[i];
        residual_[i] -= alpha * image_[i];
      }
      precondition();
      const T next = dot(residual_, preconditioned_);
      const T beta = next / rho;
      rho = next;
      for (std::size_t i = 0; i < direction_.size(); ++i) direction_[i] = preconditioned_[i] + beta * direction_[i];
    }
  }

  void precondition() {
    for (std::size_t i = 0; i < residual_.size(); ++i) preconditioned_[i] = inverse_[i] * residual_[i];
  }

  /// image = system matrix * direction.
  void apply(const T* isFree) {
    for (std::size_t i = 0; i < direction_.size(); ++i) image_[i] = diagonal_ * direction_[i];
    for (std::size_t s = 0; s < springs_.size(); ++s) {
      const auto [a, b] = ends(s);
      const Vector d = direction_[a] - direction_[b];
      const Vector pull = stiffness_[s] * d + damping_[s] * d;
      image_[a] += pull;
      image_[b] -= pull;
    }
    for (const OnCell& cell : onCells_) {
      const std::array<std::size_t, 4> corners = cornersOf(cell.particle);
      T along = 0;
      for (const std::size_t corner : corners) along += cell.g.dot(direction_[corner]);
      for (const std::size_t corner : corners) image_[corner] += along * cell.g;
    }
    for (const OnParticle& touch : onParticles_) {
      image_[touch.particle] += (touch.stiffness + touch.damping) * direction_[touch.particle];
    }
    for (std::size_t i = 0; i < image_.size(); ++i) image_[i] *= isFree[places_[i]];
  }

  static T dot(const Vectors& a, const Vectors& b) {
    T sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i].dot(b[i]);
    return sum;
  }
  static Vector at(const VectorField<T>& field, std::ptrdiff_t i) { return {field.x()[i], field.y()[i], field.z()[i]}; }
  [[nodiscard]] std::pair<std::size_t, std::size_t> ends(std::size_t spring) const {
    return {std::size_t(index_[std::size_t(springs_[spring].first)]),
            std::size_t(index_[std::size_t(springs_[spring].second)])};
  }

  Scene scene_;
  std::vector<ListedSpring> springs_;
  bool axial_;
  T particleDamping_;
  bool cellDamping_;  // whether there is any
  T mass_, diagonal_ = 0;
  Missing missing_;
  VectorField<T> force_;
  std::vector<int> index_;              // by place: the particle
  std::vector<std::ptrdiff_t> places_;  // by particle: its place
  std::vector<Block> stiffness_, damping_, inverse_;
  std::vector<OnCell> onCells_;
  std::vector<OnParticle> onParticles_;
  Vectors solution_, residual_, preconditioned_, direction_, image_, velocity_;
};

}  // namespace

Method backwardEulerMethod() {
  return {.name = "backward-euler",
          .label = "Backward Euler",
          .scheme = "Baraff-Witkin: one linearised solve a step",
          .order = 1,
          .evaluationsPerStep = 1,
          .whyNoLimit =
              "each step solves for the new velocity with a stiffness that is never negative, not even "
              "that of a compressed spring, so that every mode shrinks at every step",
          .solves = true,
          .makeFloat = make<BackwardEuler, float>,
          .makeDouble = make<BackwardEuler, double>};
}

}  // namespace tyg
