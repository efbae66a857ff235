// What studies do with bodies: changes that leave them out, grids and tolerances that keep to what they allow, notes.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/scene/bodies.h"
#include "study/advice/setting_candidate.h"
#include "study/diet/diet_changes.h"
#include "study/diet/idle_terms.h"
#include "study/limits/fast_contact.h"
#include "study/motion/refinement.h"
#include "study/motion/sampled_motion.h"
#include "study/motion/telling_moment.h"
#include "study/work/cost.h"
#include "study/work/ladder.h"
#include "test_systems.h"
#include "tyg/methods.h"
#include "tyg/simulation.h"

namespace tyg::test {
namespace {

/// A flat sheet of 9 x 9 above a ball that moves and a floor.
Scene aboveABall() {
  Scene scene = emptyWorld(9, 9);
  scene.spacing = 0.1, scene.particleMass = 0.01;
  scene.start = Start::Flat;
  scene.gravity = {0, -9.81, 0};
  scene.structural = {50, 0.05}, scene.shear = {30, 0.03}, scene.bend = {5, 0.01};
  scene.bodies = {{.shape = Shape::Ball, .at = {0.4, -0.25, 0.4}, .radius = 0.2, .name = "globe"},
                  {.shape = Shape::Plane, .at = {0, -0.5, 0}}};
  scene.moves = {{{}, {0.2, 0, 0}, 0.2, 0.2, "globe"}};
  scene.contact = {.friction = 0.4};
  fillContact(scene);
  scene.dt = 1e-3, scene.duration = 0.5;
  scene.tolerance = largestTolerance(scene);
  return scene;
}

std::vector<std::string> wordsOf(const Scene& scene) {
  std::vector<std::string> words;
  for (const Change& change : allChanges(scene)) {
    for (const Changed& changed : changesOf(scene, change)) words.push_back(changed.words);
  }
  return words;
}

Scene changedBy(const Scene& scene, const std::string& words) {
  for (const Change& change : allChanges(scene)) {
    for (const Changed& changed : changesOf(scene, change)) {
      if (changed.words == words) return changed.scene;
    }
  }
  ADD_FAILURE() << words;
  return scene;
}

TEST(ContactDiet, EqualBodiesHaveEachItsOwnNameAndAreLeftOutOneByOne) {
  Scene scene = aboveABall();
  scene.moves.clear();
  scene.bodies = {scene.bodies[1], scene.bodies[1], scene.bodies[0]};
  const std::vector<std::string> words = wordsOf(scene);
  for (const char* name : {"no plane 1", "no plane 2", "no globe"})
    EXPECT_EQ(std::ranges::count(words, name), 1) << name;
  std::vector<std::string> leftOut;
  for (const Change& change : allChanges(scene)) {
    if (change.kind != Change::OneBody) continue;
    const std::vector<Changed> changed = changesOf(scene, change);
    ASSERT_EQ(changed.size(), 1U);
    leftOut.push_back(changed[0].words), scene = changed[0].scene;
  }
  EXPECT_EQ(leftOut, (std::vector<std::string>{"no plane 1", "no plane 2", "no globe"}));
  EXPECT_TRUE(scene.bodies.empty());
}

TEST(ContactDiet, LeavesOutEachBodyWithItsMotionsFrictionAndDamping) {
  const Scene scene = aboveABall();
  const Scene noBall = changedBy(scene, "no globe"), noPlane = changedBy(scene, "no plane");
  ASSERT_EQ(noBall.bodies.size(), 1U);
  EXPECT_EQ(noBall.bodies[0].shape, Shape::Plane);
  EXPECT_TRUE(noBall.moves.empty());
  EXPECT_EQ(noBall.contact, scene.contact);
  EXPECT_EQ(noPlane.moves, scene.moves);
  EXPECT_EQ(changedBy(scene, "no friction").contact.friction, 0);
  EXPECT_EQ(changedBy(scene, "no contact damping").contact.damping, 0);
  const Scene none = changedBy(scene, "no contact");
  EXPECT_TRUE(none.bodies.empty() && none.moves.empty());
  EXPECT_EQ(none.contact, Contact{});
}

TEST(ContactDiet, TheLastBodyTakesTheContactWithIt) {
  const Scene last = changedBy(changedBy(aboveABall(), "no plane"), "no globe");
  EXPECT_TRUE(last.bodies.empty());
  EXPECT_EQ(last.contact, Contact{});
  const std::vector<std::string> words = wordsOf(withoutBody(aboveABall(), 1));
  EXPECT_EQ(std::ranges::count(words, "no contact"), 0) << "that is what leaving out the only body does";
}

TEST(ContactDiet, OfASceneWithoutBodiesHasNoChangeOfContact) {
  for (const std::string& words : wordsOf(withoutBodies(aboveABall()))) {
    for (const char* not_ : {"no globe", "no contact", "no friction", "no contact damping"}) EXPECT_NE(words, not_);
  }
}

TEST(ContactDiet, AGridThatIsTooCoarseForABodyIsNoChange) {
  Scene scene = aboveABall();
  EXPECT_EQ(changesOf(scene, {Change::HalfSheet}).size(), 1U) << "5 x 5 particles, 0.2 m apart: as large as the ball";
  scene.bodies[0].radius = 0.15;
  EXPECT_TRUE(changesOf(scene, {Change::HalfSheet}).empty());
}

TEST(ContactDiet, EveryChangeRuns) {
  for (const Change& change : allChanges(aboveABall())) {
    for (Changed& changed : changesOf(aboveABall(), change)) {
      changed.scene.duration = 0.02;
      Simulation simulation(changed.scene, findMethod(changed.scene.integrator));
      EXPECT_NO_THROW(simulation.advanceTo(0.02)) << changed.words;
    }
  }
}

TEST(ContactTolerances, OfLaddersAdviceAndDietsStayBelowAThousandthOfTheLayer) {
  Scene scene = aboveABall();
  const Method& method = findMethod("dopri54");
  const std::vector<Rung> ladder = ladderOf(scene, method);
  ASSERT_FALSE(ladder.empty());
  for (const Rung& rung : ladder) EXPECT_LE(rung.tolerance, scene.contact.layer / 1000);
  EXPECT_LT(ladder.size(), ladderOf(withoutBodies(scene), method).size());
  const SettingCandidate candidate(scene, method, Precision::Double, 0.05);
  EXPECT_LE(candidate.next(1).parameter, scene.contact.layer / 1000);
  scene.integrator = "dopri54";
  EXPECT_TRUE(changesOf(scene, {Change::Step}).empty());
  scene.tolerance /= 100;
  EXPECT_EQ(changesOf(scene, {Change::Step}).size(), 1U);
}

TEST(ContactRefinement, ComparesWithAFinerSheetOnTheSameBodies) {
  Scene scene = aboveABall();
  scene.duration = 0.2;
  const SampledMotion motion = sampledRun(scene, findMethod("rk4"), sampleTimes(scene));
  const auto distances = sheetDistances(scene, motion, {{17, 17}}, 1, [](double) { return true; });
  ASSERT_EQ(distances.size(), 1U);
}

TEST(ContactIdleTerms, ASceneThatTouchesHasNone) {
  EXPECT_TRUE(idleTerms(aboveABall()).empty()) << idleTerms(aboveABall()).front();
  Scene still = aboveABall();
  still.moves.clear();
  EXPECT_TRUE(idleTerms(still).empty()) << idleTerms(still).front();
}

TEST(ContactIdleTerms, ABallThatASheetFallsPastAndFrictionThatNeverActsAreNamed) {
  Scene scene = aboveABall();
  scene.moves.clear();
  scene.bodies = {{.shape = Shape::Ball, .at = {5, -0.25, 0.4}, .radius = 0.2, .name = "globe"}};
  const std::vector<std::string> idle = idleTerms(scene);
  ASSERT_EQ(idle.size(), 3U) << "springs, too, have nothing to do";
  EXPECT_EQ(idle[1].rfind("the globe:", 0), 0U) << idle[1];
  EXPECT_EQ(idle[2].rfind("friction:", 0), 0U) << idle[2];
  Simulation with(scene, findMethod("rk4")), without(withoutBodies(scene), findMethod("rk4"));
  with.advanceTo(0.5), without.advanceTo(0.5);
  EXPECT_EQ(with.hash(), without.hash());
}

/// Passed by the corner particles of a falling sheet, whose least distance to the body's surface is `clearance` m.
bool isToldToTouchNothing(Body body, double clearance) {
  Scene scene = aboveABall();
  scene.moves.clear();
  body.at.x += clearance;
  scene.bodies = {body};
  scene.contact.gap = 0;
  return idleTerms(scene).size() > 1;
}

/// A look now and then misses a body that the sheet grazes between two looks.
TEST(ContactIdleTerms, ABodyThatASheetGrazesIsTouched) {
  const Scene scene = aboveABall();
  const Sheet sheet = makeSheet(scene);
  const double edge = sheet.startPosition(scene.columns - 1).x, layer = scene.contact.layer, r = 0.2;
  for (double below = 0.1; below < 0.2; below += 0.0173) {
    const double y = sheet.startPosition(0).y - r - below;
    for (const Body& body :
         {Body{.shape = Shape::Ball, .at = {edge + r, y, 0.4}, .radius = r},
          Body{.shape = Shape::Capsule, .at = {edge + r, y, 0}, .axis = {0, 0, 0.8}, .radius = r},
          Body{.shape = Shape::Box, .at = {edge + 0.3, y, 0.4}, .half = {0.3, 0.2, 0.3}, .radius = r}}) {
      EXPECT_FALSE(isToldToTouchNothing(body, -0.01 * layer)) << nameOf(body.shape) << " " << below;
      EXPECT_FALSE(isToldToTouchNothing(body, 0.5 * layer)) << "not certain enough to say so";
      EXPECT_TRUE(isToldToTouchNothing(body, 1.5 * layer)) << nameOf(body.shape) << " " << below;
    }
  }
}

TEST(ContactIdleTerms, FrictionTooSmallToSeeAndMotionsOfBodiesWithoutSizeAreNamed) {
  Scene scene = aboveABall();
  scene.contact.friction = 1e-4;
  scene.moves[0].velocity = {};
  const std::vector<std::string> idle = idleTerms(scene);
  EXPECT_EQ(std::ranges::count_if(idle, [](const std::string& it) { return it.rfind("friction:", 0) == 0; }), 1);
  EXPECT_EQ(std::ranges::count_if(idle, [](const std::string& it) { return it.rfind("move 1", 0) == 0; }), 1);
}

TEST(ContactSpeed, IsFollowedWhereThereAreBodiesAndGoesBackWithACheckpoint) {
  Scene scene = aboveABall();
  Simulation simulation(scene, findMethod("rk4")), free(withoutBodies(scene), findMethod("rk4"));
  EXPECT_EQ(simulation.largestSpeed(), 0);
  const Snapshot start = simulation.save();
  simulation.advanceTo(0.1), free.advanceTo(0.1);
  EXPECT_NEAR(simulation.largestSpeed(), 0.981, 0.05) << "what has fallen for a tenth of a second";
  EXPECT_EQ(free.largestSpeed(), 0);
  simulation.restore(start);
  EXPECT_EQ(simulation.largestSpeed(), 0);
  simulation.advanceTo(0.21);
  EXPECT_GT(simulation.largestSpeed(), 0.2) << "the ball moves";
}

TEST(ContactSpeed, AStepThatCrossesMoreThanAThirdOfTheLayerIsTold) {
  Scene scene = aboveABall();
  scene.moves.clear();
  const auto noteAt = [&](double step, const char* method) {
    scene.dt = step;
    Simulation simulation(scene, findMethod(method));
    simulation.advanceTo(0.1);
    return fastContactNote(simulation);
  };
  // 1 m/s and a layer of 5 mm: a third of it in 1.7 ms.
  EXPECT_EQ(noteAt(1e-3, "rk4"), "");
  EXPECT_NE(noteAt(2.5e-3, "rk4").find("of the layer of contact"), std::string::npos);
  EXPECT_EQ(noteAt(1.7e-3, "rk4").find("take steps of 1.7 ms"), std::string::npos) << "it takes them already";
  EXPECT_EQ(noteAt(2.5e-3, "dopri54"), "") << "it chooses its own steps";
  scene = withoutBodies(scene);
  EXPECT_EQ(noteAt(2.5e-3, "rk4"), "");
}

TEST(ContactCost, CountsEachBody) {
  const Scene both = aboveABall(), one = withoutBody(both, 0), none = withoutBodies(both);
  EXPECT_GT(countedCost(both), countedCost(one));
  EXPECT_GT(countedCost(one), countedCost(none));
}

TEST(ContactTellingMoment, OfAFallIsWhenTheClothHasArrived) {
  Scene scene = aboveABall();
  EXPECT_DOUBLE_EQ(tellingMoment(scene), 0.4) << "the end of the first motion";
  scene.moves.clear();
  scene.duration = 3;
  EXPECT_DOUBLE_EQ(tellingMoment(scene), 1);
  EXPECT_DOUBLE_EQ(tellingMoment(withoutBodies(scene)), 0.45);
}

}  // namespace
}  // namespace tyg::test
