// Extended position-based dynamics with small steps, one iteration each (Macklin, Mueller, Chentanez 2016; Macklin et
// al., "Small steps in physics simulation", 2019). Springs are compliant distance constraints, visited in index order:
//   C = |L| - L0;  lambda = -C / (w1 + w2 + 1 / (ks h^2));  x1 += w1 lambda n;  x2 -= w2 lambda n
// Each correction of a position goes over h to the velocity. In exact numbers that is the usual v' = (x' - x) / h,
// whose difference would leave only rounding of a small step in float. Damping acts first, on velocities that weight
// has not yet changed, as a pair impulse -h kd dv / (1 + h kd (w1 + w2)) per spring: dampers of a cloth at rest then
// carry nothing. What resists single particles acts implicitly in the kick. Bodies are constraints of compliance 1 / k,
// visited after the springs; their damping and friction act like that of springs.
#include <cmath>

#include "core/forces/point_math.h"
#include "core/forces/term.h"
#include "integrators/kick_and_drift.h"
#include "integrators/make.h"
#include "integrators/spring_list.h"

namespace tyg {
namespace {

template <class T>
class Xpbd final : public Integrator<T> {
 public:
  Xpbd(const Scene& scene, const Sheet& sheet)
      : scene_(scene),
        springs_(listSprings(scene, sheet)),
        axial_(scene.damping == Damping::Axial),
        force_(Layout(sheet)) {}

  void step(Forces<T>& forces, State<T>& state, double t, double h) override {
    forces.measurePower(t, state.position, state.velocity);
    forces.addPower(h);
    for (const ListedSpring& spring : springs_) {
      if (spring.kd > 0) damp(forces, state, spring, h);
    }
    dampTouches(forces, state, t, h);
    forces.evaluateWithoutStiffness(t, state.position, state.velocity, force_);
    // v' = v + h (F - c v') / m where F holds -c v already
    kick(forces, state, force_, h / (1 + h * forces.inverseMass() * particleDamping(scene_)));
    drift(forces, state, h);
    for (const ListedSpring& spring : springs_) {
      if (spring.ks > 0) project(forces, state, spring, h);
    }
    projectTouches(forces, state, t + h, h);
  }
  void useParameters(const Scene& scene, const Sheet& sheet) override {
    relistSprings(springs_, scene_, scene, sheet);
    scene_ = scene;
  }
  [[nodiscard]] std::unique_ptr<Integrator<T>> clone() const override { return std::make_unique<Xpbd>(*this); }
  [[nodiscard]] std::size_t bytes() const override { return force_.bytes() + springs_.size() * sizeof(ListedSpring); }

 private:
  struct Vector {
    T x, y, z;
  };
  static Vector between(const VectorField<T>& field, const ListedSpring& spring) {
    const T *x = field.x(), *y = field.y(), *z = field.z();
    return {x[spring.first] - x[spring.second], y[spring.first] - y[spring.second], z[spring.first] - z[spring.second]};
  }
  static T dot(const Vector& a, const Vector& b) { return (a.x * b.x + a.y * b.y) + a.z * b.z; }
  /// first += w1 s a; second -= w2 s a.
  static void addPair(VectorField<T>& field, const ListedSpring& spring, T w1, T w2, T s, const Vector& a) {
    T *x = field.x(), *y = field.y(), *z = field.z();
    x[spring.first] += w1 * s * a.x, y[spring.first] += w1 * s * a.y, z[spring.first] += w1 * s * a.z;
    x[spring.second] -= w2 * s * a.x, y[spring.second] -= w2 * s * a.y, z[spring.second] -= w2 * s * a.z;
  }

  void damp(const Forces<T>& forces, State<T>& state, const ListedSpring& spring, double h) const {
    const T w = T(forces.inverseMass());
    const T w1 = w * forces.freeMask()[spring.first], w2 = w * forces.freeMask()[spring.second];
    const Vector dv = between(state.velocity, spring);
    const T s = -T(h * spring.kd) / (1 + T(h * spring.kd) * (w1 + w2));
    if (!axial_) return addPair(state.velocity, spring, w1, w2, s, dv);
    const Vector d = between(state.position, spring);
    const T squared = dot(d, d);
    if (squared > 0) addPair(state.velocity, spring, w1, w2, s * dot(dv, d) / squared, d);
  }

