// What a cut leaves moves as a sheet that never had more: the same bits, the orders of all methods, a balanced ledger.
#include <gtest/gtest.h>

#include <cmath>

#include "core/forces/row_kernel.h"
#include "core/simulation/timetable.h"
#include "method_checks.h"
#include "tyg/methods.h"
#include "tyg/simulation.h"

namespace tyg::test {
namespace {

constexpr double kCutAt = 0.3125;  // s, of timed cuts: a whole number of all steps here
constexpr int kTicksBefore = 20, kTicksAfter = 60;

/// A sheet with air, wind and a ball, wider than a vector.
Scene windySheet(const Method& method) {
  Scene scene = softSheet(Damping::Relative);
  scene.columns = 37, scene.rows = 9, scene.spacing = 0.05;
  scene.pins = {{"top"}};
  scene.dt = 1.0 / 1024, scene.tolerance = 0;  // adaptive methods take steps of dt
  scene.bodies = {{.shape = Shape::Ball, .at = {0, -0.35, -0.19}, .radius = 0.2}};
  fillContact(scene);
  scene.air = {1.2, 1.2}, scene.winds = {{.velocity = {1, 0, -2}}};
  if (!takes(method, scene)) scene.air = {}, scene.winds.clear();
  return scene;
}

/// A state that a simulation has, moved on by a method and by forces that were made for its sheet as it is now.
template <class T>
std::uint64_t movedOn(const Simulation& simulation, const Method& method, int steps) {
  const Scene& scene = simulation.scene();
  const Sheet& sheet = simulation.sheet();
  Workers workers(1);
  Forces<T> forces(scene, sheet, workers);
  forces.act(actingAt(scene, {simulation.time(), 0, 0}));
  State<T> state = startState<T>(sheet);
  for (int i = 0; i < sheet.count(); ++i) {
    state.position.set(i, simulation.position(i)), state.velocity.set(i, simulation.velocity(i));
  }
  const auto integrator = method.make<T>(scene, sheet);
  const double h = simulation.dt();
  for (int k = 0; k < steps; ++k) integrator->steps(forces, state, {0, simulation.ticks() + k, h}, 1);
  return sheet.missing.mixedInto(hashOf(state));
}

TEST(CutAndGoOn, IsAFreshRunWithTheMasksBitForBitInEveryMethod) {
  for (const Method& method : methods()) {
    for (const Precision precision : {Precision::Float, Precision::Double}) {
      Scene scene = windySheet(method);
      scene.precision = precision;
      const int ticks = method.solves ? kTicksAfter / 6 : kTicksAfter;
      Simulation simulation(scene, method, {.threads = 1});
      simulation.tick(kTicksBefore);
      simulation.cut({0.5, 3.3, 29.2, 5.1}), simulation.cut({20.5, 12, 20.5, 4});
      const std::uint64_t fresh = precision == Precision::Float ? movedOn<float>(simulation, method, ticks)
                                                                : movedOn<double>(simulation, method, ticks);
      simulation.tick(ticks);
      EXPECT_EQ(simulation.hash(), fresh) << method.name << " " << int(precision);
    }
  }
}

TEST(CutAndGoOn, GivesTheSameBitsAtEveryVectorLevelWithAnyThreadsAndWithALedger) {
  for (const char* name : {"symplectic-euler", "leapfrog", "rk4", "imex", "xpbd"}) {
    const Method& method = findMethod(name);
    for (const Precision precision : {Precision::Float, Precision::Double}) {
      Scene scene = windySheet(method);
      scene.precision = precision;
      scene.cuts = {{{0.5, 3.3, 29.2, 5.1}, kTicksBefore * scene.dt}};
      const auto hash = [&](int threads, bool ledger) {
        Simulation simulation(scene, method, {.threads = threads, .ledger = ledger});
        simulation.tick(kTicksBefore + kTicksAfter);
        return simulation.hash();
      };
      const std::uint64_t expected = hash(1, false);
      EXPECT_EQ(hash(1, true), expected) << name;
      for (const int threads : {2, 3, 7}) EXPECT_EQ(hash(threads, false), expected) << name << " " << threads;
      for (const VectorLevel level : {VectorLevel::Baseline, VectorLevel::V3, VectorLevel::V4}) {
        if (level > bestVectorLevel()) continue;
        useVectorLevel(level);
        EXPECT_EQ(hash(1, false), expected) << name << " level " << int(level);
        useVectorLevel({});
      }
    }
  }
}

TEST(CutAndGoOn, ShowsInTheHashAtOnce) {
  Simulation simulation(windySheet(findMethod("rk4")), findMethod("rk4"));
  const std::uint64_t whole = simulation.hash();
  simulation.cut({-1, 3.5, 40, 3.5});
  EXPECT_NE(simulation.hash(), whole);
  simulation.mend();
  EXPECT_EQ(simulation.hash(), whole);
}

TEST(TimedCuts, CostNoMethodItsOrder) {
  Scene scene = softSheet(Damping::Relative);
  scene.columns = 6, scene.rows = 5;
  scene.duration = 1, scene.tolerance = 0;
  scene.cuts = {{{2.5, -1, 2.5, 2.6}, kCutAt}, {{-1, 2.5, 3.2, 2.5}, 2 * kCutAt}};
  Numbers numbers(5);
  for (int i = 0; i < 30; ++i) scene.displacements.push_back({{"", i % 6, i / 6}, numbers.inCube(0.1 * scene.spacing)});
  Points reference = Bench<double>(scene).points();
  for (const Displacement& moved : scene.displacements) {
    const auto i = std::size_t(moved.particle.row * 6 + moved.particle.column);
    reference.x[i] = reference.x[i] + moved.by;
  }
  Oracle oracle(scene);
  constexpr int kReferenceSteps = 4096;
  double before = 0;
  for (const Cut& cut : scene.cuts) {
    oracle.advance(reference, cut.at - before, int(kReferenceSteps * (cut.at - before)));
    oracle.cut(cut.line);
    before = cut.at;
  }
  oracle.advance(reference, 1 - before, int(kReferenceSteps * (1 - before)));
  for (const Method& method : methods()) {
    if (!takes(method, scene)) continue;
    const auto errorAfter = [&](int steps) {
      scene.dt = 1.0 / steps;
      Simulation simulation(scene, method);
      simulation.advanceTo(1);
      Points end;
      for (int i = 0; i < 30; ++i) end.x.push_back(simulation.position(i));
      return distance(end, reference);
    };
    const int steps = 16 * (stepsFor(method.order) / 16);
    const double order = std::log2(errorAfter(steps) / errorAfter(2 * steps));
    EXPECT_NEAR(order, method.order, 0.3) << method.name;
  }
}

TEST(Cuts, WhoseNumbersAreNotFiniteOrHugeDoNoHarm) {
  Simulation simulation(windySheet(findMethod("rk4")), findMethod("rk4"));
  EXPECT_THROW(simulation.cut({NAN, 0, 1, 1}), InputError);
  EXPECT_THROW(simulation.cut({0, 0, INFINITY, 1}), InputError);
  simulation.cut({-1e300, 3.5, 1e300, 3.5});
  simulation.mend(1000);
  EXPECT_TRUE(simulation.sheet().missing.none());
}

TEST(Cuts, OfCellsInAWindKeepTheLedgerBalancedAndTheAlarmQuiet) {
  for (const char* name : {"rk4", "leapfrog", "backward-euler"}) {
    for (const bool ledger : {true, false}) {
      Scene scene = windySheet(findMethod(name));
      scene.winds[0].velocity = {4, 0, -12};
      Simulation simulation(scene, findMethod(name), {.ledger = ledger});
      simulation.tick(50);
      for (int column = 2; column < 36; ++column) simulation.cut({column + 0.5, 1.2, column + 0.5, 12});
      simulation.tick(150);
      EXPECT_EQ(simulation.check(), Status::Ok) << name;
      if (ledger) {
        EXPECT_LT(std::abs(simulation.ledger().drift), name == std::string("backward-euler") ? 1 : 1e-3) << name;
      }
    }
  }
}

/// The load on a structural spring that breaks, by the words of docs/model.md, N.
double predictedLoad(const Scene& scene) {
  return std::sqrt(2 * scene.tear.toughness * scene.structural.ks * scene.spacing);
}

TEST(TearScene, HoldsByThePredictedLoadUntilItIsCutAndThenTearsFromPinToPin) {
  Scene scene = loadScene("tear");
  const double weight = scene.particleMass * 9.81 * (scene.rows - 1);
  const double share = scene.structural.ks / (scene.structural.ks + scene.shear.ks);
  // Released, a column pulls with up to twice its weight; that is what its spring must hold.
  const auto holds = [&](double ofPredicted) {
    Scene whole = scene;
    whole.cuts.clear();
    const double load = ofPredicted * 2 * weight * share;
    whole.tear.toughness = load * load / (2 * scene.structural.ks * scene.spacing);
    Simulation simulation(whole, findMethod(scene.integrator));
    simulation.advanceTo(0.5);
    return simulation.sheet().missing.none();
  };
  EXPECT_FALSE(holds(0.95));
  EXPECT_TRUE(holds(1.05));
  EXPECT_GT(predictedLoad(scene), 1.3 * 2 * weight * share) << "the whole sheet holds";
  Simulation simulation(scene, findMethod(scene.integrator), {.ledger = true});
  const auto held = [&] {
    int count = 0;
    for (int column = 0; column < scene.columns; ++column) {
      count += simulation.sheet().missing.has(column, Missing::Down) ? 0 : 1;
    }
    return count;
  };
  simulation.advanceTo(scene.cuts[0].at);
  EXPECT_EQ(held(), scene.columns);
  simulation.tick();
  EXPECT_EQ(held(), 2 * scene.columns / 3);
  simulation.advanceTo(scene.duration);
  EXPECT_LT(held(), 4) << "a strip or two that are too light to tear";
  EXPECT_EQ(simulation.status(), Status::Ok);
  EXPECT_LT(std::abs(simulation.ledger().drift), 1e-3);
}

}  // namespace
}  // namespace tyg::test
