// The step limits of finite sheets, the bound for any deformation, and what is said about them.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/spectrum/rest_spectrum.h"
#include "scaled_scene.h"
#include "study/limits/stability.h"
#include "test_systems.h"
#include "tyg/methods.h"
#include "tyg/simulation.h"

namespace tyg::test {
namespace {

constexpr double kExact = 1e-6;  // relative; searches and iterations stop there

Scene randomCloth(Numbers& numbers, double mostDamping) {
  Scene scene = emptyWorld(int(numbers.between(2, 8)), int(numbers.between(2, 8)));
  scene.start = numbers.coin() ? Start::Flat : Start::Hanging;
  scene.damping = numbers.coin() ? Damping::Relative : Damping::Axial;
  scene.structural = {numbers.between(100, 1000), numbers.between(0, mostDamping)};
  scene.shear = {numbers.between(10, 1000), numbers.between(0, mostDamping)};
  scene.bend = {numbers.between(10, 500), numbers.between(0, mostDamping)};
  scene.pins = {{"top-left"}};
  return scene;
}

TEST(StepLimit, OfOneOscillatorIsItsClosedForm) {
  const double w2 = 100, d = 3;
  const Scene scene = oscillator(w2, d);  // its lattice, a chain, allows about half as much
  const auto predicted = [&](const char* name) {
    return stepLimit(scene, findMethod(name)).predicted / StepLimit::kBelowMeeting;
  };
  EXPECT_NEAR(stepLimit(scene, findMethod("explicit-euler")).predicted, d / w2, kExact * d);
  const double h = predicted("symplectic-euler"), g = predicted("leapfrog");
  EXPECT_NEAR(h * h * w2 + 2 * h * d, 4, 4 * kExact);
  EXPECT_NEAR(g * g * w2 + 4 * g * d, 4, 4 * kExact);
  EXPECT_NEAR(predicted("imex"), 2 / std::sqrt(w2), kExact);
  EXPECT_NEAR(predicted("rk4"), findMethod("rk4").stableStep(w2, d), kExact);
}

TEST(StepLimit, OfAFiniteSheetLiesAtOrAboveTheLatticesWhichEdgesAndPinsOnlyLoosen) {
  Numbers numbers(3);
  for (int draw = 0; draw < 10; ++draw) {
    const Scene scene = randomCloth(numbers, 1);
    for (const char* name : {"symplectic-euler", "leapfrog", "report-rk4"}) {
      const Method& method = findMethod(name);
      const StepLimit limit = stepLimit(scene, method);
      EXPECT_GE(limit.predicted, (1 - kExact) * unboundedLimit(scene, method)) << name << " " << draw;
      EXPECT_LE(limit.certified, (1 + kExact) * unboundedLimit(scene, method)) << name << " " << draw;
      EXPECT_GT(limit.certified, 0.5 * limit.predicted / (scene.columns < 3 ? 2 : 1)) << name << " " << draw;
    }
  }
}

TEST(StepLimit, IsTheSameNumberForEverybodyWhateverTheSizeOfTheSheet) {
  const Method& method = findMethod("leapfrog");
  const Scene large = withSheet(loadScene("curtain"), 65, 65), nearly = withSheet(large, 16, 16);
  EXPECT_DOUBLE_EQ(restLatticeLimit(large, method), unboundedLimit(large, method));
  EXPECT_NEAR(restLatticeLimit(nearly, method) / unboundedLimit(nearly, method), 1, 4e-3);
  EXPECT_GT(restLatticeLimit(loadScene("spring"), method), 2 * unboundedLimit(loadScene("spring"), method));
  for (const Scene& scene : {large, nearly, loadScene("spring"), loadScene("curtain")}) {
    EXPECT_EQ(stepLimit(scene, method).predicted, restLatticeLimit(scene, method));
  }
}

/// The smallest limit of all roots of the sheet, each taken as a mode of its own, as a Runge-Kutta method sees them.
double exactLimit(const std::vector<std::complex<double>>& roots, const Method& method) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const std::complex<double>& mu : roots) {
    const double size = std::abs(mu), loss = std::max(0.0, -mu.real());
    if (size < 1e-3) continue;  // rigid motions, where the fastest have hundreds
    const bool turns = std::abs(mu.imag()) > 1e-9 * size;
    smallest = std::min(smallest, turns ? method.stableStep(size * size, 2 * loss) : method.stableStep(0, loss));
  }
  return smallest;
}

