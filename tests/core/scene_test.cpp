// Right scene files: every key, the defaults, the built-in scenes, and the same cloth on another grid.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "files.h"
#include "tyg/methods.h"
#include "tyg/scene.h"
#include "tyg/sheet.h"

namespace tyg::test {
namespace {

/// A few products of doubles, each rounded once.
constexpr double kRounding = 8 * std::numeric_limits<double>::epsilon();

const char* const kEverything = R"(title = "Everything"
shows = "All keys."
[sheet]
columns = 5
rows = 4
spacing = 0.25
start = "flat"
area_density = 0.2
pins = ["top", "corners", [2, 3]]
[springs]
damping = "axial"
structural = { ks = 1200, kd = 0.1 }
shear = { ks = 900 }
bend = { kd = 0.3 }
[world]
gravity = [1, -2.5, 3]
drag = 0.01
[[displace]]
particle = "bottom-left"
by = [0.1, 0, -1]
[[push]]
particle = [3, 2]
force = [0, 0, 2.0]
at = 0
for = 0.1
[[push]]
particle = "middle"
force = [1, 0, 0]
at = 0.5
for = 0
[run]
duration = 2
integrator = "leapfrog"
dt = 0.002
tolerance = 1e-6
precision = "float"
)";

const char* const kLeast = R"(title = "Least"
sheet = { columns = 1, rows = 1, spacing = 1, particle_mass = 1 }
run = { duration = 1, integrator = "anything", dt = 0.1 }
)";

TEST(Scene, EveryKeyOfTheFileArrives) {
  Scene expected;
  expected.name = "everything.toml";
  expected.title = "Everything";
  expected.shows = "All keys.";
  expected.columns = 5, expected.rows = 4, expected.spacing = 0.25;
  expected.particleMass = 0.2 * 1.0 * 0.75 / 20;
  expected.start = Start::Flat;
  expected.pins = {{"top", 0, 0}, {"corners", 0, 0}, {"", 2, 3}};
  expected.damping = Damping::Axial;
  expected.structural = {1200, 0.1}, expected.shear = {900, 0}, expected.bend = {0, 0.3};
  expected.gravity = {1, -2.5, 3}, expected.drag = 0.01;
  expected.displacements = {{{"bottom-left", 0, 0}, {0.1, 0, -1}}};
  expected.pushes = {{{"", 3, 2}, {0, 0, 2}, 0, 0.1}, {{"middle", 0, 0}, {1, 0, 0}, 0.5, 0}};
  expected.duration = 2, expected.integrator = "leapfrog", expected.dt = 0.002, expected.tolerance = 1e-6;
  expected.precision = Precision::Float;
  EXPECT_EQ(parseScene(kEverything, "everything.toml", methodNames()), expected);
}

TEST(Scene, WhatTheFileLeavesOutIsAnEmptyWorld) {
  const Scene scene = parseScene(kLeast, "least.toml");
  Scene expected;
  expected.name = "least.toml", expected.title = "Least", expected.integrator = "anything", expected.dt = 0.1;
  EXPECT_EQ(scene, expected);
  EXPECT_EQ(scene.gravity, (Vec3{0, -9.81, 0}));
  EXPECT_EQ(scene.tolerance, 1e-4);
  EXPECT_FALSE(scene.structural.present() || scene.shear.present() || scene.bend.present());
}

TEST(Scene, TheAreasMassIsSharedOutOverTheParticles) {
  const Scene scene = parseScene(kEverything, "everything.toml");
  const double area = 4 * 0.25 * 3 * 0.25;
  EXPECT_NEAR(scene.particleMass * 20, 0.2 * area, kRounding * 0.2 * area);
}

TEST(Scene, FilesFromOtherSystemsReadTheSame) {
  std::string text = "\xef\xbb\xbf";
  for (const char* c = kEverything; *c != 0; ++c) text += *c == '\n' ? "\r\n" : std::string(1, *c);
  EXPECT_EQ(parseScene(text, "everything.toml"), parseScene(kEverything, "everything.toml"));
}

TEST(Scene, FromAFileIsNamedByItsPath) {
  const Folder folder;
  const std::string path = folder.write("mine.toml", kEverything).string();
  EXPECT_EQ(loadScene(path, methodNames()), parseScene(kEverything, path));
}

TEST(BuiltinScenes, AllReadAndSayWhatTheyShow) {
  ASSERT_GE(builtinScenes().size(), 9U);
  for (const BuiltinScene& builtin : builtinScenes()) {
    const Scene scene = loadScene(std::string(builtin.name), methodNames());
    EXPECT_EQ(scene.name, builtin.name);
    EXPECT_FALSE(scene.title.empty()) << builtin.name;
    EXPECT_EQ(scene.shows.back(), '.') << builtin.name;
  }
}

TEST(BuiltinScenes, StandInOrderWithTheDefaultFirstAndFailuresLast) {
  const std::span<const BuiltinScene> scenes = builtinScenes();
  EXPECT_EQ(scenes.front().name, "curtain");
  const auto byName = [](const BuiltinScene& a, const BuiltinScene& b) { return a.name < b.name; };
  const auto failing = std::find_if(scenes.begin(), scenes.end(), showsFailure);
  EXPECT_TRUE(std::is_sorted(scenes.begin() + 1, failing, byName));
  EXPECT_TRUE(std::is_sorted(failing, scenes.end(), byName));
  EXPECT_TRUE(std::all_of(failing, scenes.end(), showsFailure));
  EXPECT_EQ(scenes.end() - failing, 6);
}

