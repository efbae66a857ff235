// Many steps in one call give the bits of as many single steps, whatever is fused inside.
#include <gtest/gtest.h>

#include "core/forces/row_kernel.h"
#include "core/simulation/integrator.h"
#include "test_systems.h"
#include "tyg/methods.h"

namespace tyg::test {
namespace {

/// The state after the same number of steps, in calls of `together` steps each.
template <class T>
State<T> after(const Scene& scene, const Method& method, int threads, int together, int calls) {
  constexpr double kStep = 1e-3;
  Bench<T> bench(scene, threads);
  Numbers numbers(51);
  Points start = bench.points();
  shake(bench, 0.2, numbers);
  Points shaken = bench.points();
  for (const int pin : bench.sheet.pins) {
    shaken.x[std::size_t(pin)] = start.x[std::size_t(pin)];
    shaken.v[std::size_t(pin)] = {};
  }
  bench.set(shaken);
  const auto integrator = method.make<T>(bench.scene, bench.sheet);
  for (int call = 0; call < calls; ++call)
    integrator->steps(bench.forces, bench.state, {0, call * together, kStep}, together);
  if (method.evaluationsPerStep >= 0) {
    EXPECT_EQ(bench.forces.evaluations(), method.evaluationsAtStart + together * calls * method.evaluationsPerStep)
        << method.name;
  }
  return bench.state;
}

template <class T>
void compareRandomScene(const Method& method, int columns, int rows, Numbers& numbers) {
  Scene scene = randomScene(columns, rows, numbers);
  scene.damping = Damping::Relative;  // which every method takes
  const std::uint64_t expected = hashOf(after<T>(scene, method, 1, 1, 32));
  EXPECT_EQ(hashOf(after<T>(scene, method, 1, 32, 1)), expected) << method.name << " " << columns << "x" << rows;
  EXPECT_EQ(hashOf(after<T>(scene, method, 2, 4, 8)), expected) << method.name << " " << columns << "x" << rows;
  EXPECT_EQ(hashOf(after<T>(scene, method, 3, 32, 1)), expected) << method.name << " " << columns << "x" << rows;
}

/// Backward Euler's solve would take most of the time, and it fuses nothing.
bool isSlow(const Method& method) { return method.name == "backward-euler"; }

template <class T>
void compareAllSheets() {
  Numbers numbers(61);
  for (const auto& [columns, rows] : {std::pair{1, 1}, {1, 7}, {19, 1}, {2, 2}, {5, 4}, {17, 9}, {35, 6}, {3, 40}}) {
    for (const Method& method : methods()) {
      if (!isSlow(method)) compareRandomScene<T>(method, columns, rows, numbers);
    }
  }
}

TEST(ManySteps, GiveTheBitsOfSingleStepsInDouble) { compareAllSheets<double>(); }
TEST(ManySteps, GiveTheBitsOfSingleStepsInFloat) { compareAllSheets<float>(); }

/// Pushes on the corners and in the middle, several on one particle, and one on a pin.
template <class T>
void push(Bench<T>& bench) {
  const int last = bench.sheet.count() - 1, middle = last / 2;
  bench.forces.addPush(last, {0.3, -0.2, 0.1});
  bench.forces.addPush(middle, {1, 2, 3});
  bench.forces.addPush(0, {1e-30, 0, -1});
  bench.forces.addPush(middle, {-0.1, 0.7, 1e-9});
  bench.forces.addPush(middle + (middle < last ? 1 : 0), {0.1, 0.1, 0.1});
  if (!bench.sheet.pins.empty()) bench.forces.addPush(bench.sheet.pins.front(), {5, 5, 5});
}

template <class T>
void comparePushes(const Method& method, int columns, int rows, Numbers& numbers) {
  constexpr double kStep = 1e-3;
  Scene scene = randomScene(columns, rows, numbers);
  scene.damping = Damping::Relative;
  Bench<T> single(scene);
  push(single);
  single.advance(method, 32 * kStep, 32);
  for (const VectorLevel level : {VectorLevel::Baseline, VectorLevel::V3, VectorLevel::V4}) {
    if (level > bestVectorLevel()) continue;
    useVectorLevel(level);
    for (const int threads : {1, 2, 3}) {
      Bench<T> together(scene, threads);
      push(together);
      const auto integrator = method.make<T>(scene, together.sheet);
      for (const int count : {1, 24, 7}) integrator->steps(together.forces, together.state, {0, 0, kStep}, count);
      EXPECT_EQ(hashOf(together.state), hashOf(single.state))
          << method.name << " " << columns << "x" << rows << ", level " << int(level) << ", " << threads << " threads";
    }
    useVectorLevel({});
  }
}

template <class T>
void compareAllPushes() {
  Numbers numbers(71);
  for (const auto& [columns, rows] : {std::pair{1, 1}, {2, 2}, {19, 1}, {17, 9}, {140, 5}, {3, 40}}) {
    for (const Method& method : methods()) {
      if (!isSlow(method)) comparePushes<T>(method, columns, rows, numbers);
    }
  }
}

TEST(ManySteps, SeeEveryPushInEveryStepInDouble) { compareAllPushes<double>(); }
TEST(ManySteps, SeeEveryPushInEveryStepInFloat) { compareAllPushes<float>(); }

TEST(ManySteps, AreFusedWhileAPushActs) {
  Bench<double> bench(softSheet(Damping::Relative));
  bench.forces.addPush(7, {1, 2, 3});
  EXPECT_TRUE(bench.forces.canAdvance());
}

TEST(ManySteps, ForgetPushesThatAreCleared) {
  Bench<double> pushed(softSheet(Damping::Relative)), plain(softSheet(Damping::Relative));
  push(pushed);
  pushed.forces.clearPushes();
  EXPECT_EQ(pushed.force(), plain.force());
}

TEST(ManySteps, FollowTheDissipationInEveryStep) {
  for (const Method& method : methods()) {
    Bench<double> bench(softSheet(Damping::Relative)), single(softSheet(Damping::Relative));
    bench.forces.trackDissipation(true);
    single.forces.trackDissipation(true);
    method.make<double>(bench.scene, bench.sheet)->steps(bench.forces, bench.state, {0, 0, 0.01}, 10);
    single.advance(method, 0.1, 10);
    EXPECT_EQ(bench.forces.energyOfPower().lost, single.forces.energyOfPower().lost) << method.name;
    EXPECT_GT(bench.forces.energyOfPower().lost, 0) << method.name;
  }
}

}  // namespace
}  // namespace tyg::test
