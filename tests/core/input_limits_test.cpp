// Scenes with numbers that nothing can be computed with, with keys that go too deep, and with very many lines.
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "core/scene/key_depth.h"
#include "core/scene/scene_range.h"
#include "test_systems.h"
#include "tyg/methods.h"
#include "tyg/simulation.h"

namespace tyg::test {
namespace {

constexpr const char* kScene =
    "title = \"a\"\n[sheet]\ncolumns = 2\nrows = 2\nspacing = 1\nparticle_mass = 1\n[run]\nduration = 1\nintegrator = "
    "\"rk4\"\ndt = 0.1\n";

std::string refusalOf(const std::string& text) {
  return messageOf([&] { (void)parseScene(text, "a.toml"); });
}

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int k = 0; k < times; ++k) all += text;
  return all;
}

TEST(SceneRange, RefusesWhatOverflowsOrVanishesAndNamesTheKey) {
  struct Case {
    const char* key;
    void (*spoil)(Scene& scene, double number);
    bool mayBeZero;
  };
  const Case cases[] = {
      {"sheet.particle_mass", [](Scene& s, double x) { s.particleMass = x; }, false},
      {"sheet.spacing", [](Scene& s, double x) { s.spacing = x; }, false},
      {"run.duration", [](Scene& s, double x) { s.duration = x; }, false},
      {"springs.structural.ks", [](Scene& s, double x) { s.structural.ks = x; }, true},
      {"springs.bend.kd", [](Scene& s, double x) { s.bend.kd = x; }, true},
      {"world.drag", [](Scene& s, double x) { s.drag = x; }, true},
  };
  for (const Case& one : cases) {
    for (const double number : {1e-30, 1.0, 1e30}) {
      Scene scene = emptyWorld(3, 3);
      one.spoil(scene, number);
      EXPECT_NO_THROW(refuseExtremes(scene)) << one.key << number;
    }
    for (const double number : {1e-320, 1e-31, 1e31, 1e308, std::numeric_limits<double>::quiet_NaN()}) {
      Scene scene = emptyWorld(3, 3);
      one.spoil(scene, number);
      const std::string refusal = messageOf([&] { Simulation(scene, findMethod("rk4")); });
      EXPECT_NE(refusal.find("key " + std::string(one.key) + ": found "), std::string::npos) << refusal;
      EXPECT_NE(refusal.find("size from 1e-30 to 1e+30"), std::string::npos) << refusal;
    }
    Scene scene = emptyWorld(3, 3);
    one.spoil(scene, 0);
    const std::string refusal = messageOf([&] { refuseExtremes(scene); });
    EXPECT_EQ(refusal.empty(), one.mayBeZero) << one.key << refusal;
  }
}

TEST(SceneRange, IsSaidOfTheLineOfASceneFile) {
  const std::string sizes = ", allowed are numbers of a size from 1e-30 to 1e+30";
  EXPECT_EQ(refusalOf(std::string(kScene) + "[world]\ndrag = 1e31\n"),
            "a.toml:12: key world.drag: found 1e+31" + sizes);
  EXPECT_EQ(refusalOf(std::string(kScene) + "[world]\ndrag = 1e-31\n"),
            "a.toml:12: key world.drag: found 1e-31" + sizes);
  EXPECT_EQ(refusalOf(std::string(kScene) + "[world]\ngravity = [0, -1e31, 0]\n"),
            "a.toml:12: key world.gravity: found [0, -1e+31, 0]" + sizes);
  EXPECT_EQ(refusalOf(std::string(kScene) + "[[cut]]\nfrom = [0, 1e31]\nto = [1, 0]\nat = 0\n"),
            "a.toml:12: key cut.from: found [0, 1e+31]" + sizes);
  for (const char* taken : {"[world]\ngravity = [1e-31, 0, 0]\n", "tolerance = 1e-31\n"}) {
    EXPECT_EQ(refusalOf(std::string(kScene) + taken), "");
  }
}

TEST(SceneRange, HoldsForChangesOfARunningSimulationToo) {
  Scene scene = emptyWorld(2, 2);
  Simulation simulation(scene, findMethod("rk4"));
  scene.drag = 1e-80;
  EXPECT_NE(messageOf([&] { simulation.useLiveParameters(scene); }).find("world.drag"), std::string::npos);
  EXPECT_EQ(simulation.scene().drag, 0);
  EXPECT_TRUE(simulation.log().events.empty());
}