  static Point<T> pointOf(const VectorField<T>& field, std::ptrdiff_t i) {
    return {field.x()[i], field.y()[i], field.z()[i]};
  }
  static void addTo(VectorField<T>& field, std::ptrdiff_t i, const Point<T>& a) {
    field.x()[i] += a.x, field.y()[i] += a.y, field.z()[i] += a.z;
  }
  /// Calls `visit(i, touch, numbers)` for what touches the free particle at place i.
  template <class Visit>
  void forTouches(const Forces<T>& forces, const State<T>& state, double time, const Visit& visit) const {
    if (holdingTerm(scene_).term == nullptr) return;
    const AllTerms::Numbers<T> all = forces.numbersAt(time);
    const Layout& layout = forces.layout();
    AllTerms::forEach([&]<class Term>() {
      if constexpr (Term::kPlace == TermPlace::Blocks) {
        const typename Term::template Numbers<T>& numbers = all;
        for (int particle = 0; particle < layout.columns * layout.rows; ++particle) {
          const std::ptrdiff_t i = layout.at(particle);
          if (forces.freeMask()[i] == 0) continue;
          Term::forTouches(PointMath<T>(), pointOf(state.position, i), pointOf(state.velocity, i), numbers,
                           [&](const auto& touch, T /*stiffness*/) { visit(i, touch, numbers); });
        }
      }
    });
  }
  /// Damping and friction, implicitly: v' = v - h c v' / m for each direction.
  void dampTouches(const Forces<T>& forces, State<T>& state, double t, double h) const {
    const T perMass = T(h * forces.inverseMass());
    forTouches(forces, state, t, [&](std::ptrdiff_t i, const auto& touch, const auto& /*numbers*/) {
      const T along = perMass * touch.damping, across = perMass * touch.friction;
      addTo(state.velocity, i, (-along / (1 + along) * touch.approach) * touch.normal);
      addTo(state.velocity, i, (-across / (1 + across)) * touch.slip);
    });
  }
  /// A constraint of compliance 1 / k, as deep as the force is over k.
  void projectTouches(const Forces<T>& forces, State<T>& state, double t, double h) const {
    const T w = T(forces.inverseMass());
    forTouches(forces, state, t, [&](std::ptrdiff_t i, const auto& touch, const auto& numbers) {
      const T lambda = touch.push / numbers.stiffness / (w + T(1 / (h * h)) / numbers.stiffness);
      addTo(state.position, i, (w * lambda) * touch.normal);
      addTo(state.velocity, i, (T(1 / h) * w * lambda) * touch.normal);
    });
  }

  static void project(const Forces<T>& forces, State<T>& state, const ListedSpring& spring, double h) {
    const T w = T(forces.inverseMass());
    const T w1 = w * forces.freeMask()[spring.first], w2 = w * forces.freeMask()[spring.second];
    const Vector d = between(state.position, spring);
    const T length = std::sqrt(dot(d, d));
    if (!(length > 0) || w1 + w2 == 0) return;
    const T lambda = -(length - T(spring.rest)) / (w1 + w2 + T(1 / (spring.ks * h * h)));
    addPair(state.position, spring, w1, w2, lambda / length, d);
    addPair(state.velocity, spring, w1, w2, T(1 / h) * (lambda / length), d);
  }

  Scene scene_;
  std::vector<ListedSpring> springs_;
  bool axial_;
  VectorField<T> force_;
};

}  // namespace

Method xpbdMethod() {
  return {.name = "xpbd",
          .label = "XPBD",
          .scheme = "compliant constraints, small steps, one sweep",
          .order = 1,
          .evaluationsPerStep = 0,
          .whyNoLimit =
              "each step moves every spring towards its rest length and never past it, so that nothing grows without "
              "end; but one sweep leaves the springs of large steps longer than their forces allow, and the energy "
              "alarm takes what they then store for instability",
          .solves = true,
          .makeFloat = make<Xpbd, float>,
          .makeDouble = make<Xpbd, double>};
}

}  // namespace tyg
