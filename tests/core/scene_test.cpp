// Scenes that are taken: defaults, every key, the built-in ones, and the same cloth on another grid.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include "tyg/methods.h"
#include "tyg/scene.h"
#include "tyg/sheet.h"

namespace tyg::test {
namespace {

constexpr double kRounding = 1e-15;  // relative: a few operations on doubles

constexpr const char* kShortest = R"(title = "Shortest"
[sheet]
columns = 3
rows = 2
spacing = 0.5
particle_mass = 0.25
[run]
duration = 4
integrator = "rk4"
dt = 0.01
)";

constexpr const char* kEveryKey = R"(title = "Poke"
shows = "A sheet hung by its two top corners swings down, is poked, and settles."
[sheet]
columns = 20
rows = 20
spacing = 0.1            # m
start = "flat"           # "hanging" | "flat"
particle_mass = 0.018    # kg each
pins = ["top-left", "top-right"]
[springs]
damping = "axial"        # "relative" | "axial"
structural = { ks = 1200, kd = 0.1 }   # N/m, N s/m
shear      = { ks = 900,  kd = 0.2 }
bend       = { ks = 200,  kd = 0.3 }
[world]
gravity = [1, -9.81, 0.5]
drag = 0.04
[[displace]]
particle = "bottom-left"
by = [0.1, 0, 0]         # m
[[push]]
particle = "middle"
force = [0, 0, 2.0]      # N
at = 0.5                 # s
for = 0.1                # s
[[push]]
particle = [3, 4]
force = [1, -2, 0]
at = 0
for = 0
[run]
duration = 2.0           # s
integrator = "leapfrog"
dt = 0.002
tolerance = 1e-5
precision = "float"
)";

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
  return text;
}

TEST(Scene, HasTheDefaultsOfAnEmptyWorld) {
  const Scene scene = parseScene(kShortest, "shortest.toml", methodNames());
  Scene expected;
  expected.name = "shortest.toml";
  expected.title = "Shortest";
  expected.columns = 3, expected.rows = 2, expected.spacing = 0.5, expected.particleMass = 0.25;
  expected.duration = 4, expected.integrator = "rk4", expected.dt = 0.01;
  expected.start = Start::Hanging;
  expected.damping = Damping::Relative;
  expected.gravity = {0, -9.81, 0};
  expected.tolerance = 1e-4;
  expected.precision = Precision::Double;
  EXPECT_EQ(scene, expected);
  EXPECT_TRUE(scene.shows.empty() && scene.pins.empty() && scene.displacements.empty() && scene.pushes.empty());
  EXPECT_FALSE(scene.structural.present() || scene.shear.present() || scene.bend.present());
  EXPECT_EQ(scene.drag, 0);
}

TEST(Scene, HoldsEveryKeyOfItsFile) {
  Scene expected;
  expected.name = "poke.toml";
  expected.title = "Poke";
  expected.shows = "A sheet hung by its two top corners swings down, is poked, and settles.";
  expected.columns = 20, expected.rows = 20, expected.spacing = 0.1, expected.particleMass = 0.018;
  expected.start = Start::Flat;
  expected.pins = {{"top-left"}, {"top-right"}};
  expected.damping = Damping::Axial;
  expected.structural = {1200, 0.1}, expected.shear = {900, 0.2}, expected.bend = {200, 0.3};
  expected.gravity = {1, -9.81, 0.5}, expected.drag = 0.04;
  expected.displacements = {{{"bottom-left"}, {0.1, 0, 0}}};
  expected.pushes = {{{"middle"}, {0, 0, 2}, 0.5, 0.1}, {{"", 3, 4}, {1, -2, 0}, 0, 0}};
  expected.duration = 2, expected.integrator = "leapfrog", expected.dt = 0.002, expected.tolerance = 1e-5;
  expected.precision = Precision::Float;
  EXPECT_EQ(parseScene(kEveryKey, "poke.toml", methodNames()), expected);
}

TEST(Scene, TakesAnyMethodWhereNoneAreGiven) {
  const std::string text = replaced(kShortest, "rk4", "guesswork");
  EXPECT_EQ(parseScene(text, "test").integrator, "guesswork");
  EXPECT_THROW(parseScene(text, "test", methodNames()), InputError);
}