TEST(BuiltinScenes, TheStepOfEachIsWellInsideTheLimitsOfRk4AndSymplecticEuler) {
  constexpr double kRk4Share = 0.7;  // what a scene may use of rk4's reach
  for (const BuiltinScene& builtin : builtinScenes()) {
    if (showsFailure(builtin)) continue;
    const Scene scene = loadScene(std::string(builtin.name));
    // Closed form of the largest m w^2 of the lattice; 4 ks for a single row or column.
    const double ks = scene.structural.ks, kh = scene.shear.ks, kb = scene.bend.ks, k = kh + kb;
    const double along = k > 0 && ks <= 4 * k ? 2 * ks + 4 * k + ks * ks / (4 * k) : 4 * ks;
    const double across =
        kb > 0 && ks + kh <= 4 * kb ? 2 * (ks + kh) + 4 * kb + (ks + kh) * (ks + kh) / (4 * kb) : 4 * (ks + kh);
    const double w2 = std::max(along, across) / scene.particleMass;
    EXPECT_LE(scene.dt, kRk4Share * findMethod("rk4").stableStep(w2, 0)) << builtin.name;
    EXPECT_LT(scene.dt, findMethod("symplectic-euler").stableStep(w2, 0)) << builtin.name;
  }
}

TEST(BuiltinScenes, PokeIsTheCurtainAndAPush) {
  Scene poke = loadScene("poke");
  const Scene curtain = loadScene("curtain");
  EXPECT_EQ(poke.pushes, (std::vector<Push>{{{"middle", 0, 0}, {0, 0, 2}, 0.5, 0.1}}));
  poke.pushes.clear();
  poke.name = curtain.name, poke.title = curtain.title, poke.shows = curtain.shows;
  EXPECT_EQ(poke, curtain);
}

TEST(BuiltinScenes, StiffHasAHundredTimesTheCurtainsStiffness) {
  const Scene stiff = loadScene("stiff"), curtain = loadScene("curtain");
  EXPECT_EQ(stiff.structural.ks, 100 * curtain.structural.ks);
  EXPECT_EQ(stiff.shear.ks, 100 * curtain.shear.ks);
  EXPECT_EQ(stiff.bend.ks, 100 * curtain.bend.ks);
}

TEST(WithSheet, KeepsSizeMassDragStiffnessAndPushes) {
  const Scene before = parseScene(kEverything, "everything.toml");
  const Scene after = withSheet(before, 50, 40);
  EXPECT_EQ(after.columns, 50);
  EXPECT_EQ(after.rows, 40);
  EXPECT_NEAR(makeSheet(after).size(), makeSheet(before).size(), kRounding * makeSheet(before).size());
  EXPECT_NEAR(after.particleMass * 2000, before.particleMass * 20, kRounding * before.particleMass * 20);
  EXPECT_NEAR(after.drag * 2000, before.drag * 20, kRounding * before.drag * 20);
  EXPECT_EQ(after.structural, before.structural);
  EXPECT_EQ(after.pushes[0].force, before.pushes[0].force);
  EXPECT_EQ(after.pushes[1], before.pushes[1]);
}

TEST(WithSheet, ScalesNumberedPlacesAndRoundsThem) {
  Scene scene = parseScene(kEverything, "everything.toml");
  scene.displacements[0].particle = {"", 4, 3};
  const Scene finer = withSheet(scene, 9, 9);
  EXPECT_EQ(finer.pins[0].name, "top");
  EXPECT_EQ(finer.pins[2], (Place{"", 4, 8}));                    // [2, 3] of 5x4
  EXPECT_EQ(finer.pushes[0].particle, (Place{"", 6, 5}));         // [3, 2]: row 2/3 of 8 is 5.33
  EXPECT_EQ(finer.displacements[0].particle, (Place{"", 8, 8}));  // the far corner stays the far corner
}

TEST(WithSheet, FollowsTheLargerSideAndLeavesNoPlaceOutside) {
  const Scene column = withSheet(parseScene(kEverything, "everything.toml"), 1, 11);
  EXPECT_NEAR(column.spacing, 0.1, kRounding);
  EXPECT_NO_THROW((void)makeSheet(column));
  EXPECT_EQ(column.pushes[0].particle.column, 0);
}

TEST(WithSheet, OfTheSameGridChangesNothing) {
  const Scene scene = loadScene("flag");
  EXPECT_EQ(withSheet(scene, scene.columns, scene.rows), scene);
}

TEST(WithSheet, RefusesGridsThatAreNoneOrKeepNoSize) {
  const Scene scene = loadScene("curtain");
  EXPECT_THROW((void)withSheet(scene, 0, 5), InputError);
  EXPECT_THROW((void)withSheet(scene, 5, kLargestCount + 1), InputError);
  EXPECT_THROW((void)withSheet(scene, 1, 1), InputError);
  EXPECT_THROW((void)withSheet(parseScene(kLeast, "least.toml"), 2, 2), InputError);
}

}  // namespace
}  // namespace tyg::test
