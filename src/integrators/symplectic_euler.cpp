// Symplectic Euler (de Vogelaere 1956): the new velocity moves the position. The 2017 report's own Euler.
#include "integrators/kick_and_drift.h"
#include "integrators/make.h"
#include "integrators/stable_step.h"

namespace tyg {
namespace {

template <class T>
class SymplecticEuler final : public Integrator<T> {
 public:
  explicit SymplecticEuler(const Layout& layout) : force_(layout) {}

  void step(Forces<T>& forces, State<T>& state, double t, double h) override {
    kickAndDrift(forces, state, force_, t, h);
  }
  void steps(Forces<T>& forces, State<T>& state, const StepTimes& times, int count) override {
    if (!forces.canAdvance()) return Integrator<T>::steps(forces, state, times, count);
    forces.kickAndDrift(state, times.h, times, count);
  }
  [[nodiscard]] std::unique_ptr<Integrator<T>> clone() const override {
    return std::make_unique<SymplecticEuler>(*this);
  }
  [[nodiscard]] std::size_t bytes() const override { return force_.bytes(); }

 private:
  VectorField<T> force_;
};

/// Step matrix: determinant 1 - h d, trace 2 - h d - h^2 w2; both eigenvalues within the unit circle while
/// h^2 w2 + 2 h d <= 4.
double stableStep(double w2, double d) { return positiveRoot(w2, 2 * d); }

}  // namespace

Method symplecticEulerMethod() {
  return {.name = "symplectic-euler",
          .label = "Symplectic Euler",
          .scheme = "v' = v + h a(x, v); x' = x + h v'",
          .order = 1,
          .evaluationsPerStep = 1,
          .stableStep = stableStep,
          .makeFloat = make<SymplecticEuler, float>,
          .makeDouble = make<SymplecticEuler, double>};
}

}  // namespace tyg
