// Symplectic Euler (de Vogelaere 1956): the new velocity moves the position. The 2017 report's own Euler.
#include "integrators/factories.h"
#include "integrators/kick_and_drift.h"

namespace tyg {
namespace {

template <class T>
class SymplecticEuler final : public Integrator<T> {
 public:
  explicit SymplecticEuler(const Layout& layout) : force_(layout) {}

  void step(Forces<T>& forces, State<T>& state, double h) override { kickAndDrift(forces, state, force_, h); }
  void steps(Forces<T>& forces, State<T>& state, double h, int count) override {
    if (!forces.canAdvance()) return Integrator<T>::steps(forces, state, h, count);
    forces.kickAndDrift(state, h, count);
  }
  [[nodiscard]] std::unique_ptr<Integrator<T>> clone() const override {
    return std::make_unique<SymplecticEuler>(*this);
  }
  [[nodiscard]] std::size_t bytes() const override { return force_.bytes(); }

 private:
  VectorField<T> force_;
};

}  // namespace

template <class T>
std::unique_ptr<Integrator<T>> makeSymplecticEuler(const Scene& /*scene*/, const Sheet& sheet) {
  return std::make_unique<SymplecticEuler<T>>(Layout(sheet));
}
template std::unique_ptr<Integrator<float>> makeSymplecticEuler(const Scene&, const Sheet&);
template std::unique_ptr<Integrator<double>> makeSymplecticEuler(const Scene&, const Sheet&);

}  // namespace tyg
