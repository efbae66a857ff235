// Every method asks for exactly as many force evaluations as its line in the table says.
#include <gtest/gtest.h>

#include "core/simulation/integrator.h"
#include "test_systems.h"
#include "tyg/methods.h"
#include "tyg/simulation.h"

namespace tyg::test {
namespace {

/// Whether the table says how many: a method may take as many as a step needs.
bool declares(const Method& method) { return method.evaluationsPerStep >= 0; }

TEST(Counts, OfEveryMethodAreAsDeclaredPerStepAndAtTheStart) {
  for (const Method& method : methods()) {
    if (!declares(method)) continue;
    Bench<double> bench(softSheet(Damping::Relative));
    const auto integrator = method.make<double>(bench.scene, bench.sheet);
    std::int64_t expected = method.evaluationsAtStart;
    for (int n = 0; n < 5; ++n) {
      integrator->step(bench.forces, bench.state, 0, 0.01);
      expected += method.evaluationsPerStep;
      EXPECT_EQ(bench.forces.evaluations(), expected) << method.name << " after step " << n + 1;
    }
  }
}

TEST(Counts, OfEveryMethodStartAnewAfterAReset) {
  for (const Method& method : methods()) {
    if (!declares(method)) continue;
    Bench<double> bench(softSheet(Damping::Relative));
    const auto integrator = method.make<double>(bench.scene, bench.sheet);
    for (int n = 0; n < 3; ++n) {
      integrator->reset();
      integrator->step(bench.forces, bench.state, 0, 0.01);
    }
    EXPECT_EQ(bench.forces.evaluations(), 3 * (method.evaluationsPerStep + method.evaluationsAtStart)) << method.name;
  }
}

TEST(Counts, OfASimulationIncludeOneStartForEachJumpOfTheForce) {
  Scene scene = softSheet(Damping::Relative);
  scene.dt = 0.01;
  scene.tolerance = 0;  // adaptive methods take steps of dt
  scene.pushes = {{{"middle"}, {0, 0, 1}, 0.25, 0.25}};
  for (const Method& method : methods()) {
    if (!declares(method)) continue;
    Simulation simulation(scene, method);
    simulation.advanceTo(1);
    EXPECT_EQ(simulation.steps(), 100);
    EXPECT_EQ(simulation.forceEvaluations(), 100 * method.evaluationsPerStep + 3 * method.evaluationsAtStart)
        << method.name;
  }
}

TEST(Counts, AreNotChangedByLookingAtTheLedger) {
  Scene scene = softSheet(Damping::Relative);
  scene.dt = 0.01;
  for (const Method& method : methods()) {
    Simulation unseen(scene, method), seen(scene, method);
    for (int n = 0; n < 100; ++n) {
      unseen.tick();
      seen.tick();
      seen.ledger();
    }
    EXPECT_EQ(seen.forceEvaluations(), unseen.forceEvaluations()) << method.name;
    EXPECT_EQ(seen.hash(), unseen.hash()) << method.name;
  }
}

}  // namespace
}  // namespace tyg::test
