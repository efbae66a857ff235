// Explicit Euler (Euler 1768): position and velocity both move with what they were at the start of the step.
#include "core/field_ops.h"
#include "integrators/factories.h"

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

}  // namespace

template <class T>
std::unique_ptr<Integrator<T>> makeExplicitEuler(const Scene& /*scene*/, const Sheet& sheet) {
  return std::make_unique<ExplicitEuler<T>>(Layout(sheet));
}
template std::unique_ptr<Integrator<float>> makeExplicitEuler(const Scene&, const Sheet&);
template std::unique_ptr<Integrator<double>> makeExplicitEuler(const Scene&, const Sheet&);

}  // namespace tyg
