// Explicit Euler (Euler 1768): position and velocity both move with what they were at the start of the step.
#include <fmt/core.h>

#include <cmath>

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

  void step(Forces<T>& forces, State<T>& state, double t, double h) override {
    forces.evaluate(t, state.position, state.velocity, force_);
    forces.addPower(h);
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

/// What the row without damping means, where no step is stable.
std::string noteWithoutDamping(const LimitFinding& finding) {
  constexpr double kGrowth = 1000;
  std::string note = fmt::format(
      "explicit-euler without damping: no step is stable. Each multiplies the fastest mode by sqrt(1 + h^2 w^2), "
      "w = {:.4g} /s, so that over T seconds a growth by G is survived only below h = 2 ln(G) / (w^2 T): {:.3g} ms for "
      "G = 1000 in {:.3g} s.",
      std::sqrt(finding.w2), 1e3 * survivedStep(finding.w2, finding.seconds, kGrowth), finding.seconds);
  if (finding.survived > 0 && std::isfinite(finding.survived)) {
    const double decades = finding.survived * finding.w2 * finding.seconds / 2 / std::log(10.0);
    note += fmt::format(" The {:.3g} ms that held had it grow by 10^{:.1f}, from rounding and buckling.",
                        1e3 * finding.survived, decades);
  }
  return note;
}

std::string noteOnLimit(const LimitFinding& finding) {
  if (finding.predicted == 0 && !finding.damped) return noteWithoutDamping(finding);
  if (!(finding.predicted > 0) || finding.byDamping) return "";
  return "explicit-euler with damping: past its limit the least damped mode grows, but slowly; what holds above the "
         "prediction is what the run was too short to show.";
}

}  // namespace

Method explicitEulerMethod() {
  return {.name = "explicit-euler",
          .label = "Explicit Euler",
          .scheme = "x' = x + h v; v' = v + h a(x, v)",
          .order = 1,
          .evaluationsPerStep = 1,
          .stableStep = stableStep,
          .noteOnLimit = noteOnLimit,
          .makeFloat = make<ExplicitEuler, float>,
          .makeDouble = make<ExplicitEuler, double>};
}

}  // namespace tyg
