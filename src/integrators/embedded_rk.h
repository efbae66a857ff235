// One stepper for explicit Runge-Kutta methods with an embedded error estimate, driven by a table of coefficients.
//   K_i = f(y + h sum_j a_ij K_j);  y' = y + h sum_i b_i K_i;  error = h sum_i e_i K_i        (Butcher 1964)
// y = (x, v), so the position half of K_i is the stage's velocity and the velocity half its force / m.
// The tables used here have the last stage's row equal to b (first same as last): its force starts the next step.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/forces/field_ops.h"
#include "core/simulation/integrator.h"
#include "integrators/step_control.h"

namespace tyg {

/// `Table` has kStages, kA[kStages][kStages], kE[kStages] (constexpr doubles), and kRoots for the step control.
template <class T, class Table>
class EmbeddedRk final : public Integrator<T> {
 public:
  EmbeddedRk(const Scene& scene, const Sheet& sheet)
      : control_(controlOf(scene)), stagePosition_{Layout(sheet)}, errorFromRow_(std::size_t(sheet.rows)) {
    velocity_.fill(VectorField<T>{Layout(sheet)});
    force_.fill(VectorField<T>{Layout(sheet)});
  }

  void step(Forces<T>& forces, State<T>& state, double t, double h) override {
    attempt(forces, state, t, h);
    accept(forces, state, h);
  }

  double stepWithin(Forces<T>& forces, State<T>& state, double t, double most, double tolerance) override {
    while (true) {
      const double h = control_.propose(most);
      attempt(forces, state, t, h);
      if (control_.judge(h, errorOf(forces, state, h) / tolerance)) {
        accept(forces, state, h);
        return h;
      }
    }
  }

  void reset() override { haveFirst_ = false; }
  void useParameters(const Scene& scene, const Sheet& /*sheet*/) override {
    control_ = controlOf(scene);
    reset();
  }
  [[nodiscard]] std::unique_ptr<Integrator<T>> clone() const override { return std::make_unique<EmbeddedRk>(*this); }
  [[nodiscard]] std::size_t bytes() const override { return stagePosition_.bytes() + 2 * kStages * force_[0].bytes(); }

 private:
  static constexpr int kStages = Table::kStages;
  static constexpr int kLast = kStages - 1;
  using AllStages = std::make_index_sequence<kStages>;

  static StepControl controlOf(const Scene& scene) { return {firstStep(scene), Table::kRoots}; }

  /// c_i = sum_j a_ij, the share of the step after which the stage lies; exactly 1 for the last.
  static constexpr double timeOfStage(int i) {
    if (i == kLast) return 1;
    double sum = 0;
    for (int j = 0; j < i; ++j) sum += Table::kA[i][j];
    return sum;
  }

  /// Velocity of a stage; the first stage is the state itself.
  template <std::size_t j>
  [[nodiscard]] const T* stageVelocity(const State<T>& state) const {
    return j == 0 ? state.velocity.x() : velocity_[j].x();
  }

  /// Works out all stages; the last one is the new state.
  void attempt(Forces<T>& forces, const State<T>& state, double t, double h) {
    if (!haveFirst_) {
      forces.evaluate(t, state.position, state.velocity, force_[0]);
      power_[0] = forces.power();
    }
    haveFirst_ = true;
    stagesFrom<1>(forces, state, t, h);
  }

  template <int i>
  void stagesFrom(Forces<T>& forces, const State<T>& state, double t, double h) {
    if constexpr (i < kStages) {
      moveStage<i>(forces, state, h, std::make_index_sequence<i>{});
      forces.evaluate(t + timeOfStage(i) * h, stagePosition_, velocity_[i], force_[i]);
      power_[i] = forces.power();
      stagesFrom<i + 1>(forces, state, t, h);
    }
  }

  /// a_j k_j, or nothing at all where the table holds a zero.
  template <int i, std::size_t j>
  [[gnu::always_inline]] static void addTerm(T& sum, const T* k, std::ptrdiff_t n) {
    if constexpr (Table::kA[i][j] != 0) sum += T(Table::kA[i][j]) * k[n];
  }

