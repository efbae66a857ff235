// Second-order Runge-Kutta-Chebyshev (Sommeijer, Shampine, Verwer, "RKC: an explicit solver for parabolic PDEs", 1998,
// eq. 2.1-2.4): more stages instead of smaller steps where damping rules. With y = (x, v), F = (v, force / m):
//   Y1 = Y0 + m1 h F0;  Yj = (1 - mu - nu) Y0 + mu Y(j-1) + nu Y(j-2) + mt h F(j-1) + gt h F0;  y' = Ys
// The stages are the fewest for which every wave of the sheet stays bounded; a step at which none do is past the
// method's limit, and gets two.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/forces/field_ops.h"
#include "core/forces/term.h"
#include "integrators/chebyshev.h"
#include "integrators/chebyshev_table.h"
#include "integrators/make.h"

namespace tyg {
namespace {

template <class T>
class Rkc2 final : public Integrator<T> {
 public:
  Rkc2(const Scene& scene, const Sheet& sheet) {
    useParameters(scene, sheet);
    const Layout layout(sheet);
    for (State<T>* stage : {&before_, &now_, &next_}) *stage = State<T>(layout);
    force0_ = force_ = VectorField<T>(layout);
  }

  void step(Forces<T>& forces, State<T>& state, double t, double h) override {
    if (h != tableFor_) chooseStages(h);
    const ChebyshevTable& c = *table_;
    const double kick = forces.inverseMass();
    forces.evaluate(t, state.position, state.velocity, force0_);
    const Power power0 = forces.power();
    const double m1 = c.b[1] * c.w1;
    before_ = state;
    moveFirst(forces, state, m1 * h, kick);
    Power spent, spentBefore;  // the integral of the power over h, as more components of y
    spent.add(power0, m1);
    double share = m1, shareBefore = 0;  // the time since t over h, likewise
    for (int j = 2; j <= stages_.count; ++j) {
      const auto at = [&](int k) { return std::size_t(k); };
      const double mu = 2 * c.b[at(j)] * c.w0 / c.b[at(j - 1)], nu = -c.b[at(j)] / c.b[at(j - 2)];
      const double mt = 2 * c.b[at(j)] * c.w1 / c.b[at(j - 1)];
      const double gt = -(1 - c.b[at(j - 1)] * c.value[at(j - 1)]) * mt;
      forces.evaluate(t + share * h, now_.position, now_.velocity, force_);
      Power spentNext;
      spentNext.add(spent, mu), spentNext.add(spentBefore, nu);
      spentNext.add(forces.power(), mt), spentNext.add(power0, gt);
      moveNext(forces, state, {mu, nu, mt * h, gt * h}, kick);
      std::swap(before_, now_);
      std::swap(now_, next_);
      spentBefore = spent;
      spent = spentNext;
      const double shareNext = mu * share + nu * shareBefore + mt + gt;
      shareBefore = share;
      share = shareNext;
    }
    Power energy;
    energy.add(spent, h);
    forces.addEnergy(energy);
    std::swap(state, now_);
  }
  /// The waves do not depend on gravity, nor on the tolerance.
  void useParameters(const Scene& scene, const Sheet& sheet) override {
    const auto values = whatWavesDependOn(scene);
    if (values == modesOf_) return;
    modes_ = chebyshevModes(scene, false);
    modesInPieces_.clear();
    if (!sheet.missing.none()) modesInPieces_ = chebyshevModes(scene, true);
    modesOf_ = values;
    tableFor_ = 0;
  }
  [[nodiscard]] std::unique_ptr<Integrator<T>> clone() const override { return std::make_unique<Rkc2>(*this); }
  [[nodiscard]] std::size_t bytes() const override { return 3 * now_.bytes() + force0_.bytes() + force_.bytes(); }

 private:
  struct Weights {
    double mu, nu, mt, gt;  // the last two in seconds
  };

  static std::array<std::vector<Vec3>, 3> whatWavesDependOn(const Scene& scene) {
    const double across = holdingTerm(scene).hold.across;
    return {valuesOf(scene, Role::Stiffness), valuesOf(scene, Role::Damping), {Vec3{cellDamping(scene), across, 0}}};
  }

  /// A step that is too long for whatever may be left of the sheet may still do for what really is.
  void chooseStages(double h) {
    stages_ = {};
    if (!modesInPieces_.empty()) stages_ = chebyshevStages(modesInPieces_, h);
    if (stages_.count == 0) stages_ = chebyshevStages(modes_, h);
    if (stages_.count == 0) stages_.count = 2;
    table_ = std::make_shared<const ChebyshevTable>(stages_);
    tableFor_ = h;
  }