TEST(Scene, SpreadsADensityOverItsParticles) {
  const std::string text = replaced(kShortest, "particle_mass = 0.25", "area_density = 0.3");
  const double area = 2 * 0.5 * 1 * 0.5;  // m2, of 3x2 particles half a metre apart
  EXPECT_NEAR(parseScene(text, "test").particleMass, 0.3 * area / 6, kRounding);
}

TEST(Scene, ReadsTheLineEndsAndMarksOfOtherSystems) {
  const Scene plain = parseScene(kEveryKey, "test");
  EXPECT_EQ(parseScene(replaced(kEveryKey, "\n", "\r\n"), "test"), plain);
  EXPECT_EQ(parseScene(std::string("\xef\xbb\xbf") + kEveryKey, "test"), plain);
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "scene_test_crlf.toml";
  std::ofstream(path, std::ios::binary) << "\xef\xbb\xbf" << replaced(kEveryKey, "\n", "\r\n");
  Scene loaded = loadScene(path.string());
  std::filesystem::remove(path);
  EXPECT_EQ(loaded.name, path.string());
  loaded.name = plain.name;
  EXPECT_EQ(loaded, plain);
}

TEST(Scene, CountsTheLinesOfOtherSystemsAlike) {
  const std::string wrong = replaced(replaced(kShortest, "0.25", "-1"), "\n", "\r\n");
  try {
    parseScene("\xef\xbb\xbf" + wrong, "test");
    FAIL() << "a negative mass was taken";
  } catch (const InputError& mistake) {
    EXPECT_EQ(std::string(mistake.what()),
              "test:6: key sheet.particle_mass: found -1, allowed a finite number above 0");
  }
}

TEST(BuiltinScenes, AllParseAndSayWhatTheyShow) {
  std::set<std::string_view> names;
  for (const BuiltinScene& builtin : builtinScenes()) {
    SCOPED_TRACE(std::string(builtin.name));
    Scene scene;
    ASSERT_NO_THROW(scene = loadScene(std::string(builtin.name), methodNames()));
    EXPECT_EQ(scene.name, builtin.name);
    EXPECT_FALSE(scene.title.empty());
    EXPECT_FALSE(scene.shows.empty());
    names.insert(builtin.name);
  }
  for (const char* name :
       {"curtain", "poke", "four-particles", "spring", "chain", "flag", "hammock", "drop", "stiff"}) {
    EXPECT_EQ(names.count(name), 1U) << name;
  }
}

TEST(BuiltinScenes, AreInTheOrderOfTheirNamesBehindTheCurtain) {
  const std::span<const BuiltinScene> scenes = builtinScenes();
  ASSERT_GE(scenes.size(), 2U);
  EXPECT_EQ(scenes[0].name, "curtain");
  for (std::size_t i = 2; i < scenes.size(); ++i) EXPECT_LT(scenes[i - 1].name, scenes[i].name);
}

TEST(BuiltinScenes, HoldTheReportsClothTheSamePokedAndAHundredTimesStiffer) {
  const Scene curtain = loadScene("curtain"), poke = loadScene("poke"), stiff = loadScene("stiff");
  EXPECT_EQ(curtain.structural, (SpringFamily{1200, 0.1}));
  EXPECT_EQ(curtain.pins, (std::vector<Place>{{"top-left"}, {"top-right"}}));
  EXPECT_TRUE(curtain.displacements.empty() && curtain.pushes.empty());
  Scene calm = poke;
  calm.pushes.clear();
  calm.name = curtain.name, calm.title = curtain.title, calm.shows = curtain.shows;
  EXPECT_EQ(calm, curtain);
  EXPECT_EQ(poke.pushes, (std::vector<Push>{{{"middle"}, {0, 0, 2}, 0.5, 0.1}}));
  EXPECT_EQ(stiff.structural.ks, 100 * curtain.structural.ks);
  EXPECT_EQ(stiff.shear.ks, 100 * curtain.shear.ks);
  EXPECT_EQ(stiff.bend.ks, 100 * curtain.bend.ks);
}

