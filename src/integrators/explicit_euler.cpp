// Explicit Euler (Euler 1768): position and velocity both move with what they were at the start of the step.
#include "core/forces/field_ops.h"
#include "core/spectrum/lattice.h"
#include "integrators/make.h"
#include "integrators/stable_step.h"

namespace tyg {
namespace {

template <class T>
class ExplicitEuler final : public Integrator<T> {
 public:
  explicit ExplicitEuler(const Layout& layout) : force_(layout) {}

  void step(Forces<T>& forces, State<T>& state, double h) override {
    forces.evaluate(state.position, state.velocity, force_);
    forces.dissipate(h);
    const T step = T(h), kick = T(h * forces.inverseMass());
    T *x = state.position.x(), *v = state.velocity.x();
    const T* f = force_.x();
    forNumbers(forces.workers(), forces.layout(), [=](std::ptrdiff_t i) {
      x[i] += step * v[i];
      v[i] += kick * f[i];
    });
  }
  [[nodiscard]] std::unique_ptr<Integrator<T>> clone() const override { return std::make_unique<ExplicitEuler>(*this); }
  [[nodiscard]] std::size_t bytes() const override { return force_.bytes(); }

 private:
  VectorField<T> force_;
};

/// |1 + h mu| <= 1. Complex pair: |1 + h mu|^2 = 1 - h d + h^2 w2, so h <= d / w2; real: h <= 2 / |mu|.
double stableStep(double w2, double d) {
  const std::complex<double> mu = rootsOf({w2, d})[0];
  if (mu.imag() != 0) return d / w2;
  return mu.real() == 0 ? kEveryStep : 2 / -mu.real();
}

}  // namespace

Method explicitEulerMethod() {
  return {.name = "explicit-euler",
          .label = "Explicit Euler",
          .scheme = "x' = x + h v; v' = v + h a(x, v)",
          .order = 1,
          .evaluationsPerStep = 1,
          .stableStep = stableStep,
          .makeFloat = make<ExplicitEuler, float>,
          .makeDouble = make<ExplicitEuler, double>};
}

}  // namespace tyg
