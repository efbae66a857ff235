// A scene in other units of length, mass and time gives the same run in these units, to the last bit: no threshold of
// the simulator is an absolute number.
#include "scaled_scene.h"

#include <gtest/gtest.h>

#include "contact_reference.h"
#include "tyg/methods.h"
#include "tyg/simulation.h"

namespace tyg::test {
namespace {

/// The report's RK4 depends on the unit of time by its own formula.
bool fits(const Method& method, const Units& units) { return units.time == 1 || method.name != "report-rk4"; }

struct Ending {
  Status status = Status::Ok;
  double alarmTime = 0;
  std::int64_t steps = 0;
  double drift = 0, scale = 0, maxStretch = 0;
  Vec3 corner, middle;
};

Ending endingOf(const Scene& scene, const Method& method, const Units& units) {
  Simulation simulation(scaled(scene, units), method, {.threads = 1, .ledger = true});
  simulation.advanceTo(simulation.scene().duration);
  const Ledger ledger = simulation.ledger();
  const double energy = units.mass * units.length * units.length / units.time / units.time;
  const int count = simulation.sheet().count();
  return {simulation.status(),
          simulation.status() == Status::Ok ? 0 : simulation.alarmTime() / units.time,
          simulation.steps(),
          ledger.drift,
          ledger.scale / energy,
          ledger.maxStretch,
          1 / units.length * simulation.position(count - 1),
          1 / units.length * simulation.position(count / 2)};
}

void expectSame(const Scene& scene, const Method& method) {
  const Ending expected = endingOf(scene, method, {});
  for (const Units& units : kUnits) {
    if (!fits(method, units)) continue;
    const Ending found = endingOf(scene, method, units);
    SCOPED_TRACE(scene.name + " " + std::string(method.name) + " length " + std::to_string(units.length) + " mass " +
                 std::to_string(units.mass) + " time " + std::to_string(units.time));
    EXPECT_EQ(found.status, expected.status);
    EXPECT_EQ(found.alarmTime, expected.alarmTime);
    EXPECT_EQ(found.steps, expected.steps);
    EXPECT_EQ(found.drift, expected.drift);
    EXPECT_EQ(found.scale, expected.scale);
    EXPECT_EQ(found.maxStretch, expected.maxStretch);
    EXPECT_EQ(found.corner, expected.corner);
    EXPECT_EQ(found.middle, expected.middle);
  }
}

TEST(ScaledScenes, OfEveryMethodMoveAlike) {
  Scene scene = withSheet(loadScene("poke"), 7, 6);
  scene.drag = 0.01;
  for (Push& push : scene.pushes) push.at = 0.1, push.duration = 0.05;
  scene.duration = 0.3;
  for (const Method& method : methods()) {
    for (const Precision precision : {Precision::Float, Precision::Double}) {
      scene.precision = precision;
      expectSame(scene, method);
    }
  }
}

TEST(ScaledScenes, WithBodiesAirAndMotionsMoveAlike) {
  Scene scene = sheetInLayers();
  scene.contact.layer = 1, scene.bodies[0].at.y = 1.5;
  scene.air = {1.2, 1};
  scene.winds = {{.velocity = {1, 0, 1}, .gust = {0, 1, 0}, .wavelength = 3}};
  scene.dt = 0.01, scene.tolerance = 1e-4, scene.duration = 0.5;
  for (const Method& method : methods()) {
    for (const Precision precision : {Precision::Float, Precision::Double}) {
      scene.precision = precision;
      if (takes(method, scene)) expectSame(scene, method);
    }
  }
}

TEST(ScaledScenes, FailAlike) {
  for (const BuiltinScene& builtin : builtinScenes()) {
    if (!showsFailure(builtin)) continue;
    const Scene scene = loadScene(std::string(builtin.name));
    expectSame(scene, findMethod(scene.integrator));
  }
}

}  // namespace
}  // namespace tyg::test