TEST(BuiltinScenes, AreListedWhereANameIsUnknown) {
  try {
    loadScene("nonsense");
    FAIL() << "a scene that is not there was loaded";
  } catch (const InputError& mistake) {
    const std::string said = mistake.what();
    EXPECT_NE(said.find("'nonsense'"), std::string::npos) << said;
    for (const BuiltinScene& scene : builtinScenes()) {
      EXPECT_NE(said.find(std::string(scene.name)), std::string::npos) << scene.name << " in: " << said;
    }
  }
}

/// A cloth of 9x5 particles, 2 m by 1 m.
Scene cloth() {
  Scene scene = parseScene(kEveryKey, "test");
  scene.columns = 9, scene.rows = 5, scene.spacing = 0.25;
  scene.pins = {{"top"}, {"", 4, 2}, {"", 8, 4}};
  scene.displacements[0].particle = {"", 1, 1};
  scene.pushes[1].particle = {"", 3, 4};
  return scene;
}

TEST(AnotherGrid, KeepsSizeMassDragAndSprings) {
  const Scene before = cloth(), after = withSheet(before, 33, 17);
  EXPECT_EQ(after.columns, 33);
  EXPECT_EQ(after.rows, 17);
  EXPECT_NEAR(makeSheet(after).size(), makeSheet(before).size(), kRounding * 2);
  EXPECT_NEAR(after.particleMass * 33 * 17, before.particleMass * 9 * 5, kRounding);
  EXPECT_NEAR(after.drag * 33 * 17, before.drag * 9 * 5, kRounding * 2);
  EXPECT_EQ(after.structural, before.structural);
  EXPECT_EQ(after.shear, before.shear);
  EXPECT_EQ(after.bend, before.bend);
  EXPECT_EQ(after.pushes[0], before.pushes[0]);
  EXPECT_EQ(after.dt, before.dt);
  EXPECT_NEAR(withSheet(before, 5, 17).spacing, 2.0 / 16, kRounding);  // the larger count spans the larger side
}

TEST(AnotherGrid, MovesNumberedPlacesToTheNearestParticle) {
  const Scene finer = withSheet(cloth(), 33, 17);
  EXPECT_EQ(finer.pins, (std::vector<Place>{{"top"}, {"", 16, 8}, {"", 32, 16}}));
  EXPECT_EQ(finer.displacements[0].particle, (Place{"", 4, 4}));
  EXPECT_EQ(finer.pushes[0].particle, (Place{"middle"}));
  EXPECT_EQ(finer.pushes[1].particle, (Place{"", 12, 16}));
  const Scene coarser = withSheet(cloth(), 4, 3);  // 3/8 and 2/4 of the way
  EXPECT_EQ(coarser.pins, (std::vector<Place>{{"top"}, {"", 2, 1}, {"", 3, 2}}));
  EXPECT_EQ(coarser.displacements[0].particle, (Place{"", 0, 1}));  // 3/8 of a column, half a row
  EXPECT_EQ(coarser.pushes[1].particle, (Place{"", 1, 2}));         // 9/8 of a column
  EXPECT_EQ(withSheet(cloth(), 1, 3).pins[2], (Place{"", 0, 2}));
}

TEST(AnotherGrid, OfTheSameCountsIsTheSameScene) { EXPECT_EQ(withSheet(cloth(), 9, 5), cloth()); }

TEST(AnotherGrid, IsRefusedOutsideOfWhatASheetMayBe) {
  for (const auto& [columns, rows] : {std::pair{0, 5}, {9, 0}, {4097, 5}, {9, 4097}, {-1, 5}}) {
    try {
      withSheet(cloth(), columns, rows);
      ADD_FAILURE() << columns << "x" << rows << " was taken";
    } catch (const InputError& mistake) {
      EXPECT_EQ(std::string(mistake.what()),
                "sheet: found " + std::to_string(columns) + "x" + std::to_string(rows) + ", allowed 1x1 to 4096x4096");
    }
  }
  EXPECT_EQ(withSheet(cloth(), 4096, 1).columns, 4096);
}

TEST(AnotherGrid, IsRefusedWhereThereIsNoSizeToKeep) {
  Scene single = cloth();
  single.columns = single.rows = 1;
  EXPECT_EQ(withSheet(single, 1, 1), single);
  EXPECT_THROW(withSheet(single, 2, 1), InputError);
  EXPECT_THROW(withSheet(cloth(), 1, 1), InputError);
}

}  // namespace
}  // namespace tyg::test
