// Methods that are wrong on purpose, in the ways that teaching code is, and the checks that find each of them out. A
// right method passes the same checks, here and in the tests of all methods.
#include <gtest/gtest.h>

#include <array>

#include "core/simulation/integrator.h"
#include "method_checks.h"
#include "tyg/methods.h"

namespace tyg::test {
namespace {

/// A method of the tests' own, for one thread: x' and v' from particle to particle, or all at once.
class Wrong : public Integrator<double> {
 public:
  [[nodiscard]] std::size_t bytes() const override { return 0; }  // nobody asks

 protected:
  explicit Wrong(const Sheet& sheet) : count_(sheet.count()), force_(Layout(sheet)) {}

  [[nodiscard]] int count() const { return count_; }
  /// a(x, v) of one particle after an evaluation.
  [[nodiscard]] Vec3 acceleration(const Forces<double>& forces, int particle) const {
    return forces.inverseMass() * force_.get(particle);
  }
  void evaluate(Forces<double>& forces, const VectorField<double>& x, const VectorField<double>& v) {
    forces.evaluate(0, x, v, force_);
  }
  static void move(VectorField<double>& field, int particle, double by, const Vec3& rate) {
    field.set(particle, field.get(particle) + by * rate);
  }

 private:
  int count_;
  VectorField<double> force_;
};

/// Symplectic Euler that moves each particle before the force on the next one is read.
class UpdatesInPlace final : public Wrong {
 public:
  explicit UpdatesInPlace(const Sheet& sheet) : Wrong(sheet) {}
  void step(Forces<double>& forces, State<double>& state, double /*t*/, double h) override {
    for (int i = 0; i < count(); ++i) {
      evaluate(forces, state.position, state.velocity);
      move(state.velocity, i, h, acceleration(forces, i));
      move(state.position, i, h, state.velocity.get(i));
    }
  }
  [[nodiscard]] std::unique_ptr<Integrator> clone() const override { return std::make_unique<UpdatesInPlace>(*this); }
};

/// The classical Runge-Kutta method whose stages read the positions of the step's start.
class ForgetsToMoveStages final : public Wrong {
 public:
  explicit ForgetsToMoveStages(const Sheet& sheet) : Wrong(sheet), stageV_(Layout(sheet)), sumV_(stageV_) {}
  void step(Forces<double>& forces, State<double>& state, double /*t*/, double h) override {
    constexpr std::array kReach = {0.5, 0.5, 1.0, 0.0}, kWeight = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};
    stageV_ = state.velocity, sumV_ = state.velocity;
    VectorField<double> sumX = state.position;
    for (std::size_t stage = 0; stage < kReach.size(); ++stage) {
      evaluate(forces, state.position, stageV_);
      for (int i = 0; i < count(); ++i) {
        move(sumX, i, h * kWeight[stage], stageV_.get(i));
        move(sumV_, i, h * kWeight[stage], acceleration(forces, i));
        stageV_.set(i, state.velocity.get(i) + h * kReach[stage] * acceleration(forces, i));
      }
    }
    state.position = sumX, state.velocity = sumV_;
  }
  [[nodiscard]] std::unique_ptr<Integrator> clone() const override {
    return std::make_unique<ForgetsToMoveStages>(*this);
  }

 private:
  VectorField<double> stageV_, sumV_;
};

/// Velocity Verlet that keeps its acceleration when the force jumps.
class KeepsAStaleAcceleration final : public Wrong {
 public:
  explicit KeepsAStaleAcceleration(const Sheet& sheet) : Wrong(sheet), predicted_(Layout(sheet)) {}
  void step(Forces<double>& forces, State<double>& state, double /*t*/, double h) override {
    if (!begun_) evaluate(forces, state.position, state.velocity);
    begun_ = true;
    for (int i = 0; i < count(); ++i) {
      const Vec3 a = acceleration(forces, i);
      move(state.velocity, i, h / 2, a);
      move(state.position, i, h, state.velocity.get(i));
      predicted_.set(i, state.velocity.get(i) + h / 2 * a);
    }
    evaluate(forces, state.position, predicted_);
    for (int i = 0; i < count(); ++i) move(state.velocity, i, h / 2, acceleration(forces, i));
  }
  [[nodiscard]] std::unique_ptr<Integrator> clone() const override {
    return std::make_unique<KeepsAStaleAcceleration>(*this);
  }

