// The same bits everywhere: every vector level, thread count, optimisation level and compiler gives the stored hashes.
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <vector>

#include "core/forces/row_kernel.h"
#include "golden_hashes.h"

namespace tyg {
namespace {

constexpr double kShortTime = 0.06;  // s: for the method whose steps cost twenty times as much as the others'

/// The vector levels of this machine and this build, all of which the one binary holds.
std::vector<VectorLevel> vectorLevels() {
  std::vector<VectorLevel> levels;
  for (int level = 0; level <= int(bestVectorLevel()); ++level) levels.push_back(VectorLevel(level));
  return levels;
}

class GoldenHashes : public testing::TestWithParam<VectorLevel> {
 protected:
  void SetUp() override { useVectorLevel(GetParam()); }
  void TearDown() override { useVectorLevel({}); }
};

TEST_P(GoldenHashes, HoldForEverySceneAndMethod) {
  const std::map<std::string, std::string> golden = goldenHashes();
  EXPECT_FALSE(golden.empty());
  for (const BuiltinScene& builtin : builtinScenes()) {
    const Scene scene = loadScene(std::string(builtin.name));
    for (const Method& method : methods()) {
      if (showsFailure(builtin) && method.name != scene.integrator) continue;  // its hash is that of the alarm
      if (!takes(method, scene)) continue;
      for (const Precision precision : {Precision::Float, Precision::Double}) {
        const std::string key =
            scene.name + " " + std::string(method.name) + (precision == Precision::Float ? " float" : " double");
        const double time = method.name == "backward-euler" ? kShortTime : kGoldenTime;
        const std::string hash = hashAfter(scene, method, precision, {.threads = 1}, time);
        const auto found = golden.find(key);
        EXPECT_TRUE(found != golden.end() && found->second == hash) << "golden line: " << key << " " << hash;
      }
    }
  }
}

std::string levelName(const testing::TestParamInfo<VectorLevel>& info) {
  constexpr std::array kNames{"Baseline", "V3", "V4"};
  return kNames[std::size_t(info.param)];
}

INSTANTIATE_TEST_SUITE_P(Levels, GoldenHashes, testing::ValuesIn(vectorLevels()), levelName);

// Sums of energies decide when the alarm goes. An odd number of columns leaves part of a vector over.
TEST(Determinism, EveryVectorLevelGivesTheSameEnergies) {
  const Scene scene = withSheet(loadScene("poke"), 37, 23);
  for (const Damping damping : {Damping::Relative, Damping::Axial}) {
    std::vector<std::array<double, 4>> energies;
    for (const VectorLevel level : vectorLevels()) {
      useVectorLevel(level);
      Scene damped = scene;
      damped.damping = damping, damped.drag = 0.01;
      Simulation simulation(damped, findMethod("leapfrog"), {.threads = 1, .ledger = true});
      simulation.advanceTo(0.1);
      const Ledger ledger = simulation.ledger();
      energies.push_back({ledger.kinetic, ledger.stored["elastic"], ledger.dissipated, ledger.maxStretch});
      EXPECT_EQ(energies.back(), energies.front()) << "level " << int(level);
    }
    EXPECT_GT(energies.front()[2], 0);
  }
  useVectorLevel({});
}

constexpr double kFewSteps = 0.12;  // s: 20 steps before the push begins, 40 after

TEST(Determinism, AnyNumberOfThreadsGivesTheSameBits) {
  const Scene scene = withSheet(loadScene("poke"), 37, 23);
  for (const Method& method : methods()) {
    const std::string expected = hashAfter(scene, method, Precision::Double, {.threads = 1}, kFewSteps);
    for (const int threads : {2, 3, 7}) {
      EXPECT_EQ(hashAfter(scene, method, Precision::Double, {.threads = threads}, kFewSteps), expected)
          << method.name << " " << threads;
    }
  }
}

TEST(Determinism, TheLookOfAClothIsNoPartOfItsState) {
  Scene scene = loadScene("tablecloth");
  scene.look = {};
  const std::string plain = hashAfter(scene, findMethod("leapfrog"), Precision::Double, {.threads = 1}, kFewSteps);
  scene.look = {.show = Show::Both, .colour = Vec3{1, 0, 0}, .image = "cloth.png"};
  scene.lamps = {{.at = Vec3{0, 1, 0}}};
  EXPECT_EQ(hashAfter(scene, findMethod("leapfrog"), Precision::Double, {.threads = 1}, kFewSteps), plain);
}

// With a ledger every evaluation is seen by itself; without one, methods that can fuse force, kick and drift.
TEST(Determinism, FusedPassesGiveTheBitsOfSingleSteps) {
  for (const int columns : {2, 20, 150}) {
    Scene scene = withSheet(loadScene("poke"), columns, 17);
    scene.drag = 0.01;
    scene.pushes.front().duration = 0.01;
    for (const Method& method : methods()) {
      if (columns > 20 && method.evaluationsPerStep != 1) continue;  // nothing of theirs is fused
      const std::string single = hashAfter(scene, method, Precision::Float, {.threads = 1, .ledger = true}, kFewSteps);
      for (const int threads : {1, 3}) {
        EXPECT_EQ(hashAfter(scene, method, Precision::Float, {.threads = threads}, kFewSteps), single)
            << method.name << " " << columns << " " << threads;
      }
    }
  }
}

}  // namespace
}  // namespace tyg
