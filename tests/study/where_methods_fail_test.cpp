// Where methods fail: on both sides of the predicted limits, over random sheets, and at known places of their stability
// regions. A new method is tested by being in the table.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <complex>
#include <functional>
#include <span>

#include "core/spectrum/rest_spectrum.h"
#include "integrators/chebyshev.h"
#include "random_cloth.h"
#include "study/limits/stability.h"
#include "tyg/methods.h"
#include "tyg/simulation.h"

namespace tyg::test {
namespace {

constexpr double kBelow = 0.95, kAbove = 1.1;  // of the limit

/// A sheet with springs, masses and damping drawn at random, slightly shaken out of rest, and nothing else: the linear
/// regime, in which the predicted limit holds. Every third one is undamped, the others not lightly damped: next to that
/// limit waves grow too slowly for a test.
Scene trembling(unsigned seed) {
  Numbers numbers(seed);
  for (int k = 0; k < 20; ++k) numbers.coin();
  Scene scene = emptyWorld(9 + int(numbers.between(0, 6)), 9 + int(numbers.between(0, 6)));
  scene.name = "sheet " + std::to_string(seed);
  scene.spacing = logBetween(numbers, 0.02, 0.2);
  scene.particleMass = logBetween(numbers, 1e-3, 0.1);
  drawSprings(scene, numbers);
  const double critical = std::sqrt(8 * scene.structural.ks * scene.particleMass) / 8;
  const double kd = seed % 3 == 0 ? 0 : critical * logBetween(numbers, 0.1, 3);
  for (SpringFamily* family : {&scene.structural, &scene.shear, &scene.bend}) family->kd = family->ks > 0 ? kd : 0;
  scene.tolerance = 0;  // adaptive methods take steps of dt
  for (int k = 0; k < 12; ++k) {
    const Place place{"", int(numbers.between(0, scene.columns - 1)), int(numbers.between(0, scene.rows - 1))};
    scene.displacements.push_back({place, numbers.inCube(1e-3 * scene.spacing)});
  }
  return scene;
}

/// Damping in proportion to stiffness brings all waves to explicit Euler's limit d / w^2 at once, the short ones too,
/// which grow fast. Otherwise the limit may be that of a long wave, which takes longer. See SlowGrowth below.
Scene inProportion(Scene scene) {
  const double seconds = 0.7 / std::sqrt(8 * scene.structural.ks / scene.particleMass);
  for (SpringFamily* family : {&scene.structural, &scene.shear, &scene.bend}) family->kd = seconds * family->ks;
  scene.damping = Damping::Relative;
  return scene;
}

/// Undamped, this leaves the imaginary axis by so little that 1500 steps show nothing of it. See SlowGrowth below.
bool leavesSlowly(const Method& method, const Scene& scene) {
  return scene.structural.kd == 0 && method.name == "dopri54";
}

Status after(Scene scene, const Method& method, double dt, int steps) {
  scene.dt = dt;
  Simulation simulation(scene, method, {.threads = 1});
  simulation.advanceTo(steps * dt);
  return simulation.status();
}

void forLimitedMethods(const std::function<void(const Scene&, const Method&, double limit)>& test) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    for (const Method& method : methods()) {
      const Scene scene = method.name == "explicit-euler" ? inProportion(trembling(seed)) : trembling(seed);
      const double limit = restLatticeLimit(scene, method);
      if (takes(method, scene) && limit > 0) test(scene, method, limit);
    }
  }
}

TEST(WhereMethodsFail, QuietBelowTheLimitOfEveryMethodOverRandomSheets) {
  constexpr int kSteps = 300;
  forLimitedMethods([](const Scene& scene, const Method& method, double limit) {
    EXPECT_EQ(after(scene, method, kBelow * limit, kSteps), Status::Ok) << method.name << " " << scene.name;
  });
}

TEST(WhereMethodsFail, AlarmedAboveTheLimitOfEveryMethodOverRandomSheets) {
  constexpr int kSteps = 1500;
  forLimitedMethods([](const Scene& scene, const Method& method, double limit) {
    if (leavesSlowly(method, scene)) return;
    EXPECT_NE(after(scene, method, kAbove * limit, kSteps), Status::Ok) << method.name << " " << scene.name;
  });
}

