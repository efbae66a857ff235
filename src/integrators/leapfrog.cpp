// Leapfrog in its velocity Verlet form (Verlet 1967; Swope et al. 1982):
//   w = v + h/2 a;  x' = x + h w;  a' = a(x', w + h/2 a);  v' = w + h/2 a'
// Damping sees the velocity predicted with the old acceleration: that keeps second order with one evaluation a step.
#include "integrators/kick_and_drift.h"
#include "integrators/make.h"
#include "integrators/stable_step.h"

namespace tyg {
namespace {

template <class T>
class Leapfrog final : public Integrator<T> {
 public:
  explicit Leapfrog(const Layout& layout) : force_(layout), predicted_(layout) {}

  void step(Forces<T>& forces, State<T>& state, double t, double h) override {
    begin(forces, state, t, h);
    finish(forces, state, t + h, h);
  }
  /// Two half kicks of neighbouring steps use the same force, so all but the last one fuse into one pass a step.
  void steps(Forces<T>& forces, State<T>& state, const StepTimes& times, int count) override {
    if (!forces.canAdvance()) return Integrator<T>::steps(forces, state, times, count);
    begin(forces, state, times.at(0), times.h);
    if (count > 1) forces.leapfrog(state, predicted_, times, count - 1);
    finish(forces, state, times.at(count - 1) + times.h, times.h);
  }
  void reset() override { haveForce_ = false; }
  [[nodiscard]] std::unique_ptr<Integrator<T>> clone() const override { return std::make_unique<Leapfrog>(*this); }
  [[nodiscard]] std::size_t bytes() const override { return force_.bytes() + predicted_.bytes(); }

 private:
  /// w = v + h/2 a;  x' = x + h w;  u = w + h/2 a
  void begin(Forces<T>& forces, State<T>& state, double t, double h) {
    if (!haveForce_) forces.evaluate(t, state.position, state.velocity, force_);
    haveForce_ = true;
    forces.addPower(h / 2);
    const T step = T(h), halfKick = T(h / 2 * forces.inverseMass());
    T *x = state.position.x(), *v = state.velocity.x(), *u = predicted_.x();
    const T* f = force_.x();
    forNumbers(forces.workers(), forces.layout(), [=](std::ptrdiff_t i) {
      v[i] += halfKick * f[i];
      x[i] += step * v[i];
      u[i] = v[i] + halfKick * f[i];
    });
  }

  /// a' = a(t', x', u);  v' = w + h/2 a'
  void finish(Forces<T>& forces, State<T>& state, double end, double h) {
    forces.evaluate(end, state.position, predicted_, force_);
    forces.addPower(h / 2);
    kick(forces, state, force_, h / 2);
  }

  VectorField<T> force_, predicted_;
  bool haveForce_ = false;  // force_ belongs to the state that the last step left
};

/// With the damping at the predicted velocity: h^2 w2 + 4 h d <= 4, where h d = 1 bounds the pure damping mode.
double stableStep(double w2, double d) { return positiveRoot(w2, 4 * d); }

}  // namespace

Method leapfrogMethod() {
  return {.name = "leapfrog",
          .label = "Leapfrog",
          .scheme = "velocity Verlet; damping at the predicted velocity",
          .order = 2,
          .evaluationsPerStep = 1,
          .evaluationsAtStart = 1,
          .stableStep = stableStep,
          .makeFloat = make<Leapfrog, float>,
          .makeDouble = make<Leapfrog, double>};
}

}  // namespace tyg
