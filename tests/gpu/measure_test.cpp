// What the card measures is what the processor measures, to the last bit, and no state is read back for it.
#include <gtest/gtest.h>

#include <functional>
#include <initializer_list>
#include <string_view>

#include "card_here.h"
#include "core/forces/state.h"

namespace tyg {
namespace {

class Measure : public OnCard {
 protected:
  /// Runs both with the ledger, which takes the power of every evaluation.
  void expectSame(const Scene& scene, double time, std::initializer_list<std::string_view> touched = {},
                  const std::function<void(Simulation&)>& edit = {}) {
    Settings there = onCard(), here = onProcessor();
    there.ledger = here.ledger = true;
    Simulation onIt(scene, findMethod("leapfrog"), there), beside(scene, findMethod("leapfrog"), here);
    for (Simulation* simulation : {&onIt, &beside}) {
      if (edit) edit(*simulation);
      simulation->advanceTo(time);
    }
    const Ledger a = onIt.ledger(), b = beside.ledger();
    EXPECT_EQ(a.kinetic, b.kinetic);
    for (std::size_t k = 0; k < kStores.count; ++k) {
      const std::string_view name = kStores.list[k].name;
      EXPECT_EQ(a.stored[name], b.stored[name]) << name;
    }
    EXPECT_EQ(a.work.sum(), b.work.sum());
    EXPECT_EQ(a.dissipated, b.dissipated);
    EXPECT_EQ(a.maxStretch, b.maxStretch);
    EXPECT_EQ(onIt.largestSpeed(), beside.largestSpeed());
    EXPECT_EQ(hashText(onIt), hashText(beside));
    for (const std::string_view name : touched) EXPECT_NE(b.stored[name] + b.work[name], 0) << name;
    EXPECT_GT(b.dissipated, 0);
  }
  /// What this many ticks read back, bytes.
  std::size_t bytesOfTicks(Simulation& simulation, int ticks) {
    const std::size_t before = device_->bytesRead();
    simulation.tick(ticks);
    return device_->bytesRead() - before;
  }
  [[nodiscard]] static std::size_t stateBytes(const Simulation& simulation) {
    return 6 * sizeof(float) * static_cast<std::size_t>(Layout(simulation.sheet()).plane);
  }
};

/// Over bodies of every shape, of which one moves, in wind with gusts and drag.
Scene windyScene(int columns, int rows) {
  Scene scene = inFloat(withSheet(loadScene("storm"), columns, rows));
  scene.drag = 0.002;
  scene.bodies.push_back({.shape = Shape::Box, .at = {0.2, -0.3, 0.1}, .half = {0.3, 0.25, 0.2}, .radius = 0.2});
  scene.bodies.push_back({.shape = Shape::Capsule, .at = {-0.3, -0.2, -0.05}, .axis = {0.4, 0.1, 0}, .radius = 0.2});
  scene.bodies.front().at = {0.1, -0.4, 0.35};
  scene.moves.erase(scene.moves.begin() + 1);  // of the ball, back
  for (Move& move : scene.moves) move.at = 0;
  scene.dt = 2e-4;
  return scene;
}

TEST_F(Measure, GivesTheProcessorsBitsForSheetsOfEveryShape) {
  for (const auto& [columns, rows] : {std::pair{37, 23}, {1, 20}, {33, 1}, {2, 2}, {3, 17}, {9, 16}}) {
    SCOPED_TRACE(testing::Message() << columns << " x " << rows);
    expectSame(inFloat(withSheet(loadScene("curtain"), columns, rows)), 0.05);
  }
}

TEST_F(Measure, GivesTheProcessorsBitsWithEveryTerm) {
  for (const Damping damping : {Damping::Relative, Damping::Axial}) {
    for (const double friction : {0.0, 0.4}) {
      Scene scene = windyScene(21, 18);
      scene.damping = damping, scene.contact.friction = friction;
      SCOPED_TRACE(testing::Message() << "axial " << (damping == Damping::Axial) << ", friction " << friction);
      expectSame(scene, 0.1, {"elastic", "gravitational", "contact", "wind", "bodies"});
    }
  }
}

TEST_F(Measure, GivesTheProcessorsBitsWithFamiliesThatAreNotThereOrDoNotDamp) {
  for (int without = 0; without < 3; ++without) {
    Scene scene = windyScene(12, 11);
    SpringFamily* const families[] = {&scene.structural, &scene.shear, &scene.bend};
    *families[without] = {};
    families[(without + 1) % 3]->kd = 0;
    SCOPED_TRACE(without);
    expectSame(scene, 0.05);
  }
}

TEST_F(Measure, GivesTheProcessorsBitsOfACutSheet) {
  expectSame(windyScene(14, 13), 0.05, {"elastic"}, [](Simulation& simulation) {
    simulation.cut({2.5, 0.5, 2.5, 9.5});
    simulation.cut({5.5, 3.2, 11.5, 3.2});
  });
}

TEST_F(Measure, ReadsNoStateBackForAnEnergyCheckNorForEveryEvaluation) {
  for (const bool ledger : {false, true}) {
    Settings settings = onCard();
    settings.ledger = ledger;
    Simulation simulation(windyScene(64, 64), findMethod("leapfrog"), settings);
    (void)bytesOfTicks(simulation, 64);
    const std::size_t bytes = bytesOfTicks(simulation, 128);
    EXPECT_GT(bytes, 0U);
    EXPECT_LT(bytes, 3 * stateBytes(simulation)) << "two checks, and 128 evaluations whose power is added up";
  }
  Scene still = windyScene(64, 64);
  still.moves.clear();
  Simulation simulation(still, findMethod("leapfrog"), onCard());
  (void)bytesOfTicks(simulation, 64);
  EXPECT_LT(bytesOfTicks(simulation, 128), stateBytes(simulation) / 8);
}

TEST_F(Measure, ReadsNoStateBackForHandsPushesAndTears) {
  Scene scene = inFloat(withSheet(loadScene("tear"), 64, 64));
  Simulation simulation(scene, findMethod("leapfrog"), onCard());
  simulation.tick(3);
  const int pin = simulation.sheet().pins.front();
  simulation.grab(pin, {0.1, 0, 0});  // begins with another sheet, in which this pin is held
  simulation.tick(3);
  const std::size_t before = device_->bytesRead();
  simulation.push(200, {0, 0, 0.01}, 5);
  simulation.tick(8);
  simulation.grab(pin, {0, 0.1, 0});
  simulation.tick(8);
  EXPECT_EQ(simulation.sheet().missing.none(), true);
  EXPECT_LT(device_->bytesRead() - before, stateBytes(simulation) / 8);
}

}  // namespace
}  // namespace tyg