/// The same held at its left edge in a wind at some angle: so strong an air that it damps waves by up to a third of
/// their frequency, and so slow a wind that it hardly bends the sheet.
Scene windy(Scene scene, unsigned seed) {
  Numbers numbers(1000 + seed);
  for (int k = 0; k < 20; ++k) numbers.coin();
  const double frequency = std::sqrt(8 * scene.structural.ks / scene.particleMass);
  const double speed = 3e-3 * frequency * scene.spacing, damping = frequency * logBetween(numbers, 0.03, 0.3);
  const Vec3 way = numbers.inCube(1);
  scene.air = {.density = damping * scene.particleMass / (1.2 * scene.spacing * scene.spacing * speed),
               .coefficient = 1.2};
  scene.winds = {{.velocity = speed / length(way) * way,
                  .gust = numbers.inCube(0.5 * speed),
                  .wavelength = numbers.between(2, 9) * scene.spacing}};
  scene.pins = {{"left"}};
  return scene;
}

TEST(WhereMethodsFail, QuietBelowAndAlarmedAboveTheLimitOfEveryMethodOverRandomSheetsInWind) {
  constexpr int kSteps = 300, kMoreSteps = 1500;
  forLimitedMethods([&, seed = 0U](const Scene& scene, const Method& method, double /*limit*/) mutable {
    const Scene inWind = windy(scene, ++seed);
    if (!takes(method, inWind)) return;
    const double limit = restLatticeLimit(inWind, method);
    ASSERT_GT(limit, 0) << method.name << " " << scene.name;
    EXPECT_EQ(after(inWind, method, kBelow * limit, kSteps), Status::Ok) << method.name << " " << scene.name;
    if (leavesSlowly(method, inWind)) return;
    EXPECT_NE(after(inWind, method, kAbove * limit, kMoreSteps), Status::Ok) << method.name << " " << scene.name;
  });
}

/// A small sheet moved within its plane only, where nothing buckles however long the run.
Scene inItsPlane(unsigned seed) {
  Scene scene = trembling(seed);
  scene.columns = scene.rows = 6;
  scene.displacements.clear();
  Numbers numbers(seed);
  for (int k = 0; k < scene.columns * scene.rows; ++k) {
    Vec3 by = numbers.inCube(3e-3 * scene.spacing);
    by.z = 0;
    scene.displacements.push_back({{"", k % scene.columns, k / scene.columns}, by});
  }
  return scene;
}

/// Steps until the fastest growing motion of the sheet is a thousand times larger, by the growth |R(h mu)| of its root.
int stepsToSeeGrowth(const Scene& scene, double h, std::span<const double> polynomial) {
  double fastest = 0;
  for (const std::complex<double>& mu : RestSpectrum(scene).roots()) {
    std::complex<double> sum = 0;
    for (std::size_t k = polynomial.size(); k-- > 0;) sum = sum * h * mu + polynomial[k];
    constexpr double kRigid = 1e-5;  // of a step: rigid motions do not move but for rounding
    if (std::abs(h * mu) > kRigid) fastest = std::max(fastest, std::log(std::abs(sum)));
  }
  return int(std::min(2e6, std::ceil(std::log(1000.0) / fastest)));
}

TEST(SlowGrowth, OfExplicitEulerPastItsLimitIsSeenAsSoonAsItsRootsSay) {
  constexpr std::array kGrowth = {1.0, 1.0};
  const Method& euler = findMethod("explicit-euler");
  for (const unsigned seed : {1U, 2U, 4U, 5U, 7U, 8U}) {
    const Scene scene = inItsPlane(seed);
    const double limit = stepLimit(scene, euler).predicted;
    const int steps = stepsToSeeGrowth(scene, kAbove * limit, kGrowth);
    EXPECT_NE(after(scene, euler, kAbove * limit, steps), Status::Ok) << scene.name << " " << steps;
    EXPECT_EQ(after(scene, euler, kBelow * limit, steps), Status::Ok) << scene.name << " " << steps;
  }
}

