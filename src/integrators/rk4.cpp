// The classical Runge-Kutta method (Kutta 1901) on the coupled state y = (x, v), y' = (v, a(x, v)):
//   k1 = f(y); k2 = f(y + h/2 k1); k3 = f(y + h/2 k2); k4 = f(y + h k3); y' = y + h/6 (k1 + 2 k2 + 2 k3 + k4)
// The position half of every k is a velocity, so only velocities and forces are summed.
#include "core/forces/field_ops.h"
#include "integrators/make.h"
#include "integrators/stable_step.h"

namespace tyg {
namespace {

template <class T>
class Rk4 final : public Integrator<T> {
 public:
  explicit Rk4(const Layout& layout) : stage_(layout), force_(layout), sumV_(layout), sumF_(layout) {}

  void step(Forces<T>& forces, State<T>& state, double t, double h) override {
    forces.evaluate(t, state.position, state.velocity, force_);
    forces.addPower(h / 6);
    firstStage(forces, state, h / 2);
    forces.evaluate(t + h / 2, stage_.position, stage_.velocity, force_);
    forces.addPower(h / 3);
    innerStage(forces, state, h / 2);
    forces.evaluate(t + h / 2, stage_.position, stage_.velocity, force_);
    forces.addPower(h / 3);
    innerStage(forces, state, h);
    forces.evaluate(t + h, stage_.position, stage_.velocity, force_);
    forces.addPower(h / 6);
    finish(forces, state, h);
  }
  [[nodiscard]] std::unique_ptr<Integrator<T>> clone() const override { return std::make_unique<Rk4>(*this); }
  [[nodiscard]] std::size_t bytes() const override {
    return stage_.bytes() + force_.bytes() + sumV_.bytes() + sumF_.bytes();
  }

 private:
  /// Starts the sums with k1 and moves the stage to y + c k1.
  void firstStage(Forces<T>& forces, const State<T>& state, double c) {
    const T step = T(c), kick = T(c * forces.inverseMass());
    const T *x = state.position.x(), *v = state.velocity.x(), *f = force_.x();
    T *stageX = stage_.position.x(), *stageV = stage_.velocity.x(), *sumV = sumV_.x(), *sumF = sumF_.x();
    forNumbers(forces.workers(), forces.layout(), [=](std::ptrdiff_t i) {
      sumV[i] = v[i];
      sumF[i] = f[i];
      stageX[i] = x[i] + step * v[i];
      stageV[i] = v[i] + kick * f[i];
    });
  }

  /// Adds the present k (twice, as k2 and k3 count) and moves the stage to y + c k.
  void innerStage(Forces<T>& forces, const State<T>& state, double c) {
    const T step = T(c), kick = T(c * forces.inverseMass());
    const T *x = state.position.x(), *v = state.velocity.x(), *f = force_.x();
    T *stageX = stage_.position.x(), *stageV = stage_.velocity.x(), *sumV = sumV_.x(), *sumF = sumF_.x();
    forNumbers(forces.workers(), forces.layout(), [=](std::ptrdiff_t i) {
      sumV[i] += 2 * stageV[i];
      sumF[i] += 2 * f[i];
      stageX[i] = x[i] + step * stageV[i];
      stageV[i] = v[i] + kick * f[i];
    });
  }

  void finish(Forces<T>& forces, State<T>& state, double h) {
    const T step = T(h / 6), kick = T(h / 6 * forces.inverseMass());
    T *x = state.position.x(), *v = state.velocity.x();
    const T *f = force_.x(), *stageV = stage_.velocity.x(), *sumV = sumV_.x(), *sumF = sumF_.x();
    forNumbers(forces.workers(), forces.layout(), [=](std::ptrdiff_t i) {
      x[i] += step * (sumV[i] + stageV[i]);
      v[i] += kick * (sumF[i] + f[i]);
    });
  }

  State<T> stage_;
  VectorField<T> force_, sumV_, sumF_;
};

/// R(z) = 1 + z + z^2/2 + z^3/6 + z^4/24.
double stableStep(double w2, double d) {
  constexpr double kGrowth[] = {1, 1, 1.0 / 2, 1.0 / 6, 1.0 / 24};
  return rungeKuttaLimit(kGrowth, w2, d);
}

}  // namespace

Method rk4Method() {
  return {.name = "rk4",
          .label = "Runge-Kutta 4",
          .scheme = "the classical Runge-Kutta method on (x, v)",
          .order = 4,
          .evaluationsPerStep = 4,
          .stableStep = stableStep,
          .makeFloat = make<Rk4, float>,
          .makeDouble = make<Rk4, double>};
}

}  // namespace tyg