 private:
  VectorField<double> predicted_;
  bool begun_ = false;
};

/// Symplectic Euler that uses the velocity before it is updated: explicit Euler under a better name.
class UsesTheOldVelocity final : public Wrong {
 public:
  explicit UsesTheOldVelocity(const Sheet& sheet) : Wrong(sheet) {}
  void step(Forces<double>& forces, State<double>& state, double /*t*/, double h) override {
    evaluate(forces, state.position, state.velocity);
    for (int i = 0; i < count(); ++i) {
      move(state.position, i, h, state.velocity.get(i));
      move(state.velocity, i, h, acceleration(forces, i));
    }
  }
  [[nodiscard]] std::unique_ptr<Integrator> clone() const override {
    return std::make_unique<UsesTheOldVelocity>(*this);
  }
};

/// A method of the table with a wrong one in its place.
template <class Impostor>
Method insteadOf(std::string_view name) {
  Method method = findMethod(name);
  method.makeFloat = nullptr;
  method.makeDouble = [](const Scene&, const Sheet& sheet) -> std::unique_ptr<Integrator<double>> {
    return std::make_unique<Impostor>(sheet);
  };
  return method;
}

constexpr double kSeen = 1e-4;       // m: far above rounding
constexpr double kRounding = 1e-11;  // m

TEST(WrongMethods, ThatUpdateInPlaceDoNotKeepTheMirror) {
  EXPECT_LE(mirrorError(findMethod("symplectic-euler")), kRounding);
  EXPECT_GT(mirrorError(insteadOf<UpdatesInPlace>("symplectic-euler")), kSeen);
}

TEST(WrongMethods, WhoseStagesReadAnUnmovedStateHaveTheFirstOrderOnly) {
  const Scene scene = softSheet(Damping::Relative);
  EXPECT_NEAR(observedOrder(scene, findMethod("rk4")), 4, 0.2);
  EXPECT_NEAR(observedOrder(scene, insteadOf<ForgetsToMoveStages>("rk4")), 1, 0.2);
}

TEST(WrongMethods, ThatKeepAStaleAccelerationAreFoundByAPush) {
  Scene scene = softSheet(Damping::Relative);
  scene.dt = 1.0 / 256;
  EXPECT_TRUE(stepsAfreshAfterAPush(scene, findMethod("leapfrog")));
  EXPECT_FALSE(stepsAfreshAfterAPush(scene, insteadOf<KeepsAStaleAcceleration>("leapfrog")));
}

TEST(WrongMethods, ThatKeepAStaleAccelerationAreRightBetweenPushes) {
  const Scene scene = softSheet(Damping::Relative);
  EXPECT_NEAR(observedOrder(scene, insteadOf<KeepsAStaleAcceleration>("leapfrog")), 2, 0.2);
}

TEST(WrongMethods, ThatUseTheOldVelocityGainEnergy) {
  constexpr double kWobble = 0.01;  // of the scale: what symplectic Euler's energy does at this step
  EXPECT_LT(undampedDrift(findMethod("symplectic-euler")), kWobble);
  EXPECT_GT(undampedDrift(insteadOf<UsesTheOldVelocity>("symplectic-euler")), 3 * kWobble);
}

TEST(WrongMethods, DoNotHoldAtTheStepsOfTheRightOnes) {
  Scene scene = oscillator(100, 0);
  scene.displacements = {{{"top-right"}, {0.2, 0, 0}}};
  const auto statusAt = [&](const Method& method, double share) {
    scene.dt = share * method.stableStep(scene.structural.ks, 0);
    Simulation simulation(scene, method);
    simulation.advanceTo(300 * scene.dt);
    return simulation.status();
  };
  constexpr double kSmall = 0.1;  // symplectic Euler's energy wobbles by h w / 2 of itself
  EXPECT_EQ(statusAt(findMethod("symplectic-euler"), kSmall), Status::Ok);
  EXPECT_EQ(statusAt(findMethod("rk4"), 0.95), Status::Ok);
  EXPECT_NE(statusAt(insteadOf<UsesTheOldVelocity>("symplectic-euler"), kSmall), Status::Ok);
  EXPECT_NE(statusAt(insteadOf<ForgetsToMoveStages>("rk4"), 0.95), Status::Ok);
}

}  // namespace
}  // namespace tyg::test