TEST(SlowGrowth, OfUndampedDopri54PastItsLimitIsSeenAsSoonAsItsRootsSay) {
  constexpr std::array kGrowth = {1.0, 1.0, 1.0 / 2, 1.0 / 6, 1.0 / 24, 1.0 / 120, 1.0 / 600};
  const Scene scene = inItsPlane(3);
  const Method& dopri54 = findMethod("dopri54");
  const double limit = stepLimit(scene, dopri54).predicted;
  const int steps = stepsToSeeGrowth(scene, kAbove * limit, kGrowth);
  EXPECT_GT(steps, 50'000);
  EXPECT_NE(after(scene, dopri54, kAbove * limit, steps), Status::Ok) << steps;
}

/// A small sheet of which families may miss, with or without damping of their own: there is the least damping for a
/// stiffness where it ends.
Scene patchy(unsigned seed) {
  Numbers numbers(seed);
  for (int k = 0; k < 20; ++k) numbers.coin();
  Scene scene = emptyWorld(int(numbers.between(1, 6)), int(numbers.between(2, 6)));
  drawSprings(scene, numbers);
  if (numbers.coin()) scene.drag = numbers.between(0.01, 3);
  if (numbers.coin()) scene.shear.ks = 0;
  if (numbers.coin()) scene.shear.kd = 0;
  if (numbers.coin()) scene.bend.kd = 0;
  if (numbers.coin()) scene.pins = {{"top-left"}};
  return scene;
}

TEST(WhereMethodsFail, TheStagesThatRkc2ChoosesHoldTheWavesAtTheEdgesOfASheetToo) {
  constexpr double kRounding = 1e-6, kRigid = 1e-5;  // of the fastest root: rigid motions are found to creep
  for (const unsigned seed : {1U, 38U, 147U}) {      // which grow with the stages that the unbounded lattice asks for
    const Scene scene = patchy(seed);
    const double limit = restLatticeLimit(scene, findMethod("rkc2"));
    const std::vector<Mode> modes = chebyshevModes(scene, false);
    const std::vector<std::complex<double>> roots = RestSpectrum(scene).roots();
    double fastest = 0, most = 0;
    for (const std::complex<double>& mu : roots) fastest = std::max(fastest, std::abs(mu));
    for (double h = 0.99 * limit; h > 0.1 * limit; h *= 0.7) {
      const ChebyshevStages stages = chebyshevStages(modes, h);
      ASSERT_GT(stages.count, 0) << seed << " at " << h / limit;
      for (const std::complex<double>& mu : roots) {
        if (std::abs(mu) > kRigid * fastest) most = std::max(most, std::abs(chebyshevGrowth(stages, h * mu)));
      }
    }
    EXPECT_LE(most, 1 + kRounding) << seed;
  }
}

TEST(WhereMethodsFail, ExplicitEulerAndRkc2AlwaysDoWithoutDamping) {
  const Method &euler = findMethod("explicit-euler"), &rkc2 = findMethod("rkc2");
  for (unsigned seed = 1; seed <= 9; ++seed) {
    Scene scene = trembling(seed);
    scene.structural.kd = scene.shear.kd = scene.bend.kd = 0;
    EXPECT_EQ(restLatticeLimit(scene, euler), 0);
    EXPECT_EQ(restLatticeLimit(scene, rkc2), 0);
    const double reach = restLatticeLimit(scene, findMethod("leapfrog"));
    // Explicit Euler makes a wave grow by 1 + (h w)^2 / 2 a step, two stages by 1 + (h w)^4 / 8; h w = 2 share for the
    // fastest one.
    for (const double share : {0.5, 0.05}) {
      const int steps = int(40 / (2 * share * share));
      EXPECT_NE(after(scene, euler, share * reach, steps), Status::Ok) << scene.name << " " << share;
    }
    for (const double share : {0.5, 0.25}) {
      const int steps = int(20 / (2 * std::pow(share, 4)));
      EXPECT_NE(after(scene, rkc2, share * reach, steps), Status::Ok) << scene.name << " " << share;
    }
  }
}

/// How much a step changes the oscillator's state on average over many, by its energy norm.
double growth(const Scene& scene, const Method& method, double h, int steps) {
  Bench<double> bench(scene);
  const double stiffness = std::max(scene.structural.ks, 1e-300);
  const auto size = [&] {
    const double x = bench.state.position.get(1).x - bench.sheet.startPosition(1).x;
    const double v = bench.state.velocity.get(1).x;
    return std::sqrt(stiffness * x * x + scene.particleMass * v * v);
  };
  bench.state.velocity.set(1, {1e-3, 0, 0});
  const double before = size();
  bench.advance(method, steps * h, steps);
  return std::pow(size() / before, 1.0 / steps);
}

TEST(WhereMethodsFail, Rk4ReachesItsPlaceOnTheImaginaryAxis) {
  const Scene scene = oscillator(100, 0);
  const double unit = 2.8284 / std::sqrt(100.0);
  EXPECT_LT(growth(scene, findMethod("rk4"), 0.9995 * unit, 2000), 1);
  EXPECT_GT(growth(scene, findMethod("rk4"), 1.0005 * unit, 2000), 1);
}

TEST(WhereMethodsFail, Rk4ReachesItsPlaceOnTheRealAxis) {
  const Scene scene = oscillator(0, 5);
  const double unit = 2.7853 / 5;
  EXPECT_LT(growth(scene, findMethod("rk4"), 0.9995 * unit, 2000), 1);
  EXPECT_GT(growth(scene, findMethod("rk4"), 1.0005 * unit, 2000), 1);
}

TEST(WhereMethodsFail, DampingShrinksTheLimitOfLeapfrog) {
  const Method& leapfrog = findMethod("leapfrog");
  constexpr double kWobble = 2e-3;  // what a bounded change of the energy next to the limit looks like per step
  double previous = 2 / std::sqrt(100.0) * (1 + 1e-12);
  for (const double kd : {0.0, 1.0, 5.0, 20.0}) {
    const double limit = leapfrog.stableStep(100, kd);
    EXPECT_LT(limit, previous) << kd;
    EXPECT_LE(growth(oscillator(100, kd), leapfrog, 0.99 * limit, 1000), 1 + kWobble) << kd;
    EXPECT_GT(growth(oscillator(100, kd), leapfrog, 1.01 * limit, 1000), 1 + 2 * kWobble) << kd;
    previous = limit;
  }
}

/// An undamped sheet held at its rim, 58 % longer both ways than at rest.
Bench<double> stretched() {
  Scene scene = emptyWorld(14, 14);
  scene.structural.ks = 1200, scene.shear.ks = 900, scene.bend.ks = 200;
  scene.particleMass = 0.018;
  for (int k = 0; k < 14; ++k) {
    for (const auto& [column, row] : {std::pair{k, 0}, {k, 13}, {0, k}, {13, k}})
      scene.pins.push_back({"", column, row});
  }
  return Bench<double>(scene);
}

/// What the energy of the stretched sheet, slightly shaken, has gained after some steps, as a fraction of itself.
double unrest(const Method& method, double h) {
  Bench<double> bench = stretched();
  Numbers numbers(7);
  for (int i = 0; i < bench.sheet.count(); ++i) {
    bench.state.position.set(i, 1.58 * bench.sheet.startPosition(i));
  }
  for (const int row : {5, 6, 7}) {
    for (int column = 3; column < 11; ++column) {
      const int i = row * 14 + column;
      bench.state.position.set(i, bench.state.position.get(i) + numbers.inCube(1e-3));
    }
  }
  const double before = bench.forces.energy(0, bench.state).of<StructuralSprings>();
  bench.advance(method, 3000 * h, 3000);
  const StoredEnergy now = bench.forces.energy(0, bench.state);
  return (now.kinetic + now.of<StructuralSprings>() - before) / before;
}

TEST(WhereMethodsFail, TheLimitAtRestIsUnsafeInAStretchedSheetAndTheCertifiedOneIsNot) {
  const Scene scene = stretched().scene;
  for (const std::string_view name : {"leapfrog", "symplectic-euler", "rk4"}) {
    const Method& method = findMethod(name);
    const double rest = restLatticeLimit(scene, method), certified = certifiedLimit(scene, method);
    EXPECT_LT(certified, kBelow * rest);
    const double far = unrest(method, kBelow * rest);
    EXPECT_TRUE(!(far < 1)) << name << " " << far;
    EXPECT_LT(unrest(method, 0.999 * certified), 1e-3) << name;
  }
}

TEST(WhereMethodsFail, ReportRk4IsSymplecticEulerWithALongerStep) {
  const Scene scene = softSheet(Damping::Relative);
  for (const double h : {1e-3, 0.05}) {
    Bench<double> report(scene), euler(scene);
    Numbers numbers(3);
    shake(report, 0.1, numbers);
    euler.state = report.state;
    report.advance(findMethod("report-rk4"), 200 * h, 200);
    const double longer = h * (1 + h / 2 + h * h / 6 + h * h * h / 24);
    euler.advance(findMethod("symplectic-euler"), 200 * longer, 200);
    EXPECT_LE(distance(report.points(), euler.points()), 1e-12 * scene.spacing) << h;
  }
}

}  // namespace
}  // namespace tyg::test