  /// now = y + c F0.
  void moveFirst(Forces<T>& forces, const State<T>& state, double c, double kick) {
    const T cx = T(c), cv = T(c * kick);
    const T *x = state.position.x(), *v = state.velocity.x(), *f0 = force0_.x();
    T *toX = now_.position.x(), *toV = now_.velocity.x();
    forNumbers(forces.workers(), forces.layout(), [=](std::ptrdiff_t i) {
      toX[i] = x[i] + cx * v[i];
      toV[i] = v[i] + cv * f0[i];
    });
  }

  /// next = y + mu (now - y) + nu (before - y) + mt F(now) + gt F0: sums of differences keep rounding small.
  void moveNext(Forces<T>& forces, const State<T>& state, const Weights& w, double kick) {
    const T mu = T(w.mu), nu = T(w.nu), mtX = T(w.mt), gtX = T(w.gt), mtV = T(w.mt * kick), gtV = T(w.gt * kick);
    const T *x = state.position.x(), *v = state.velocity.x(), *f0 = force0_.x(), *f = force_.x();
    const T *nowX = now_.position.x(), *nowV = now_.velocity.x();
    const T *beforeX = before_.position.x(), *beforeV = before_.velocity.x();
    T *toX = next_.position.x(), *toV = next_.velocity.x();
    forNumbers(forces.workers(), forces.layout(), [=](std::ptrdiff_t i) {
      toX[i] = x[i] + (mu * (nowX[i] - x[i]) + nu * (beforeX[i] - x[i]) + mtX * nowV[i] + gtX * v[i]);
      toV[i] = v[i] + (mu * (nowV[i] - v[i]) + nu * (beforeV[i] - v[i]) + mtV * f[i] + gtV * f0[i]);
    });
  }

  std::vector<Mode> modes_;
  std::vector<Mode> modesInPieces_;           // where springs are gone, else empty
  std::array<std::vector<Vec3>, 3> modesOf_;  // of the scene that modes_ are of
  State<T> before_, now_, next_;
  VectorField<T> force0_, force_;
  ChebyshevStages stages_;
  double tableFor_ = 0;  // s, the step that table_ was made for
  std::shared_ptr<const ChebyshevTable> table_;
};

/// Doubled from far below until no number of stages holds every wave, then bisected. A wave without damping grows at
/// any step: on the imaginary axis |P_s| > 1.
double stableStepOfScene(const Scene& scene) {
  const std::vector<Mode> modes = chebyshevModes(scene, losesSprings(scene));
  ChebyshevReach reach(modes);
  const auto holds = [&](double h) { return reach.holds(h); };
  double fastest = 0;
  for (const Mode& mode : modes) fastest = std::max({fastest, std::sqrt(mode.w2), mode.d});
  if (fastest == 0) return std::numeric_limits<double>::infinity();
  if (!std::isfinite(fastest)) return 0;
  constexpr double kRounding = 1e-9;
  const auto undamped = [&](const Mode& mode) {
    const double w = std::sqrt(mode.w2);
    return w > kRounding * fastest && mode.d <= kRounding * w;
  };
  if (std::ranges::any_of(modes, undamped)) return 0;
  double inside = 1e-6 / fastest;
  constexpr double kFarBeyondTheStages = 1e9;  // of the fastest wave's time
  while (inside * fastest < kFarBeyondTheStages && holds(2 * inside)) inside *= 2;
  double outside = 2 * inside;
  for (int k = 0; k < 13; ++k) {  // to a ten-thousandth
    const double middle = (inside + outside) / 2;
    (holds(middle) ? inside : outside) = middle;
  }
  return inside;
}

/// Without damping the fewest stages are two, of which none is stable: |P_2(i y)|^2 = 1 + y^4 / 4.
std::string noteOnLimit(const LimitFinding& finding) {
  if (finding.predicted > 0) {
    return fmt::format(
        "rkc2 takes as many stages as its step needs to hold every wave, {} at most; past its limit none do.",
        kMostChebyshevStages);
  }
  if (finding.predicted != 0) return "";
  return fmt::format(
      "rkc2 without damping: no step is stable, whatever the stages. Two, the fewest, multiply the fastest mode by "
      "1 + (h w)^4 / 8 each step, w = {:.4g} /s: a growth by 1000 in {:.3g} s is survived only below {:.3g} ms.",
      std::sqrt(finding.w2), finding.seconds,
      1e3 * std::cbrt(8 * std::log(1000.0) / (finding.w2 * finding.w2 * finding.seconds)));
}

}  // namespace

Method rkc2Method() {
  return {.name = "rkc2",
          .label = "Runge-Kutta-Chebyshev 2",
          .scheme = "as many stages as the damping needs",
          .order = 2,
          .evaluationsPerStep = -1,
          .stableStepOfScene = stableStepOfScene,
          .noteOnLimit = noteOnLimit,
          .makeFloat = make<Rkc2, float>,
          .makeDouble = make<Rkc2, double>};
}

}  // namespace tyg
