// One particle and one spring, in two layers: tight against the recurrence that the scheme is by definition, loose
// against the exact solution.
#include <gtest/gtest.h>

#include <array>

#include "core/simulation/integrator.h"
#include "test_systems.h"
#include "tyg/methods.h"

namespace tyg::test {
namespace {

constexpr double kGravity = -9.81;
constexpr double kRounding = 1e-12;  // relative: hundreds of steps of a few roundings each

/// The report's own step, which it believed to be a Runge-Kutta step: h (1 + h/2 + h^2/6 + h^3/24).
double reportStep(double h) { return h * (1 + h / 2 + h * h / 6 + h * h * h / 24); }

/// Height after n steps of h from rest at 0.
double fallenBy(const Method& method, double h, int n) {
  const double steps = n;
  if (method.name == "explicit-euler") return kGravity * h * h * steps * (steps - 1) / 2;
  if (method.name == "report-rk4") h = reportStep(h);
  if (method.order == 1) return kGravity * h * h * steps * (steps + 1) / 2;
  return kGravity * h * h * steps * steps / 2;  // second order and above: the parabola itself
}

TEST(FreeFall, OfEveryMethodFollowsItsRecurrence) {
  constexpr double kStep = 0.01;
  constexpr int kSteps = 300;
  for (const Method& method : methods()) {
    Bench<double> bench(freeFall());
    bench.advance(method, kStep * kSteps, kSteps);
    const double expected = fallenBy(method, kStep, kSteps);
    EXPECT_NEAR(bench.points().x[0].y, expected, kRounding * std::abs(expected)) << method.name;
    EXPECT_EQ(bench.points().x[0].x, 0);
    EXPECT_EQ(bench.points().x[0].z, 0);
  }
}

/// Ten thousand short steps: what a method takes from rounded positions instead of from forces shows here.
TEST(FreeFall, InFloatWithShortStepsHasItsSpeed) {
  constexpr double kShort = 1e-4, kFloat = 2e-3;  // relative: each step rounds the speed by half an eps
  constexpr int kSteps = 10000;
  for (const Method& method : methods()) {
    Scene scene = emptyWorld(2, 1);  // with a spring that nothing stretches
    scene.gravity = {0, kGravity, 0};
    scene.structural = {1200, 0.1};
    Bench<float> bench(scene);
    bench.advance(method, kShort * kSteps, kSteps);
    EXPECT_NEAR(bench.points().v[1].y, kGravity, kFloat * -kGravity) << method.name;
    EXPECT_NEAR(bench.points().x[1].y, kGravity / 2, 2 * kFloat * -kGravity) << method.name;
  }
}

TEST(FreeFall, WithDragEndsAtTheSpeedWhereDragCarriesTheWeight) {
  constexpr double kStep = 0.01, kDrag = 2;
  for (const Method& method : methods()) {
    Scene scene = freeFall();
    scene.drag = kDrag;
    Bench<double> bench(scene);
    bench.advance(method, 30, int(30 / kStep));
    EXPECT_NEAR(bench.points().v[0].y, kGravity / kDrag, 1e-9) << method.name;
  }
}

// ---- one spring: x'' = -d x' - w2 x ------------------------------------------------------------------------------

constexpr double kStiffness = 25, kDamping = 1.5;  // of a particle of 1 kg: w2 and d
constexpr double kStart = 0.3;                     // m beyond the rest length

struct Motion {
  double x, v;
};

Motion exact(double d, double t) {
  const double decay = d / 2, frequency = std::sqrt(kStiffness - decay * decay);
  const double envelope = kStart * std::exp(-decay * t), angle = frequency * t;
  return {envelope * (std::cos(angle) + decay / frequency * std::sin(angle)),
          -envelope * kStiffness / frequency * std::sin(angle)};
}

Motion simulated(const Method& method, double d, double seconds, int steps) {
  Bench<double> bench(oscillator(kStiffness, d));
  const Vec3 rest = bench.state.position.get(1);
  bench.state.position.set(1, rest + Vec3{kStart, 0, 0});
  bench.advance(method, seconds, steps);
  const Points at = bench.points();
  EXPECT_EQ(at.x[0], bench.sheet.startPosition(0)) << "the pinned end";
  EXPECT_EQ(at.x[1].y, 0);
  EXPECT_EQ(at.x[1].z, 0);
  return {at.x[1].x - rest.x, at.v[1].x};
}

TEST(OneSpring, OfEveryMethodIsNearTheExactMotion) {
  constexpr int kStepsPerSecond = 400;
  const double h = 1.0 / kStepsPerSecond, frequency = std::sqrt(kStiffness);
  for (const double d : {0.0, kDamping}) {
    for (const Method& method : methods()) {
      const Motion found = simulated(method, d, 2, 2 * kStepsPerSecond), expected = exact(d, 2);
      const double allowed = kStart * 20 * std::pow(frequency * h, method.order);  // 10 radians, a few error constants
      EXPECT_NEAR(found.x, expected.x, allowed) << method.name << " d " << d;
      EXPECT_NEAR(found.v, expected.v, allowed * frequency) << method.name << " d " << d;
    }
  }
}

/// One step of a scheme on the linear problem, as the scheme's definition has it.
Motion schemeStep(const Method& method, Motion at, double h, double d) {
  const auto a = [&](double x, double v) { return -kStiffness * x - d * v; };
  if (method.name == "report-rk4") h = reportStep(h);
  if (method.name == "explicit-euler") return {at.x + h * at.v, at.v + h * a(at.x, at.v)};
  if (method.name == "imex") {
    const double y = at.x + h / 2 * at.v;
    const double v = ((1 - h / 2 * d) * at.v - h * kStiffness * y) / (1 + h / 2 * d);
    return {y + h / 2 * v, v};
  }
  if (method.name == "backward-euler") {
    const double v = (at.v - h * kStiffness * at.x) / (1 + h * d + h * h * kStiffness);
    return {at.x + h * v, v};
  }
  if (method.name == "xpbd") {
    const double v = at.v / (1 + h * d), x = at.x + h * v;
    const double correction = -x * (h * h * kStiffness) / (1 + h * h * kStiffness);
    return {x + correction, v + correction / h};
  }
  const double v = at.v + h * a(at.x, at.v);
  return {at.x + h * v, v};
}

TEST(OneSpring, OfLowOrderMethodsFollowsTheirRecurrence) {
  constexpr double kStep = 0.01;
  constexpr int kSteps = 200;
  for (const std::string_view name :
       {"explicit-euler", "symplectic-euler", "report-rk4", "imex", "backward-euler", "xpbd"}) {
    const Method& method = findMethod(name);
    Motion expected{kStart, 0};
    for (int n = 0; n < kSteps; ++n) expected = schemeStep(method, expected, kStep, kDamping);
    const Motion found = simulated(method, kDamping, kStep * kSteps, kSteps);
    EXPECT_NEAR(found.x, expected.x, kRounding) << name;
    EXPECT_NEAR(found.v, expected.v, kRounding) << name;
  }
}

TEST(OneSpring, OfLeapfrogFollowsItsRecurrence) {
  constexpr double kStep = 0.01;
  constexpr int kSteps = 200;
  const auto force = [](double x, double v) { return -kStiffness * x - kDamping * v; };
  Motion expected{kStart, 0};
  double a = force(expected.x, expected.v);
  for (int n = 0; n < kSteps; ++n) {
    const double half = expected.v + kStep / 2 * a;
    expected.x += kStep * half;
    a = force(expected.x, half + kStep / 2 * a);
    expected.v = half + kStep / 2 * a;
  }
  const Motion found = simulated(findMethod("leapfrog"), kDamping, kStep * kSteps, kSteps);
  EXPECT_NEAR(found.x, expected.x, kRounding);
  EXPECT_NEAR(found.v, expected.v, kRounding);
}

TEST(OneSpring, OfRungeKuttaMethodsFollowsTheirStabilityPolynomial) {
  constexpr double kStep = 0.05;
  constexpr int kSteps = 40;
  struct Polynomial {
    std::string_view name;
    std::array<double, 7> coefficients;  // of z^0, z^1, ...
  };
  // Classical; Bogacki and Shampine (1989); Dormand and Prince (1980), whose sixth coefficient is 1/600.
  const Polynomial polynomials[] = {{"rk4", {1, 1, 1.0 / 2, 1.0 / 6, 1.0 / 24}},
                                    {"bs32", {1, 1, 1.0 / 2, 1.0 / 6}},
                                    {"dopri54", {1, 1, 1.0 / 2, 1.0 / 6, 1.0 / 24, 1.0 / 120, 1.0 / 600}}};
  for (const Polynomial& polynomial : polynomials) {
    Motion at{kStart, 0};
    for (int n = 0; n < kSteps; ++n) {
      Motion power = at, sum{0, 0};
      for (const double coefficient : polynomial.coefficients) {
        sum = {sum.x + coefficient * power.x, sum.v + coefficient * power.v};
        power = {kStep * power.v, kStep * (-kStiffness * power.x - kDamping * power.v)};  // times h A
      }
      at = sum;
    }
    const Motion found = simulated(findMethod(polynomial.name), kDamping, kStep * kSteps, kSteps);
    EXPECT_NEAR(found.x, at.x, kRounding) << polynomial.name;
    EXPECT_NEAR(found.v, at.v, kRounding) << polynomial.name;
  }
}

TEST(OneSpring, BetweenTwoFreeParticlesSwingsWithTheReducedMass) {
  Scene scene = oscillator(kStiffness, 0);
  scene.pins.clear();
  Bench<double> bench(scene);
  bench.state.position.set(0, bench.state.position.get(0) - Vec3{kStart, 0, 0});
  const double middle = (bench.points().x[0].x + bench.points().x[1].x) / 2;
  const double halfPeriod = std::acos(-1.0) / std::sqrt(2 * kStiffness);
  bench.advance(findMethod("rk4"), halfPeriod, 1000);
  const Points at = bench.points();
  EXPECT_NEAR(at.x[1].x - at.x[0].x, 1 - kStart, 1e-10);  // rk4 at a thousand steps a half period
  EXPECT_NEAR((at.x[0].x + at.x[1].x) / 2, middle, kRounding);
}

TEST(OneSpring, CarriesTheWholeWeightHoweverStronglyItIsDamped) {
  constexpr double kMass = 0.1, kWeak = 10, kSag = kMass * 9.81 / kWeak, kSettled = 1e-6;  // kg, N/m, m, m
  for (const double kd : {0.1, 0.5}) {
    for (const double h : {0.004, 0.02}) {
      for (const Method& method : methods()) {
        const bool holds = method.stableStep == nullptr || method.stableStep(kWeak / kMass, kd / kMass) > h;
        if (!holds || method.stableStepOfScene != nullptr) continue;
        Bench<double> bench(hangingChain(1, 0.5, kMass, {kWeak, kd}));
        bench.advance(method, 30, int(30 / h));
        EXPECT_NEAR(-0.5 - bench.points().x[1].y, kSag, kSettled) << method.name << " kd " << kd << " h " << h;
      }
    }
  }
}

// ---- the stable step of the test equation ---------------------------------------------------------------------------

constexpr double kSmall = 1e-6;  // m: the spring stays linear while this grows a thousandfold

/// By what factor a small motion has changed after many steps of h; looks away once it has grown a thousandfold.
double growth(const Method& method, double d, double h) {
  constexpr int kSteps = 20000;
  Bench<double> bench(oscillator(kStiffness, d));
  const Vec3 rest = bench.state.position.get(1);
  bench.state.position.set(1, rest + Vec3{kSmall, 0, 0});
  const auto integrator = method.make<double>(bench.scene, bench.sheet);
  double size = 1;
  for (int n = 0; n < kSteps && size < 1000; ++n) {
    integrator->step(bench.forces, bench.state, 0, h);
    size = length(bench.state.position.get(1) - rest) / kSmall;
  }
  return size;
}

TEST(StableStep, OfEveryMethodIsWhereOneSpringBeginsToGrow) {
  constexpr double kBeside = 0.05;  // explicit Euler, the slowest to show, changes by e^-20 or e^20 here
  for (const Method& method : methods()) {
    if (method.stableStep == nullptr) continue;
    for (const double d : {1.0, 4.0, 12.0}) {  // twice underdamped, once overdamped
      const double limit = method.stableStep(kStiffness, d);
      EXPECT_LT(growth(method, d, (1 - kBeside) * limit), 0.01) << method.name << " d " << d << " limit " << limit;
      EXPECT_GE(growth(method, d, (1 + kBeside) * limit), 1000) << method.name << " d " << d << " limit " << limit;
    }
  }
}

}  // namespace
}  // namespace tyg::test