  template <int i, std::size_t... j>
  void moveStage(Forces<T>& forces, const State<T>& state, double h, std::index_sequence<j...>) {
    const T step = T(h), kick = T(h * forces.inverseMass());
    const T *x = state.position.x(), *v = state.velocity.x();
    const T* const vs[] = {stageVelocity<j>(state)...};
    const T* const fs[] = {force_[j].x()...};
    T *stageX = stagePosition_.x(), *stageV = velocity_[i].x();
    forNumbers(forces.workers(), forces.layout(), [=](std::ptrdiff_t n) {
      T dx = 0, dv = 0;
      (addTerm<i, j>(dx, vs[j], n), ...);
      (addTerm<i, j>(dv, fs[j], n), ...);
      stageX[n] = x[n] + step * dx;
      stageV[n] = v[n] + kick * dv;
    });
  }

  void accept(Forces<T>& forces, State<T>& state, double h) {
    Power energy;
    for (int i = 0; i < kLast; ++i) energy.add(power_[std::size_t(i)], h * Table::kA[kLast][i]);
    forces.addEnergy(energy);
    std::swap(state.position, stagePosition_);
    std::swap(state.velocity, velocity_[kLast]);
    std::swap(force_[0], force_[kLast]);
    power_[0] = power_[kLast];
  }

  /// Largest component over all particles of the position error and of h times the velocity error, m.
  double errorOf(Forces<T>& forces, const State<T>& state, double h) {
    const T step = T(h), kick = T(h * h * forces.inverseMass());
    const Layout& layout = forces.layout();
    std::fill(errorFromRow_.begin(), errorFromRow_.end(), T(0));
    forces.workers().forBands(layout.rows, [&](int first, int last, int) {
      if (first == last) return;
      T& worst = errorFromRow_[std::size_t(first)];
      for (int axis = 0; axis < 3; ++axis) {
        const std::ptrdiff_t begin = axis * layout.plane + first * layout.stride;
        const std::ptrdiff_t end = begin + (last - first) * layout.stride;
        worst = std::max(worst, worstOf(state, step, kick, begin, end, AllStages{}));
      }
    });
    return double(*std::max_element(errorFromRow_.begin(), errorFromRow_.end()));
  }

  template <std::size_t j>
  [[gnu::always_inline]] static void addError(T& sum, const T* k, std::ptrdiff_t n) {
    if constexpr (Table::kE[j] != 0) sum += T(Table::kE[j]) * k[n];
  }

  template <std::size_t... j>
  [[nodiscard]] T worstOf(const State<T>& state, T step, T kick, std::ptrdiff_t begin, std::ptrdiff_t end,
                          std::index_sequence<j...>) const {
    const T* const vs[] = {stageVelocity<j>(state)...};
    const T* const fs[] = {force_[j].x()...};
    T worst = 0;
    bool finite = true;
    for (std::ptrdiff_t n = begin; n < end; ++n) {
      T ex = 0, ev = 0;
      (addError<j>(ex, vs[j], n), ...);
      (addError<j>(ev, fs[j], n), ...);
      const T inPosition = std::abs(step * ex), inVelocity = std::abs(kick * ev);
      constexpr T kLargest = std::numeric_limits<T>::max();
      finite = finite && inPosition <= kLargest && inVelocity <= kLargest;  // max() alone would let NaN pass
      worst = std::max(worst, std::max(inPosition, inVelocity));
    }
    return finite ? worst : std::numeric_limits<T>::infinity();
  }

  StepControl control_;
  VectorField<T> stagePosition_;
  std::array<VectorField<T>, kStages> velocity_, force_;  // velocity_[0] stays unused
  std::array<Power, kStages> power_{};                    // W, where it is wanted
  bool haveFirst_ = false;                                // force_[0] belongs to the state that the last step left
  std::vector<T> errorFromRow_;                           // of each thread's band, at its first row
};

}  // namespace tyg
