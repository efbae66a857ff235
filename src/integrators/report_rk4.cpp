// The 2017 report's Runge-Kutta as printed, for the velocity with f = a and then for the position with f = the new
// velocity: symplectic Euler with a longer step. First order; kept because the report ran it.
#include <algorithm>
#include <cmath>

#include "integrators/kick_and_drift.h"
#include "integrators/make.h"
#include "integrators/stable_step.h"

namespace tyg {
namespace {

/// The report's equations 5-6 as printed: k1 = f, k2 = f + h/2 k1, k3 = f + h/2 k2, k4 = f + h k3 and
/// y' = y + h/6 (k1 + 2 k2 + 2 k3 + k4). The state never moves between the stages, so all of them hold the same f, and
/// the sum is y' = y + H f with H = h (1 + h/2 + h^2/6 + h^3/24), whatever unit h is given in.
constexpr double stepTaken(double h) { return h * (1 + h / 2 + h * h / 6 + h * h * h / 24); }

template <class T>
class ReportRk4 final : public Integrator<T> {
 public:
  explicit ReportRk4(const Layout& layout) : force_(layout) {}

  void step(Forces<T>& forces, State<T>& state, double t, double h) override {
    kickAndDrift(forces, state, force_, t, stepTaken(h));
  }
  void steps(Forces<T>& forces, State<T>& state, const StepTimes& times, int count) override {
    if (!forces.canAdvance()) return Integrator<T>::steps(forces, state, times, count);
    forces.kickAndDrift(state, stepTaken(times.h), times, count);
  }
  [[nodiscard]] std::unique_ptr<Integrator<T>> clone() const override { return std::make_unique<ReportRk4>(*this); }
  [[nodiscard]] std::size_t bytes() const override { return force_.bytes(); }

 private:
  VectorField<T> force_;
};

/// Symplectic Euler's limit, h^2 w2 + 2 h d <= 4, holds for the step really taken; solved for h by Newton's method
/// (that step is convex in h), from above: neither h nor h^4/24 is more than the step.
double stableStep(double w2, double d) {
  const double limit = positiveRoot(w2, 2 * d);
  if (limit == kEveryStep) return kEveryStep;
  double h = std::min(limit, std::sqrt(std::sqrt(24.0)) * std::sqrt(std::sqrt(limit)));
  for (int k = 0; k < 50; ++k) h -= (stepTaken(h) - limit) / (1 + h + h * h / 2 + h * h * h / 6);
  return h;
}

}  // namespace

Method reportRk4Method() {
  return {.name = "report-rk4",
          .label = "RK4 as the report printed it",
          .scheme = "symplectic Euler with h (1 + h/2 + h^2/6 + h^3/24)",
          .order = 1,
          .evaluationsPerStep = 1,
          .stableStep = stableStep,
          .advisable = false,  // it is kept to show a mistake: its results depend on the unit of time
          .makeFloat = make<ReportRk4, float>,
          .makeDouble = make<ReportRk4, double>};
}

}  // namespace tyg
