// The steps of the student's program: of all particles together, and of one particle while the others stand where they
// happen to be.
#include <array>

#include "study/check/student_program.h"
#include "study/check/vectors.h"

namespace tyg {

/// Each method twice: `step` of all particles, `alone` of one.
struct StudentSteps {
  using Program = StudentProgram;

  /// The step that the report's four stages add up to.
  static double reportStep(double h) { return h * (1 + h / 2 + h * h / 6 + h * h * h / 24); }

  static void evaluate(Program& p) { p.accelerations(p.x_, p.v_, p.a_); }
  static void move(std::vector<Vec3>& x, double h, const std::vector<Vec3>& v) {
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += h * v[i];
  }

  static void explicitEuler(Program& p, double h) {
    evaluate(p);
    move(p.x_, h, p.v_);
    move(p.v_, h, p.a_);
  }
  static void symplecticEuler(Program& p, double h) {
    evaluate(p);
    move(p.v_, h, p.a_);
    move(p.x_, h, p.v_);
  }
  static void reportRk4(Program& p, double h) { symplecticEuler(p, reportStep(h)); }
  static void positionFirst(Program& p, double h) {
    move(p.x_, h, p.v_);
    evaluate(p);
    move(p.v_, h, p.a_);
  }

  /// x' = x + h v + h^2/2 a, v' = v + h a: what every method of several stages becomes where the force stays.
  static void stale(Program& p, double h) {
    evaluate(p);
    move(p.x_, h, p.v_);
    move(p.x_, h * h / 2, p.a_);
    move(p.v_, h, p.a_);
  }

  /// Which velocity the damping sees at the end of a step of velocity Verlet.
  enum class Predicted { Full, Half, Old };
  template <Predicted predicted>
  static void leapfrog(Program& p, double h) {
    if (p.habits_.stale) return stale(p, h);
    if (!p.haveForce_) evaluate(p);
    p.haveForce_ = true;
    p.stageV_ = p.v_;
    move(p.v_, h / 2, p.a_);
    move(p.x_, h, p.v_);
    if (predicted != Predicted::Old) p.stageV_ = p.v_;
    if (predicted == Predicted::Full) move(p.stageV_, h / 2, p.a_);
    p.accelerations(p.x_, p.stageV_, p.a_);
    move(p.v_, h / 2, p.a_);
  }

  /// Explicit Runge-Kutta methods each of whose stages needs the one before alone: shares of the step at which the
  /// stages lie, and their weights.
  template <std::size_t n>
  struct Table {
    std::array<double, n> at, weight;
  };
  static constexpr Table<4> kRk4{{0, 0.5, 0.5, 1}, {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6}};
  static constexpr Table<2> kHeun{{0, 1}, {0.5, 0.5}}, kMidpoint{{0, 0.5}, {0, 1}};

  template <const auto& table>
  static void rungeKutta(Program& p, double h) {
    if (p.habits_.stale) return stale(p, h);
    p.sumX_ = p.x_, p.sumV_ = p.v_;
    p.stageV_ = p.v_;
    for (std::size_t k = 0; k < table.at.size(); ++k) {
      p.stageX_ = p.x_;
      if (k > 0) {
        move(p.stageX_, h * table.at[k], p.stageV_);
        p.stageV_ = p.v_;
        move(p.stageV_, h * table.at[k], p.a_);
      }
      p.accelerations(p.stageX_, p.stageV_, p.a_);
      move(p.sumX_, h * table.weight[k], p.stageV_);
      move(p.sumV_, h * table.weight[k], p.a_);
    }
    p.x_.swap(p.sumX_), p.v_.swap(p.sumV_);
  }

