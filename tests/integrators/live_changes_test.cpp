// Changes of a scene's parameters while it moves: what methods do anew in place is what a new start would do.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "core/forces/parameter.h"
#include "core/scene/bodies.h"
#include "core/scene/scene_writer.h"
#include "integrators/spring_list.h"
#include "test_systems.h"
#include "tyg/methods.h"
#include "tyg/simulation.h"

namespace tyg::test {
namespace {

Scene tickingSheet(Precision precision) {
  Scene scene = softSheet(Damping::Relative);
  scene.dt = 1.0 / 256;
  scene.tolerance = 1e-4;
  scene.precision = precision;
  return scene;
}

/// Scenes that follow one another: each parameter twice and once gone, families that come and go among them.
std::vector<Scene> changedScenes(Scene scene) {
  std::vector<Scene> scenes;
  for (const Parameter& parameter : liveParameters()) {
    const Vec3 value = parameter.get(scene);
    if (value == Vec3{}) continue;  // nothing would change
    for (const double factor : {0.5, parameter.allowed == Allowed::Positive ? 2.0 : 0.0, 0.25}) {
      parameter.set(scene, {factor * value.x, factor * value.y, factor * value.z});
      scenes.push_back(scene);
    }
  }
  scene.bend = {}, scenes.push_back(scene);
  scene.bend = {5, 0.1}, scenes.push_back(scene);
  return scenes;
}

TEST(LiveChanges, GoOnAsANewIntegratorWould) {
  for (const Precision precision : {Precision::Float, Precision::Double}) {
    for (const Method& method : methods()) {
      Simulation inPlace(tickingSheet(precision), method), anew(tickingSheet(precision), method);
      for (const Scene& scene : changedScenes(tickingSheet(precision))) {
        inPlace.useLiveParameters(scene), anew.useLiveParameters(scene);
        anew.useMethod(method);
        inPlace.tick(3), anew.tick(3);
        ASSERT_EQ(inPlace.hash(), anew.hash()) << method.name;
        ASSERT_EQ(inPlace.status(), Status::Ok) << method.name;
      }
    }
  }
}

TEST(LiveChanges, OfAirAndWindGoOnAsANewIntegratorWould) {
  for (const Precision precision : {Precision::Float, Precision::Double}) {
    Scene windy = tickingSheet(precision);
    windy.air = {1.2, 1.2};
    windy.winds = {{.velocity = {2, 0, 3}, .gust = {0, 1, 0}, .wavelength = 2}};
    for (const Method& method : methods()) {
      if (!takes(method, windy)) continue;
      Simulation inPlace(windy, method), anew(windy, method);
      for (const Scene& scene : changedScenes(windy)) {
        inPlace.useLiveParameters(scene), anew.useLiveParameters(scene);
        anew.useMethod(method);
        inPlace.tick(3), anew.tick(3);
        ASSERT_EQ(inPlace.hash(), anew.hash()) << method.name;
        ASSERT_EQ(inPlace.status(), Status::Ok) << method.name;
        ASSERT_EQ(inPlace.scene(), scene) << method.name;
      }
    }
  }
}

/// The sheet above a floor and beside a ball, which it soon touches.
Scene sheetOnBodies(Precision precision) {
  Scene scene = tickingSheet(precision);
  scene.bodies = {{.shape = Shape::Plane, .at = {0, -0.15, 0}},
                  {.shape = Shape::Ball, .at = {0, -0.9, 1}, .radius = 1, .name = "ball"}};
  scene.contact.friction = 0.4;
  fillContact(scene);
  scene.contact.layer = 0.2;
  return scene;
}

TEST(LiveChanges, OfContactAndBodiesGoOnAsANewIntegratorWould) {
  for (const Precision precision : {Precision::Float, Precision::Double}) {
    Scene touching = sheetOnBodies(precision);
    touching.tolerance = largestTolerance(touching) / 16;  // more than a thinner layer allows would be taken back
    for (const Method& method : methods()) {
      Simulation inPlace(touching, method), anew(touching, method);
      inPlace.tick(20), anew.tick(20);
      for (const Scene& scene : changedScenes(touching)) {
        inPlace.useLiveParameters(scene), anew.useLiveParameters(scene);
        anew.useMethod(method);
        inPlace.tick(3), anew.tick(3);
        ASSERT_EQ(inPlace.hash(), anew.hash()) << method.name;
        ASSERT_EQ(inPlace.scene(), scene) << method.name;
      }
    }
  }
}

TEST(LiveChanges, ABodyThatIsDraggedBringsWorkAndIsLoggedAndReplayed) {
  const Scene scene = sheetOnBodies(Precision::Double);
  Simulation simulation(scene, findMethod("leapfrog"), {.ledger = true}), still(scene, findMethod("leapfrog"));
  simulation.tick(60), still.tick(60);
  const Snapshot before = simulation.save();
  Scene dragged = scene;
  for (int k = 0; k < 20; ++k) {
    dragged.bodies[1].at.y += 0.01;
    simulation.useLiveParameters(dragged);
    simulation.tick(1), still.tick(1);
  }
  EXPECT_NE(simulation.hash(), still.hash());
  const Ledger ledger = simulation.ledger();
  EXPECT_GT(ledger.work["pushes"], 0) << "the ball lifts the sheet";
  EXPECT_LT(std::abs(ledger.drift), 0.01);
  Simulation again(scene, findMethod("leapfrog"));
  again.replay(parseEventLog(formatEventLog(simulation.log()), "log"), methods());
  again.tick(80);
  EXPECT_EQ(again.hash(), simulation.hash());
  EXPECT_EQ(again.scene().bodies, dragged.bodies);
  simulation.restore(before);
  EXPECT_EQ(simulation.scene().bodies, scene.bodies);
  still = Simulation(scene, findMethod("leapfrog"));
  still.tick(65), simulation.tick(5);
  EXPECT_EQ(simulation.hash(), still.hash());
}

TEST(LiveChanges, RefuseValuesThatSceneFilesRefuse) {
  const Scene scene = sheetOnBodies(Precision::Double);
  Simulation simulation(scene, findMethod("leapfrog"));
  for (const auto& [key, value] : {std::pair{"contact.layer", 0.0}, {"contact.friction", -1.0}}) {
    Scene wrong = scene;
    findParameter(key)->set(wrong, {value, 0, 0});
    EXPECT_THROW(simulation.useLiveParameters(wrong), InputError) << key;
    EXPECT_EQ(simulation.scene(), scene) << key;
  }
}

TEST(LiveChanges, OfWhatASceneDoesNotHaveAreRefused) {
  Scene scene = sheetOnBodies(Precision::Double);
  scene.air = {}, scene.winds.clear();
  const auto refused = [&](const Scene& of, const char* key, const Vec3& value) {
    Simulation simulation(of, findMethod("leapfrog"));
    return messageOf([&] { simulation.apply({0, WorldEvent{key, value}}, methods()); });
  };
  const std::string message = refused(scene, "body.6.at", {0, 1, 0});
  EXPECT_NE(message.find("world: found the parameter 'body.6.at', which this scene has nothing for"),
            std::string::npos);
  EXPECT_NE(message.find("body.2.at"), std::string::npos) << message;
  EXPECT_NE(refused(scene, "wind.velocity", {1, 0, 0}), "");
  EXPECT_NE(refused(withoutBodies(scene), "contact.friction", {1, 0, 0}), "");
  scene.air.density = 1.2;
  EXPECT_EQ(refused(scene, "wind.velocity", {1, 0, 0}), "");
}

TEST(LiveChanges, OfAToleranceKeepToWhatBodiesAllowWhateverTheSceneNamed) {
  Scene scene = sheetOnBodies(Precision::Double);
  const double most = largestTolerance(scene);
  scene.tolerance = 100 * most;
  Scene fine = scene;
  fine.tolerance = most;
  Simulation coarse(scene, findMethod("rk4")), exact(fine, findMethod("rk4"));
  coarse.useMethod(findMethod("bs32")), exact.useMethod(findMethod("bs32"));
  coarse.tick(50), exact.tick(50);
  EXPECT_EQ(coarse.hash(), exact.hash());
  EXPECT_NE(messageOf([&] { coarse.apply({50, WorldEvent{"run.tolerance", {2 * most, 0, 0}}}, methods()); }), "");
  coarse.useLiveParameters(fine);
  fine.tolerance = 3 * most;
  coarse.useLiveParameters(fine);
  EXPECT_EQ(coarse.scene().tolerance, most);
}

TEST(LiveChanges, AWindThatIsAddedAndTakenAwayBlowsBetweenAndIsLoggedAndReplayed) {
  Scene scene = tickingSheet(Precision::Double);
  scene.air.density = 1.2;
  Simulation simulation(scene, findMethod("leapfrog")), still(scene, findMethod("leapfrog"));
  simulation.tick(20), still.tick(20);
  const Snapshot before = simulation.save();
  Scene windy = scene;
  windy.winds = {{.velocity = {0, 0, 4}, .gust = {1, 0, 2}, .wavelength = 0.7}};
  simulation.useLiveParameters(windy);
  simulation.tick(20), still.tick(20);
  EXPECT_EQ(simulation.scene().winds, windy.winds);
  EXPECT_NE(simulation.hash(), still.hash());
  EXPECT_GT(simulation.ledger().work["wind"], 0);
  simulation.useLiveParameters(scene);
  EXPECT_TRUE(simulation.scene().winds.empty());
  const double brought = simulation.ledger().work["wind"];
  EXPECT_GT(brought, 0) << "what the wind has brought stays in the ledger";
  simulation.tick(20);
  EXPECT_EQ(simulation.ledger().work["wind"], brought);
  const EventLog log = parseEventLog(formatEventLog(simulation.log()), "log");
  Simulation again(scene, findMethod("leapfrog"));
  again.replay(log, methods());
  again.tick(60);
  EXPECT_EQ(again.hash(), simulation.hash());
  simulation.restore(before);
  EXPECT_TRUE(simulation.scene().winds.empty());
  still = Simulation(scene, findMethod("leapfrog"));
  still.tick(25);
  simulation.tick(5);
  EXPECT_EQ(simulation.hash(), still.hash());
}

TEST(LiveChanges, OfAWindLeaveASceneThatReadsBack) {
  Scene scene = loadScene("flutter");
  const auto set = [&](const char* key, const Vec3& value) { findParameter(key)->set(scene, value); };
  const auto readsBack = [&] {
    Scene back = parseScene(sceneToToml(scene), scene.name);
    return back == scene;
  };
  set("wind.velocity", {});
  EXPECT_EQ(scene.winds.front().gust, Vec3{}) << "gusts travel with a wind";
  EXPECT_TRUE(readsBack());
  set("wind.velocity", {0, 0, 3}), set("wind.wavelength", {}), set("wind.gust", {1, 0, 0});
  EXPECT_GT(scene.winds.front().wavelength, 0);
  EXPECT_TRUE(readsBack());
  set("air.density", {});
  EXPECT_TRUE(readsBack()) << "a wind needs the table [air]";
  set("wind.velocity", {}), set("wind.wavelength", {});
  EXPECT_TRUE(scene.winds.empty());
  EXPECT_TRUE(readsBack());
}

TEST(LiveChanges, OfGravityKeepTheStartShapeAtHeightZero) {
  Scene scene = tickingSheet(Precision::Float);
  scene.displacements = {{.particle = Place{.name = "middle"}, .by = {0.1, 0.2, 0.3}}};
  Simulation simulation(scene, findMethod("leapfrog"));
  EXPECT_EQ(simulation.ledger().stored["gravitational"], 0);
  for (const Vec3& gravity : {Vec3{1, 2, 3}, Vec3{}, Vec3{0, -9.81, 0}}) {
    scene.gravity = gravity;
    simulation.useLiveParameters(scene);
    EXPECT_EQ(simulation.ledger().stored["gravitational"], 0);
  }
}

TEST(LiveChanges, LeaveALiveStableStepThatIsThatOfANewSimulation) {
  const Method& method = findMethod("leapfrog");
  Scene scene = tickingSheet(Precision::Double);
  Simulation changed(scene, method);
  changed.liveStableStep();
  scene.structural.ks *= 4, scene.bend = {};
  changed.useLiveParameters(scene);
  Simulation fresh(scene, method);
  for (int call = 0; call < 5; ++call) EXPECT_EQ(changed.liveStableStep(), fresh.liveStableStep());
}

TEST(LiveChanges, OfSpringsListThemAsANewListWould) {
  Scene scene = softSheet(Damping::Relative);
  const Sheet sheet = makeSheet(scene);
  std::vector<ListedSpring> springs = listSprings(scene, sheet);
  for (const Scene& now : changedScenes(scene)) {
    relistSprings(springs, scene, now, sheet);
    const std::vector<ListedSpring> expected = listSprings(now, sheet);
    ASSERT_EQ(springs.size(), expected.size());
    for (std::size_t k = 0; k < springs.size(); ++k) {
      EXPECT_EQ(springs[k].first, expected[k].first);
      EXPECT_EQ(springs[k].ks, expected[k].ks);
      EXPECT_EQ(springs[k].kd, expected[k].kd);
      EXPECT_EQ(springs[k].rest, expected[k].rest);
    }
    scene = now;
  }
}

}  // namespace
}  // namespace tyg::test
