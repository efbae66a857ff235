// The table of force terms: what each says of itself is true of the forces.
#include "core/forces/term.h"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "test_systems.h"

namespace tyg::test {
namespace {

/// A sheet with one term alone, all of whose parameters are set.
Scene sceneWith(const ForceTerm& term) {
  Scene scene = emptyWorld(5, 4);
  scene.pins = {{"top-left"}};
  if (term.hold != nullptr) scene.bodies = bodiesOfEveryShape();
  double value = 0.5;
  for (const Parameter& parameter : term.parameters) {
    if (parameter.ofList && term.hold != nullptr) continue;  // bodies that the sheet touches as they are
    parameter.set(scene, parameter.count == 1 ? Vec3{value, 0, 0} : Vec3{value, -value, 2 * value});
    value *= 2;
  }
  return scene;
}

TEST(Terms, AreInASceneUntilTheyAreLeftOut) {
  for (const ForceTerm* term : forceTerms()) {
    Scene scene = sceneWith(*term);
    for (const ForceTerm* other : forceTerms()) EXPECT_EQ(hasTerm(scene, *other), other == term) << other->name;
    leaveOut(scene, *term);
    EXPECT_FALSE(hasTerm(scene, *term)) << term->name;
    Bench<double> bench(scene);
    Numbers numbers(17);
    shake(bench, 0.3, numbers);
    for (const Vec3& force : bench.force()) EXPECT_EQ(length(force), 0) << term->name;
  }
}

TEST(Terms, StoreOrTakeAllOfTheirPower) {
  constexpr double kStep = 1e-6;       // s: rounding of E / step and step^2 are then both far below
  constexpr double kTolerance = 1e-7;  // of the largest power here
  for (const ForceTerm* term : forceTerms()) {
    Bench<double> bench(sceneWith(*term));
    Numbers numbers(23);
    shake(bench, 0.3, numbers);
    bench.state.velocity.set(0, {});  // the pinned one
    const std::vector<Vec3> force = bench.force();
    double power = 0, scale = 0;
    for (int i = 0; i < bench.sheet.count(); ++i) {
      power += dot(force[std::size_t(i)], bench.state.velocity.get(i));
      scale += length(force[std::size_t(i)]) * length(bench.state.velocity.get(i));
    }
    const auto stored = [&](double seconds) {
      State<double> state = bench.state;
      for (int i = 0; i < bench.sheet.count(); ++i) {
        state.position.set(i, state.position.get(i) + seconds * state.velocity.get(i));
      }
      const StoredEnergy energy = bench.forces.energy(0, state);
      return energy.sum() - energy.kinetic;
    };
    const double storing = (stored(kStep) - stored(-kStep)) / (2 * kStep);
    const Power passing = bench.forces.powerOf(0, bench.state.position, bench.state.velocity);
    const double taken = passing.lost - std::accumulate(passing.supplied.begin(), passing.supplied.end(), 0.0);
    EXPECT_GT(scale, 0.01) << term->name;
    EXPECT_NEAR(power + storing + taken, 0, kTolerance * scale) << term->name;
  }
}

TEST(Terms, OfACutSheetStoreOrTakeAllOfTheirPower) {
  Numbers numbers(41);
  for (int draw = 0; draw < 40; ++draw) {
    Scene scene = randomScene(19, 7, numbers);
    scene.air = {1.2, 1.2}, scene.winds = {{.velocity = {1, 2, 3}}};
    Bench<double> bench(scene);
    Sheet cut = bench.sheet;
    cut.missing = cut.missing.withCut(19, 7, {numbers.between(-1, 19), numbers.between(-1, 7), 9.5, 3.5});
    bench.forces.useSheet(cut);
    shake(bench, 0.3, numbers);
    for (const int pin : cut.pins) bench.state.velocity.set(pin, {});
    const std::vector<Vec3> force = bench.force();
    double power = 0, scale = 0;
    for (int i = 0; i < cut.count(); ++i) {
      power += dot(force[std::size_t(i)], bench.state.velocity.get(i));
      scale += length(force[std::size_t(i)]) * length(bench.state.velocity.get(i));
    }
    const auto stored = [&](double seconds) {
      State<double> state = bench.state;
      for (int i = 0; i < cut.count(); ++i) {
        state.position.set(i, state.position.get(i) + seconds * state.velocity.get(i));
      }
      const StoredEnergy energy = bench.forces.energy(0, state);
      return energy.sum() - energy.kinetic;
    };
    constexpr double kStep = 1e-6;
    const double storing = (stored(kStep) - stored(-kStep)) / (2 * kStep);
    const Power passing = bench.forces.powerOf(0, bench.state.position, bench.state.velocity);
    const double taken = passing.lost - std::accumulate(passing.supplied.begin(), passing.supplied.end(), 0.0);
    EXPECT_NEAR(power + storing + taken, 0, 1e-6 * scale) << draw;
  }
}

TEST(Terms, ResistEveryMotionAlikeByTheDampingThatTheySay) {
  for (const ForceTerm* term : forceTerms()) {
    if (term->particleDamping == nullptr) continue;
    Bench<double> bench(sceneWith(*term));
    const Vec3 v{1, -2, 3};
    const Vec3 atRest = bench.force()[7];
    bench.state.velocity.set(7, v);
    const Vec3 resistance = atRest - bench.force()[7];
    EXPECT_LE(length(resistance - term->particleDamping(bench.scene) * v), 1e-14) << term->name;
  }
}

TEST(Terms, WithoutDampingTakeNothing) {
  Scene scene = softSheet(Damping::Relative);
  EXPECT_TRUE(isDamped(scene));
  EXPECT_GT(particleDamping(scene), 0);
  EXPECT_EQ(particleDamping(withoutParticleDamping(scene)), 0);
  EXPECT_TRUE(isDamped(withoutParticleDamping(scene)));
  EXPECT_EQ(particleDamping(withoutSpringDamping(scene)), particleDamping(scene));
  Bench<double> bench(withoutDamping(scene));
  Numbers numbers(29);
  shake(bench, 0.3, numbers);
  EXPECT_FALSE(isDamped(bench.scene));
  EXPECT_EQ(bench.forces.powerOf(0, bench.state.position, bench.state.velocity).lost, 0);
}

TEST(LiveParameters, HaveAKeyEachAndKeepTheirValues) {
  std::set<std::string_view> keys;
  for (const Parameter& parameter : liveParameters()) {
    EXPECT_TRUE(keys.insert(parameter.key).second) << parameter.key;
    EXPECT_EQ(findParameter(parameter.key), &parameter);
    Scene scene;
    scene.bodies.resize(6);
    const Vec3 value = parameter.count == 1 ? Vec3{3, 0, 0} : Vec3{1, 2, 3};
    parameter.set(scene, value);
    EXPECT_EQ(parameter.get(scene), value) << parameter.key;
  }
  EXPECT_EQ(findParameter("springs.shear"), nullptr);
}

TEST(LiveParameters, OfForceTermsHaveARangeAndDigitsForPanels) {
  for (const ForceTerm* term : forceTerms()) {
    for (const Parameter& parameter : term->parameters) {
      EXPECT_GT(parameter.mostByHand, 0) << parameter.key;
      EXPECT_GT(parameter.digits, 0) << parameter.key;
    }
  }
}

TEST(LiveParameters, SetInPlaceGiveTheForcesOfANewScene) {
  Numbers numbers(37);
  for (int draw = 0; draw < 30; ++draw) {
    Bench<float> changed(randomScene(9, 7, numbers));
    Scene now = randomScene(9, 7, numbers);
    now.spacing = changed.scene.spacing, now.particleMass = changed.scene.particleMass;
    now.start = changed.scene.start, now.pins = changed.scene.pins;
    Bench<float> made(now);
    shake(changed, 0.3, numbers);
    made.state = changed.state;
    changed.forces.useParameters(now);
    EXPECT_EQ(changed.force(), made.force());
    EXPECT_EQ(changed.forces.powerOf(0, made.state.position, made.state.velocity).lost,
              made.forces.powerOf(0, made.state.position, made.state.velocity).lost);
    EXPECT_EQ(changed.forces.energy(0, made.state).stored, made.forces.energy(0, made.state).stored);
  }
}

}  // namespace
}  // namespace tyg::test