TEST(StepLimit, UnderTheAxialLawIsWithinFourPercentOfTheExactOne) {
  constexpr double kBelow = 0.04;
  Numbers numbers(29);
  for (int draw = 0; draw < 2; ++draw) {
    Scene scene = randomCloth(numbers, 8);
    scene.damping = Damping::Axial;
    scene.columns = 13, scene.rows = 12;
    const std::vector<std::complex<double>> roots = RestSpectrum(scene).roots();
    for (const char* name : {"rk4", "bs32", "dopri54"}) {
      const Method& method = findMethod(name);
      const double exact = exactLimit(roots, method), unbounded = unboundedLimit(scene, method);
      EXPECT_NEAR(restLatticeLimit(scene, method) / exact, 1, StepLimit::kBelowMeeting * kBelow) << name << " " << draw;
      EXPECT_LE(restLatticeLimit(scene, method), (1 + kExact) * exact) << name << " " << draw;
      EXPECT_NEAR(unbounded / exact, 1, kBelow) << name << " " << draw;
    }
  }
}

/// Its pins leave the sheet slow motions beside fast ones, whose roots are easily lost in rounding.
TEST(StepLimit, OfASmallSheetIsTheSameInAnyUnitOfTime) {
  Scene scene = loadScene("curtain");
  scene.columns = scene.rows = 8;
  for (const char* name : {"explicit-euler", "rk4", "bs32", "dopri54", "rkc2"}) {
    const Method& method = findMethod(name);
    const double expected = restLatticeLimit(scene, method);
    for (const double time : {1e-6, 1e6}) {
      const double found = restLatticeLimit(scaled(scene, {.time = time}), method) / time;
      EXPECT_NEAR(found / expected, 1, kExact) << name << " " << time;
    }
  }
}

TEST(StepLimit, OfALongNarrowSheetIsThatOfAShorterOne) {
  Scene strip = loadScene("curtain");
  strip.columns = 2, strip.rows = 60;
  Scene longer = strip;
  longer.rows = 3000;
  for (const char* name : {"leapfrog", "rk4"}) {
    const Method& method = findMethod(name);
    EXPECT_NEAR(restLatticeLimit(longer, method) / restLatticeLimit(strip, method), 1, 4e-3) << name;
    EXPECT_GT(restLatticeLimit(longer, method), 1.05 * unboundedLimit(longer, method)) << name;
  }
}

TEST(RestSpectrum, FindsTheSameFastestMotionByIterationAndByAllRoots) {
  Numbers numbers(5);
  for (int draw = 0; draw < 5; ++draw) {
    const RestSpectrum spectrum(randomCloth(numbers, 0));
    double fastest = 0;
    for (const std::complex<double>& mu : spectrum.roots()) fastest = std::max(fastest, std::abs(mu));
    EXPECT_NEAR(spectrum.farthest({1, 0}).w2 / (fastest * fastest), 1, kExact) << draw;
  }
}

TEST(RestSpectrum, OfASheetThatIsPinnedEverywhereIsEmpty) {
  Scene scene = oscillator(100, 1);
  scene.pins = {{"top-left"}, {"top-right"}};
  const RestSpectrum spectrum(scene);
  EXPECT_TRUE(spectrum.roots().empty());
  EXPECT_EQ(spectrum.farthest({1, 0}).w2, 0);
  EXPECT_EQ(spectrum.mostDampedOutOfPlane().d, 0);
}

TEST(CertifiedLimit, IsAtMostTheLiveOneHoweverFarTheSheetIsStretched) {
  Numbers numbers(11);
  for (int draw = 0; draw < 6; ++draw) {
    Scene scene = randomCloth(numbers, 2);
    const Sheet sheet = makeSheet(scene);
    const double stretch = numbers.between(0.2, 4);
    for (int i = 0; i < sheet.count(); ++i) {
      const Place place{"", i % scene.columns, i / scene.columns};
      scene.displacements.push_back({place, stretch * sheet.startPosition(i) + numbers.inCube(0.2)});
    }
    for (const Method& method : methods()) {
      const double certified = certifiedLimit(scene, method);
      if (std::isnan(certified) || (method.name == "imex" && scene.damping == Damping::Axial)) continue;
      Simulation simulation(scene, method);
      double live = 0;
      for (int call = 0; call < 20; ++call) live = simulation.liveStableStep();
      EXPECT_LE(certified, live) << method.name << " " << draw;
    }
  }
}

TEST(CertifiedLimit, IsNothingForExplicitEulerAndUnknownForMethodsOfTheWholeSpectrum) {
  const Scene scene = loadScene("curtain");
  EXPECT_EQ(certifiedLimit(scene, findMethod("explicit-euler")), 0);
  EXPECT_TRUE(std::isnan(certifiedLimit(scene, findMethod("rkc2"))));
  EXPECT_TRUE(std::isnan(certifiedLimit(freeFall(), findMethod("rk4"))));
}