  static void explicitEulerAlone(Program& p, int particle, double h) {
    const auto i = std::size_t(particle);
    const Vec3 a = p.accelerationOf(particle, p.x_[i], p.v_[i]);
    p.x_[i] += h * p.v_[i];
    p.v_[i] += h * a;
  }
  static void symplecticEulerAlone(Program& p, int particle, double h) {
    const auto i = std::size_t(particle);
    p.v_[i] += h * p.accelerationOf(particle, p.x_[i], p.v_[i]);
    p.x_[i] += h * p.v_[i];
  }
  static void reportRk4Alone(Program& p, int particle, double h) { symplecticEulerAlone(p, particle, reportStep(h)); }
  static void positionFirstAlone(Program& p, int particle, double h) {
    const auto i = std::size_t(particle);
    p.x_[i] += h * p.v_[i];
    p.v_[i] += h * p.accelerationOf(particle, p.x_[i], p.v_[i]);
  }
  template <Predicted predicted>
  static void leapfrogAlone(Program& p, int particle, double h) {
    const auto i = std::size_t(particle);
    if (!p.haveForce_) p.a_[i] = p.accelerationOf(particle, p.x_[i], p.v_[i]);
    const Vec3 half = p.v_[i] + (h / 2) * p.a_[i];
    p.x_[i] += h * half;
    const Vec3 seen = predicted == Predicted::Full   ? half + (h / 2) * p.a_[i]
                      : predicted == Predicted::Half ? half
                                                     : p.v_[i];
    p.a_[i] = p.accelerationOf(particle, p.x_[i], seen);
    p.v_[i] = half + (h / 2) * p.a_[i];
  }
  template <const auto& table>
  static void rungeKuttaAlone(Program& p, int particle, double h) {
    const auto i = std::size_t(particle);
    Vec3 x = p.x_[i], v = p.v_[i], a, stageV = v;
    for (std::size_t k = 0; k < table.at.size(); ++k) {
      const Vec3 stageX = p.x_[i] + (h * table.at[k]) * stageV;
      stageV = p.v_[i] + (h * table.at[k]) * a;
      a = p.accelerationOf(particle, stageX, stageV);
      x += (h * table.weight[k]) * stageV;
      v += (h * table.weight[k]) * a;
    }
    p.x_[i] = x, p.v_[i] = v;
  }
};

std::span<const StudentMethod> studentMethods() {
  using S = StudentSteps;
  using P = S::Predicted;
  static constexpr std::array kMethods = {
      StudentMethod{"explicit-euler", "explicit Euler", 1, 1, true, S::explicitEuler, S::explicitEulerAlone},
      StudentMethod{"symplectic-euler", "symplectic Euler", 1, 1, true, S::symplecticEuler, S::symplecticEulerAlone},
      StudentMethod{"report-rk4", "the report's Runge-Kutta", 1, 1, true, S::reportRk4, S::reportRk4Alone},
      StudentMethod{"rk4", "the classical Runge-Kutta method", 4, 4, true, S::rungeKutta<S::kRk4>,
                    S::rungeKuttaAlone<S::kRk4>},
      StudentMethod{"leapfrog", "leapfrog", 2, 1, true, S::leapfrog<P::Full>, S::leapfrogAlone<P::Full>},
      StudentMethod{"leapfrog with the half step's velocity in the damping",
                    "leapfrog with the half step's velocity in the damping", 1, 1, false, S::leapfrog<P::Half>,
                    S::leapfrogAlone<P::Half>},
      StudentMethod{"leapfrog with the old velocity in the damping", "leapfrog with the old velocity in the damping", 1,
                    1, false, S::leapfrog<P::Old>, S::leapfrogAlone<P::Old>},
      StudentMethod{"position-first Euler", "symplectic Euler that moves the position first", 1, 1, false,
                    S::positionFirst, S::positionFirstAlone},
      StudentMethod{"heun", "Heun's method", 2, 2, false, S::rungeKutta<S::kHeun>, S::rungeKuttaAlone<S::kHeun>},
      StudentMethod{"midpoint", "the explicit midpoint method", 2, 2, false, S::rungeKutta<S::kMidpoint>,
                    S::rungeKuttaAlone<S::kMidpoint>},
  };
  return kMethods;
}

}  // namespace tyg
