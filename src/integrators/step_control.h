// How an adaptive method chooses its next step: a proportional-integral controller (Gustafsson 1991).
#pragma once

#include <algorithm>
#include <cmath>

#include "core/spectrum/lattice.h"

namespace tyg {

/// A first step to try, s: a tenth of the fastest wave's time scale; a hundredth of the run where nothing oscillates.
inline double firstStep(const Scene& scene) {
  constexpr int kIntervals = 8;
  double fastest = 0;
  const Lattice lattice(scene);
  lattice.forWaves(kIntervals, [&](double qx, double qy) {
    for (const Mode& mode : lattice.modes(qx, qy)) fastest = std::max({fastest, std::sqrt(mode.w2), mode.d});
  });
  const double step = 0.1 / fastest;
  return step > 0 && step < scene.duration ? step : 0.01 * scene.duration;
}

/// With r = error / tolerance of a step, the next one is h * 0.9 * r^-a * rPrevious^b, at most 5 times and at least a
/// fifth of h. The exponents a = 2^-roots, b = a / 2 are near the usual 0.7/p and 0.4/p of a method whose error is of
/// order p, and powers of two, so that square roots are enough: other powers differ from one system to the next.
class StepControl {
 public:
  /// `first`: the step to try first, s, > 0.
  StepControl(double first, int roots) : proposal_(first), smallest_(first * 1e-9), roots_(roots) {}

  /// The step to try where at most `most` seconds are left to the next stop. Never leaves a sliver for the last step.
  [[nodiscard]] double propose(double most) const {
    if (proposal_ >= most) return most;
    return 2 * proposal_ > most ? most / 2 : proposal_;
  }

  /// Takes the ratio of a step of h and says whether the step counts. A step of a billionth of the first one always
  /// does: what it then does to the cloth is the alarm's affair.
  bool judge(double h, double ratio) {
    const double r = std::max(ratio, 1e-8);
    if (!(r <= 1) && h > smallest_) {
      const double factor = 0.9 * root(1 / r, roots_);
      proposal_ = h * (factor > 0.1 ? factor : 0.1);
      return false;
    }
    const double factor = std::clamp(0.9 * root(1 / r, roots_) * root(previous_, roots_ + 1), 0.2, 5.0);
    const bool cutByStop = h < proposal_;
    proposal_ = cutByStop ? std::max(proposal_, h * factor) : h * factor;
    previous_ = std::clamp(r, 1e-4, 1.0);
    return true;
  }

 private:
  static double root(double value, int count) {
    for (int k = 0; k < count; ++k) value = std::sqrt(value);
    return value;
  }

  double proposal_, smallest_;
  int roots_;
  double previous_ = 1;
};

}  // namespace tyg
