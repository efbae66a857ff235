// The reference against Boost.Odeint on a separately written list of springs, its own account of its error, and the
// twin's growth where it is known in closed form.
#include "study/motion/reference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/numeric/odeint.hpp>
#include <cmath>

#include "study/motion/error.h"
#include "test_systems.h"
#include "tyg/methods.h"

namespace tyg::test {
namespace {

Reference referenceOf(const Scene& scene) {
  return makeReference(scene, 1, [](double) { return true; });
}

/// x, y, z, vx, vy, vz of each particle.
using Numbers6 = std::vector<double>;

Points pointsOf(const Numbers6& numbers) {
  Points points;
  for (std::size_t k = 0; k < numbers.size(); k += 6) {
    points.x.push_back({numbers[k], numbers[k + 1], numbers[k + 2]});
    points.v.push_back({numbers[k + 3], numbers[k + 4], numbers[k + 5]});
  }
  return points;
}

/// Where Boost.Odeint's Fehlberg method of order 8 brings the oracle's springs.
std::vector<Vec3> byBoost(const Scene& scene, double seconds) {
  const Oracle oracle(scene);
  const Points start = Bench<double>(scene).points();
  Numbers6 state;
  for (const Vec3& at : start.x) state.insert(state.end(), {at.x, at.y, at.z, 0, 0, 0});
  const auto rate = [&](const Numbers6& now, Numbers6& change, double) {
    const Points points = pointsOf(now);
    const std::vector<Vec3> force = oracle.force(points);
    for (std::size_t i = 0; i < force.size(); ++i) {
      const Vec3 v = points.v[i], a = (1 / scene.particleMass) * force[i];
      const std::array<double, 6> all{v.x, v.y, v.z, a.x, a.y, a.z};
      std::copy(all.begin(), all.end(), change.begin() + static_cast<std::ptrdiff_t>(6 * i));
    }
  };
  namespace odeint = boost::numeric::odeint;
  const auto stepper = odeint::make_controlled<odeint::runge_kutta_fehlberg78<Numbers6>>(1e-13, 1e-13);
  odeint::integrate_adaptive(stepper, rate, state, 0.0, seconds, 1e-3);
  return pointsOf(state).x;
}

Scene smoothSheet() {
  Scene scene = softSheet(Damping::Relative);
  scene.duration = 1;
  return scene;
}

TEST(Reference, OneThatNeedNotBeSoExactCostsLessAndKnowsHowExactItIs) {
  const Reference full = referenceOf(smoothSheet());
  const Reference rough = makeReference(smoothSheet(), 1, [](double) { return true; },
                                        {.tolerance = 1e-6, .agreement = 1e-6, .motion = nullptr, .patience = 8});
  ASSERT_TRUE(rough.usable());
  EXPECT_LT(rough.motion.forceEvaluations, full.motion.forceEvaluations / 2);
  EXPECT_GT(rough.secondStep, 2 * full.secondStep);
  EXPECT_LE(rough.disagreement.back(), 1e-6);
  EXPECT_LE(motionError(rough.motion, full.motion).rms, rough.disagreement.back() + full.disagreement.back());
}

TEST(Reference, DoesNotRunAgainWhatItIsGiven) {
  const Reference full = referenceOf(smoothSheet());
  SampledMotion marked = full.motion;
  marked.forceEvaluations = -1;
  const ReferenceAim aim{.tolerance = full.scene.tolerance, .agreement = 0, .motion = &marked, .patience = 8};
  EXPECT_EQ(makeReference(
                smoothSheet(), 1, [](double) { return true; }, aim)
                .motion.forceEvaluations,
            -1);
  const ReferenceAim other{.tolerance = 1e-6,  // rougher than any reference
                           .agreement = 0,
                           .motion = &marked,
                           .patience = 8};
  EXPECT_GT(makeReference(
                smoothSheet(), 1, [](double) { return true; }, other)
                .motion.forceEvaluations,
            0);
}

TEST(Reference, AgreesWithAnotherLibraryOnASeparatelyWrittenListOfSprings) {
  constexpr double kFarBelowWhatIsCharted = 1e-11;  // of the size
  for (const Damping damping : {Damping::Relative, Damping::Axial}) {
    Scene scene = smoothSheet();
    scene.damping = damping;
    const Reference reference = referenceOf(scene);
    ASSERT_TRUE(reference.usable());
    const double apart = distanceBetween(reference.motion.positions.back(), byBoost(scene, scene.duration)).rms;
    EXPECT_LT(apart, kFarBelowWhatIsCharted * reference.size);
  }
}

TEST(Reference, KnowsThatItsTwoMethodsAgree) {
  const Reference reference = referenceOf(smoothSheet());
  EXPECT_LT(reference.disagreement.back(), 1e-12 * reference.size);
  EXPECT_GT(reference.disagreement.back(), 0) << "two different methods never give the same bits";
}

TEST(Reference, CanBeStopped) {
  const Reference reference = makeReference(smoothSheet(), 1, [](double) { return false; });
  EXPECT_TRUE(reference.stopped);
  EXPECT_FALSE(reference.usable());
}

TEST(Twin, StartsTheAskedDistanceAwayAndLeavesPinsAlone) {
  const Scene scene = smoothSheet(), twin = twinOf(scene, 1e-3);
  const std::vector<Vec3> here = sampledRun(scene, findMethod("rk4"), {1e-9}).positions[0];
  const std::vector<Vec3> there = sampledRun(twin, findMethod("rk4"), {1e-9}).positions[0];
  EXPECT_NEAR(distanceBetween(here, there).rms, 1e-3, 1e-9);
  EXPECT_EQ(here[0], there[0]);
  EXPECT_EQ(here[2], there[2]);
}

TEST(Amplification, OfAFallingSheetWithoutSpringsIsOne) {
  Scene scene = emptyWorld(4, 3);
  scene.gravity = {0, -9.81, 0};
  const Reference reference = referenceOf(scene);
  for (const double a : reference.amplification) EXPECT_NEAR(a, 1, 1e-5);  // rounding over the twin's distance
}

/// A weight on a stiff rod that stands upright on its pin.
Scene upright() {
  Scene scene = emptyWorld(1, 2);
  scene.pins = {{"bottom-left"}};
  scene.structural = {1e6, 100};
  scene.damping = Damping::Axial;  // the relative law would brake the fall as well
  scene.gravity = {0, -9.81, 0};
  scene.duration = 1.5;
  return scene;
}

TEST(Amplification, OfAnUprightPendulumIsTheHyperbolicCosine) {
  const Scene scene = upright();
  const Reference reference = referenceOf(scene);
  const Vec3 by = twinOf(scene, 1).displacements.at(0).by;  // along the rod it is soon damped away
  const double sideways = std::hypot(by.x, by.z) / length(by);
  for (const std::size_t k : {9U, 19U}) {
    const double t = reference.motion.times[k];
    EXPECT_NEAR(reference.amplification[k] / (sideways * std::cosh(std::sqrt(9.81) * t)), 1, 0.01) << t;
  }
}

TEST(Amplification, LeavesFloatNothingToShowWhereTheTwinIsLost) {
  Scene scene = upright();
  scene.duration = 8;  // cosh(25) is far more than a million
  const Reference reference = referenceOf(scene);
  EXPECT_LT(reference.amplification.front(), Reference::kTwinLost);
  EXPECT_GT(reference.amplification.back(), Reference::kTwinLost);
  EXPECT_GT(reference.floorOf(Precision::Float), 0.05 * reference.size);
}

/// One metre, three samples, and an amplification that falls again at the end.
Reference madeUp() {
  Reference reference;
  reference.size = 1;
  reference.motion.times = {1, 2, 3};
  reference.amplification = {0.5, 1000, 10};
  reference.disagreement = {1e-15, 2e-15, 5e-13};
  return reference;
}

TEST(Floor, IsRoundingAmplifiedOrTheDisagreementAndNeverFallsAgain) {
  const double unit = std::ldexp(1.0, -53), floatUnit = std::ldexp(1.0, -24);
  const Reference reference = madeUp();
  EXPECT_DOUBLE_EQ(reference.floorAt(0, Precision::Double), 1e-15);
  EXPECT_DOUBLE_EQ(reference.floorAt(1, Precision::Double), 1000 * unit);
  EXPECT_DOUBLE_EQ(reference.floorOf(Precision::Double), 5e-13);
  EXPECT_DOUBLE_EQ(reference.floorAt(0, Precision::Float), floatUnit);
  EXPECT_DOUBLE_EQ(reference.floorOf(Precision::Float), 1000 * floatUnit);
}

TEST(Horizon, IsTheLastTimeWhoseFloorIsBelowATenthOfTheError) {
  const Reference reference = madeUp();
  EXPECT_EQ(reference.horizonOf(6e-12, Precision::Double), 3);
  EXPECT_EQ(reference.horizonOf(4e-12, Precision::Double), 2);
  EXPECT_EQ(reference.horizonOf(1e-13, Precision::Double), 1);
  EXPECT_EQ(reference.horizonOf(1e-15, Precision::Double), 0);
  EXPECT_EQ(reference.horizonOf(1e-5, Precision::Float), 1);
}

}  // namespace
}  // namespace tyg::test
