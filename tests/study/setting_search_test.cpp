// The search for settings: how many runs it makes, how much it spends, and what it takes from earlier ones. Work is
// priced by the particle, not by a clock.
#include "study/advice/setting_search.h"

#include <gtest/gtest.h>

#include <cmath>

#include "study/diet/diet_changes.h"
#include "test_systems.h"
#include "tyg/methods.h"

namespace tyg::test {
namespace {

constexpr double kPerParticle = 3e-7;  // s, of an evaluation or a step

Scene small() {
  Scene scene = softSheet(Damping::Relative);
  scene.duration = 0.5;
  return scene;
}

double plainCost(const Scene& scene, int /*threads*/) { return kPerParticle * scene.columns * scene.rows; }

SampledMotion truthOf(Scene scene) {
  scene.tolerance = 1e-13;
  return sampledRun(scene, findMethod("dopri54"), sampleTimes(scene));
}

SearchPlan planOf(std::initializer_list<const char*> names) {
  SearchPlan plan;
  for (const char* name : names) plan.methods.push_back(&findMethod(name));
  plan.cost = plainCost;
  return plan;
}

SearchPlan planOfAll() {
  SearchPlan plan = planOf({});
  for (const Method& method : methods()) plan.methods.push_back(&method);
  return plan;
}

TEST(SettingSearch, NeverNamesTheMethodThatShowsAMistake) {
  const SampledMotion truth = truthOf(small());
  SettingSearch search(small(), planOf({"report-rk4"}));
  search.measureAgainst(truth, 0);
  EXPECT_FALSE(search.cheapestWithin(1));
  EXPECT_EQ(search.runs(), 0);
}

TEST(SettingSearch, ASearchThatWasMadeBeforeMakesNoRuns) {
  const SampledMotion truth = truthOf(small());
  const Scene scene = small();
  SettingSearch search(scene, planOf({"leapfrog", "rk4", "dopri54"}));
  search.measureAgainst(truth, 0);
  const auto first = search.cheapestWithin(1e-6);
  const int runs = search.runs();
  ASSERT_TRUE(first);
  EXPECT_EQ(search.cheapestWithin(1e-6)->scene, first->scene);
  EXPECT_EQ(search.runs(), runs);
  search.measureAgainst(truth, 1);  // all that was measured is in doubt
  EXPECT_EQ(search.cheapestWithin(1e-6)->scene, first->scene);
  EXPECT_GT(search.runs(), runs);
}

TEST(SettingSearch, MakesFewRunsWhateverIsAsked) {
  const SampledMotion truth = truthOf(small());
  const Scene scene = small();
  for (const double error : {1e-1, 1e-6, 1e-12, 1e-20}) {
    SettingSearch search(scene, planOfAll());
    search.measureAgainst(truth, 0);
    search.cheapestWithin(error);
    EXPECT_LT(search.runs(), 60) << error;
  }
  for (const double seconds : {1e-7, 1e-3, 3e-2, 1e3}) {
    SettingSearch search(scene, planOfAll());
    search.measureAgainst(truth, 0);
    search.mostExactWithin(seconds, 1e-13);
    EXPECT_LT(search.runs(), 60) << seconds;
  }
}

/// What one search may cost at most: its allowance, exceeded by one run of the kind that costs most.
double mostSpent(const SearchPlan& plan, const SettingSearch& search) {
  constexpr double kSlack = 1.1;  // runs are cut short within 64 steps
  return plan.allSeconds + kSlack * search.mostSeconds();
}

TEST(SettingSearch, SpendsNoMoreThanItIsAllowed) {
  const Scene scene = small();
  const SampledMotion truth = truthOf(scene);
  SearchPlan plan = planOfAll();
  plan.cost = [](const Scene& priced, int threads) { return 30 * plainCost(priced, threads); };  // a slow machine
  for (const double error : {1e-6, 1e-12, 1e-20}) {
    SettingSearch search(scene, plan);
    search.measureAgainst(truth, 0);
    search.cheapestWithin(error);
    EXPECT_LE(search.spent(), mostSpent(plan, search)) << error;
  }
}

TEST(SettingSearch, RoundingDoesNotKeepAnAdaptiveMethodInFloatForEver) {
  const Scene scene = small();
  const SampledMotion truth = truthOf(scene);
  SearchPlan plan = planOf({"bs32"});
  plan.precisions = {Precision::Float};
  SettingSearch search(scene, plan);
  search.measureAgainst(truth, 0);
  EXPECT_FALSE(search.cheapestWithin(2e-9));
  EXPECT_LE(search.spent(), mostSpent(plan, search));
  EXPECT_FALSE(search.cheapestWithin(1e-12)) << "less than float can tell";
}

TEST(SettingSearch, ABudgetIsKeptAndMoreOfItNeverBuysLess) {
  const Scene scene = small();
  const SampledMotion truth = truthOf(scene);
  SettingSearch search(scene, planOf({"symplectic-euler", "leapfrog", "rk4", "dopri54"}));
  search.measureAgainst(truth, 0);
  double before = std::numeric_limits<double>::infinity();
  for (const double seconds : {3e-3, 1e-2, 3e-2, 1e-1}) {
    const auto best = search.mostExactWithin(seconds, 1e-13);
    ASSERT_TRUE(best) << seconds;
    EXPECT_LE(best->seconds, seconds);
    EXPECT_LE(best->error, before);
    before = best->error;
  }
  EXPECT_LT(before, 1e-9);
}

Trial trialOf(double error, double seconds) {
  Trial trial;
  trial.error = error, trial.seconds = trial.wholeSeconds = seconds;
  return trial;
}

TEST(SettingCandidate, AimsByTheOrderOfItsMethod) {
  SettingCandidate candidate(small(), findMethod("rk4"), Precision::Double, 2.0);
  candidate.priceStep(1e-6);
  const double loosest = candidate.loosest();
  EXPECT_EQ(candidate.next(1e-8).parameter, loosest);
  constexpr double kAim = 0.8, kThird = 1.0 / 81;
  candidate.learn(loosest, trialOf(kAim * 1e-8 / kThird, 1));
  const SettingCandidate::Next next = candidate.next(1e-8);
  constexpr double kWholeSteps = 0.05;  // a whole number of steps fits between two samples
  EXPECT_NEAR(next.parameter / loosest, 1.0 / 3, kWholeSteps);
  EXPECT_NEAR(next.seconds, loosest / next.parameter, 1e-9) << "of a step's cost";
  candidate.learn(next.parameter, trialOf(0.2e-8, 3));
  EXPECT_GT(candidate.next(1e-8).parameter, next.parameter) << "between what is within and what is not";
}

TEST(SettingCandidate, GivesUpWhereRoundingIsWhatIsLeft) {
  SettingCandidate candidate(small(), findMethod("leapfrog"), Precision::Double, 0.025);
  candidate.priceStep(1e-6);
  const double step = candidate.loosest();
  candidate.learn(step, trialOf(1e-9, 1));
  EXPECT_GT(candidate.next(1e-12).parameter, 0);
  candidate.learn(step / 2, trialOf(0.95e-9, 2));
  EXPECT_EQ(candidate.next(1e-12).parameter, 0);
  EXPECT_TRUE(std::isinf(candidate.errorAt(step / 4)));
}

TEST(SampledRun, EndsWithin64StepsOfTheEvaluationsAllowed) {
  Scene scene = small();
  scene.dt = 1e-4;
  SamplingOptions options;
  options.mostEvaluations = 1000;
  const SampledMotion cut = sampledRun(scene, findMethod("leapfrog"), sampleTimes(scene), options);
  EXPECT_TRUE(cut.stopped);
  EXPECT_GE(cut.forceEvaluations, 1000);
  EXPECT_LE(cut.forceEvaluations, 1000 + 64);
  options.mostEvaluations = 1000000;
  EXPECT_FALSE(sampledRun(scene, findMethod("leapfrog"), sampleTimes(scene), options).stopped);
}

}  // namespace
}  // namespace tyg::test