/// Light and soft: a wind stretches its cells to many times their area.
Scene softInWind() {
  Scene scene = emptyWorld(6, 5);
  scene.spacing = 0.1, scene.particleMass = 0.00002;
  scene.start = Start::Flat;
  scene.pins = {{"top-left"}, {"top-right"}};
  scene.gravity = {0, -9.81, 0};
  scene.structural.ks = 0.7, scene.shear.ks = 0.5;
  scene.air = {.density = 1.2};
  scene.winds = {{.velocity = {0, 10, 0}}};
  scene.duration = 1;
  scene.tolerance = 0;
  return scene;
}

TEST(CertifiedLimit, DoesNotExistWhereAirActsOnCells) {
  const Scene scene = softInWind();
  for (const Method& method : methods()) EXPECT_TRUE(std::isnan(certifiedLimit(scene, method))) << method.name;
  const Method& rk4 = findMethod("rk4");
  Scene vacuum = scene;
  vacuum.air = {}, vacuum.winds.clear();
  Scene stretched = scene;
  stretched.dt = 0.0003;
  EXPECT_GT(certifiedLimit(vacuum, rk4), stretched.dt);
  Simulation simulation(stretched, rk4);
  simulation.advanceTo(scene.duration);
  EXPECT_NE(simulation.status(), Status::Ok) << "the wind stretches no cell, so that this scene shows nothing";
}

TEST(CertifiedLimit, ExistsForAChainInAirWhichHasNoCells) {
  Scene scene = softInWind();
  scene.columns = 1;
  scene.pins = {{"top-left"}};
  EXPECT_GT(certifiedLimit(scene, findMethod("rk4")), 0);
}

TEST(FirstMode, OfTheCurtainIsStripesInThePlaneSetByStiffness) {
  const Scene scene = loadScene("curtain");
  const std::string words = describe(scene, stepLimit(scene, findMethod("rk4")));
  EXPECT_EQ(words, "stripes in plane, q = (3.14, 0.00), set by stiffness");
}

TEST(FirstMode, OfStrongStructuralDampingIsTheCheckerboardOutOfPlane) {
  Scene scene = emptyWorld(20, 20);
  scene.structural = {1, 10};
  const StepLimit limit = stepLimit(scene, findMethod("rk4"));
  EXPECT_EQ(appearanceOf(scene, limit), "checkerboard");
  EXPECT_TRUE(limit.outOfPlane);
  EXPECT_TRUE(limit.byDamping);
}

TEST(FirstMode, NamesTheTermThatDoesMostOfTheDampingWhereThatIsNotTheSprings) {
  Scene scene = emptyWorld(8, 8);
  scene.spacing = 0.1, scene.particleMass = 0.01;
  scene.structural = {50, 0.01};
  const auto words = [&](const char* method) { return describe(scene, stepLimit(scene, findMethod(method))); };
  scene.drag = 10;
  EXPECT_EQ(words("leapfrog"), "checkerboard in plane, q = (3.14, 3.14), set by drag, not the springs");
  scene.drag = 0;
  scene.air.density = 100;
  scene.winds = {{.velocity = {0, 30, 0}}};
  EXPECT_EQ(words("leapfrog"), "the whole sheet out of plane, q = (0.00, 0.00), set by air, not the springs");
  EXPECT_EQ(words("rkc2"), "the whole sheet out of plane, q = (0.00, 0.00), set by air, not the springs");
  scene.structural.kd = 50;
  EXPECT_TRUE(words("leapfrog").ends_with("set by damping")) << words("leapfrog");
}

TEST(FirstMode, OfAChainIsEachParticleAgainstTheNext) {
  const Scene scene = hangingChain(20, 0.1, 0.01, {1000, 0});
  EXPECT_EQ(appearanceOf(scene, stepLimit(scene, findMethod("leapfrog"))), "each against the next");
}

TEST(FirstMode, DoesNotExistWhereNothingFailsAndEveryMethodWithoutALimitSaysWhy) {
  for (const Method& method : methods()) {
    EXPECT_EQ(describe(freeFall(), stepLimit(freeFall(), method)), "none") << method.name;
    const bool hasLimit = method.stableStep != nullptr || method.stableStepOfScene != nullptr;
    EXPECT_EQ(method.whyNoLimit.empty(), hasLimit) << method.name;
  }
}

}  // namespace
}  // namespace tyg::test