TEST(KeyDepth, CountsThePartsOfKeysAlone) {
  EXPECT_EQ(lineOfDeepKey("a.b.c = 1\n", 3), 0);
  EXPECT_EQ(lineOfDeepKey("x = 1\na.b.c.d = 1\n", 3), 2);
  EXPECT_EQ(lineOfDeepKey("[ a . \"b.c\" . 'd' . e ]\n", 3), 1);
  EXPECT_EQ(lineOfDeepKey("x = { a.b.c.d = 1 }", 3), 1);
  EXPECT_EQ(lineOfDeepKey("x = \"a.b.c.d.e \\\" . . . .\" # a.b.c.d.e\ny = [1.5, 2.5, 3.5, 4.5, 5.5]\n", 3), 0);
  EXPECT_EQ(lineOfDeepKey("x = '''\na.b.c.d\n'''\ny = \"\"\"\n. . . . \"\" .\n\"\"\"\n a.b.c.d", 3), 7);
  EXPECT_EQ(lineOfDeepKey("x = \"a\n", 3), 0);
}

TEST(DeepScenes, AreRefusedWithTheirLine) {
  const std::string deep = repeated("a.", 40000) + "a";
  for (const std::string& line : {deep + " = 1\n", "[" + deep + "]\n", "x = { " + deep + " = 1 }\n"}) {
    EXPECT_EQ(refusalOf(kScene + line),
              "a.toml:11: found a key of more than 8 parts, allowed are keys such as springs.shear.ks");
  }
}

TEST(LargeScenes, AreRefusedWhereTheyAreLargerThanAnyScene) {
  const std::string refusal = refusalOf(kScene + repeated("# a comment of 31 characters ..\n", 1 << 19));
  EXPECT_NE(refusal.find("a.toml: found a scene of 16777"), std::string::npos) << refusal;
}

/// Quadratic work would take the test's time limit.
TEST(LargeScenes, WithAHundredThousandPinsAreReadAndMade) {
  std::string text = kScene;
  text.replace(text.find("columns = 2"), 11, "columns = 4096");
  text.replace(text.find("[run]"), 0, "pins = [" + repeated("\"top\", [5, 1], ", 50000) + "]\n");
  const Scene scene = parseScene(text, "a.toml");
  EXPECT_EQ(scene.pins.size(), 100000U);
  EXPECT_EQ(makeSheet(scene).pins.size(), 4097U);
}

TEST(LargeScenes, WithThousandsOfPushesGiveTheWholeImpulse) {
  constexpr int kPushes = 8000;
  Scene scene = emptyWorld(2, 1);
  scene.gravity = {};
  scene.dt = 1;
  for (int k = kPushes; k-- > 0;) scene.pushes.push_back({{"", k % 2, 0}, {1, 0, 0}, 1e-4 * k, 1e-4});
  Simulation simulation(scene, findMethod("symplectic-euler"));
  simulation.advanceTo(1);
  for (const int particle : {0, 1}) {
    EXPECT_NEAR(simulation.velocity(particle).x * scene.particleMass, 0.5 * kPushes * 1e-4, 1e-9);
  }
}

/// Two thousand of them act together, on every particle of the row, and begin in no order of the particles.
TEST(LargeScenes, WithThousandsOfPushesAtOnceGiveEachParticleItsOwn) {
  constexpr int kPushes = 8000, kColumns = 40;
  constexpr double kFor = 0.2;  // s
  Scene scene = emptyWorld(kColumns, 1);
  scene.gravity = {};
  scene.dt = 1;
  for (int k = 0; k < kPushes; ++k) {
    const int column = 17 * k % kColumns;
    scene.pushes.push_back({{"", column, 0}, {1.0 + column, 0, 0}, 1e-4 * k, kFor});
  }
  Simulation simulation(scene, findMethod("symplectic-euler"));
  simulation.advanceTo(1);
  for (int column = 0; column < kColumns; ++column) {
    EXPECT_NEAR(simulation.velocity(column).x * scene.particleMass, double(kPushes) / kColumns * kFor * (1.0 + column),
                1e-7);
  }
}

/// Sixty-four steps of such a sheet, after which a small one asks, would take seconds.
TEST(LargeSheets, AskTheirObserverEveryFewSteps) {
  Scene scene = emptyWorld(1024, 1024);
  scene.precision = Precision::Float;
  int asked = 0;
  Simulation simulation(scene, findMethod("rk4"));
  simulation.observe([&] { return ++asked < 3; });
  simulation.tick(64);
  EXPECT_EQ(asked, 3);
  EXPECT_LT(simulation.steps(), 20);
}

TEST(InputError, ShowsTheNulsOfItsMessage) {
  const std::string found("a\0b", 3);
  EXPECT_STREQ(InputError("found '" + found + "', allowed c").what(), "found 'a\\0b', allowed c");
}

}  // namespace
}  // namespace tyg::test
