// The 2017 report's Runge-Kutta as printed, for the velocity with f = a and then for the position with f = the new
// velocity: symplectic Euler with a longer step. First order; kept because the report ran it.
#include "integrators/report_rk4.h"

#include "integrators/factories.h"
#include "integrators/kick_and_drift.h"

namespace tyg {
namespace {

template <class T>
class ReportRk4 final : public Integrator<T> {
 public:
  explicit ReportRk4(const Layout& layout) : force_(layout) {}

  void step(Forces<T>& forces, State<T>& state, double h) override {
    kickAndDrift(forces, state, force_, reportRk4Step(h));
  }
  void steps(Forces<T>& forces, State<T>& state, double h, int count) override {
    if (!forces.canAdvance()) return Integrator<T>::steps(forces, state, h, count);
    forces.kickAndDrift(state, reportRk4Step(h), count);
  }
  [[nodiscard]] std::unique_ptr<Integrator<T>> clone() const override { return std::make_unique<ReportRk4>(*this); }
  [[nodiscard]] std::size_t bytes() const override { return force_.bytes(); }

 private:
  VectorField<T> force_;
};

}  // namespace

template <class T>
std::unique_ptr<Integrator<T>> makeReportRk4(const Scene& /*scene*/, const Sheet& sheet) {
  return std::make_unique<ReportRk4<T>>(Layout(sheet));
}
template std::unique_ptr<Integrator<float>> makeReportRk4(const Scene&, const Sheet&);
template std::unique_ptr<Integrator<double>> makeReportRk4(const Scene&, const Sheet&);

}  // namespace tyg
