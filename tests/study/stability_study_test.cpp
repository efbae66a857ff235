// Measured step limits against predicted ones, and what a study of them is written as.
#include "study/limits/stability_study.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "integrators/stable_step.h"
#include "study/charts/stability_chart.h"
#include "study/limits/measured_limit.h"
#include "study/limits/stability_region.h"
#include "test_systems.h"
#include "tyg/methods.h"
#include "tyg/simulation.h"

namespace tyg::test {
namespace {

Scene smallCloth(double kd) {
  Scene scene = withSheet(loadScene("curtain"), 6, 5);
  scene.structural.kd = scene.shear.kd = scene.bend.kd = kd;
  return scene;
}

/// The largest step that held around rest, from the prediction on.
double measuredAtRest(const Scene& scene, const Method& method, double predicted) {
  MeasurePlan plan;
  plan.begin = predicted;
  plan.steps = StabilityPlan::kSteps;
  return measuredLimit(linearRegime(scene), method, plan);
}

TEST(MeasuredLimit, IsNeverBelowThePredictedOneAndAtMostTwoPercentAbove) {
  constexpr double kAbove = 0.02;
  Numbers numbers(17);
  for (const char* name : {"symplectic-euler", "leapfrog", "rk4", "bs32"}) {
    for (const double kd : {0.0, numbers.between(0.02, 0.3)}) {
      const Scene scene = smallCloth(kd);
      const Method& method = findMethod(name);
      const double predicted = stepLimit(scene, method).predicted, measured = measuredAtRest(scene, method, predicted);
      EXPECT_GE(measured, predicted) << name << " kd " << kd;
      EXPECT_LE(measured, (1 + kAbove) * predicted) << name << " kd " << kd;
    }
  }
}

TEST(MeasuredLimit, FollowsDampingThatRules) {
  constexpr double kAbove = 0.02;
  const Scene scene = smallCloth(10);
  for (const char* name : {"symplectic-euler", "leapfrog", "rk4"}) {
    const Method& method = findMethod(name);
    const double predicted = stepLimit(scene, method).predicted, measured = measuredAtRest(scene, method, predicted);
    EXPECT_GE(measured, predicted) << name;
    EXPECT_LE(measured, (1 + kAbove) * predicted) << name;
  }
}

TEST(MeasuredLimit, IsFoundFromFarBelowAndFromFarAbove) {
  const Scene scene = linearRegime(smallCloth(0.1));
  const Method& method = findMethod("leapfrog");
  const double limit = stepLimit(scene, method).predicted;
  for (const double factor : {0.3, 3.0}) {
    MeasurePlan plan;
    plan.begin = factor * limit;
    plan.steps = 500;
    EXPECT_NEAR(measuredLimit(scene, method, plan) / limit, 1, 0.01) << factor;
  }
}

TEST(MeasuredLimit, OfUndampedExplicitEulerShrinksWithTheTimeItHasToSurvive) {
  const Scene scene = linearRegime(smallCloth(0));
  const Method& method = findMethod("explicit-euler");
  const double w2 = stepLimit(scene, method).mode.w2;
  const auto survived = [&](long long steps) {
    MeasurePlan plan;
    plan.begin = 1e-3;
    plan.steps = steps;
    return measuredLimit(scene, method, plan);
  };
  const double few = survived(500), many = survived(8000);
  // Both end at the same growth, so that h^2 w^2 n stays: 16 times the steps, a quarter of the step.
  EXPECT_NEAR(few / many, 4, 0.4);
  EXPECT_NEAR(survivedStep(w2, 500 * few, 1e3) / few, 1, 0.5);
}

TEST(MeasuredLimit, IsInfiniteWhereNothingFailsAndUnknownWhereItWouldTakeTooLong) {
  MeasurePlan plan;
  plan.begin = 1e-3;
  plan.steps = 200;
  EXPECT_TRUE(std::isinf(measuredLimit(linearRegime(smallCloth(0.1)), findMethod("backward-euler"), plan)));
  plan.mostWork = 1;
  EXPECT_TRUE(std::isnan(measuredLimit(smallCloth(0.1), findMethod("rk4"), plan)));
}

TEST(LinearRegime, HoldsTheSheetAtRestButForATenthOfAPerMilleAndKeepsItsSprings) {
  const Scene scene = linearRegime(loadScene("poke"));
  EXPECT_EQ(scene.gravity, Vec3{});
  EXPECT_TRUE(scene.pushes.empty());
  EXPECT_EQ(scene.structural, loadScene("poke").structural);
  Simulation simulation(scene, findMethod("rk4"));
  EXPECT_LT(simulation.ledger().maxStretch, 1e-3);
  EXPECT_GT(simulation.ledger().stored["elastic"], 0);
}

StabilityStudy studied(const char* names) {
  StabilityPlan plan;
  for (const Method& method : methods()) {
    if (std::string_view(names).find(method.name) != std::string_view::npos) plan.methods.push_back(&method);
  }
  Scene scene = smallCloth(0.1);
  scene.duration = 0.3;
  return studyStability(scene, plan);
}

TEST(StabilityStudy, HasEveryMethodWithDampingAndWithout) {
  const StabilityStudy study = studied("leapfrog xpbd");
  ASSERT_EQ(study.cases.size(), 4U);
  EXPECT_TRUE(study.cases[0].damped);
  EXPECT_FALSE(study.cases[1].damped);
  EXPECT_LT(study.cases[0].limit.predicted, study.cases[1].limit.predicted);
  EXPECT_GT(study.cases[0].atRest, 0);
  EXPECT_GE(study.cases[0].inMotion, 0.99 * study.cases[0].limit.certified);
  EXPECT_TRUE(std::isnan(study.cases[2].limit.predicted));
}

TEST(StabilityStudy, LeavesOutMethodsThatRefuseTheSceneAndSaysSo) {
  Scene scene = smallCloth(0.1);
  scene.damping = Damping::Axial;
  const Method* imex = &findMethod("imex");
  StabilityPlan plan;
  plan.methods = {imex};
  const StabilityStudy study = studyStability(scene, plan);
  EXPECT_TRUE(study.cases.empty() || !study.cases[0].damped);
  ASSERT_FALSE(study.refusals.empty());
  EXPECT_NE(stabilityTable(study).find("axial"), std::string::npos);
}

TEST(StabilityStudy, SaysWhyNoStepIsCertifiedInAir) {
  Scene scene = smallCloth(0.1);
  scene.duration = 0.05;
  scene.air.density = 1.2;
  StabilityPlan plan;
  plan.methods = {&findMethod("leapfrog")};
  const std::string still = stabilityTable(studyStability(scene, plan));
  EXPECT_NE(still.find("certified: none with air: a stretched cell catches more of it."), std::string::npos) << still;
  EXPECT_EQ(still.find("Around rest was"), std::string::npos);
  scene.winds = {{.velocity = {0, 0, 2}}};
  const StabilityStudy windy = studyStability(scene, plan);
  EXPECT_TRUE(std::isnan(windy.cases[0].limit.certified));
  std::string table = stabilityTable(windy);
  std::erase(table, '\n');
  EXPECT_NE(table.find("Around rest was measured"), std::string::npos) << table;
}

TEST(StabilityStudy, StopsWhereItsObserverSaysSo) {
  StabilityPlan plan;
  plan.methods = {&findMethod("leapfrog")};
  plan.observer = [](double) { return false; };
  EXPECT_TRUE(studyStability(smallCloth(0.1), plan).stopped);
}

TEST(StabilityStudy, IsWrittenAsTheAgreedColumns) {
  const std::string csv = stabilityCsv(studied("leapfrog backward-euler"));
  EXPECT_EQ(csv.rfind("scene,integrator,damping,predicted_dt,certified_dt,measured_dt,first_mode\n", 0), 0U);
  EXPECT_EQ(std::ranges::count(csv, '\n'), 9);
  for (const char* part : {"\ncurtain at rest,leapfrog,scene,0.0", "\ncurtain,leapfrog,none,0.0",
                           "\ncurtain,backward-euler,none,,,,none\n", "in plane by stiffness q=("}) {
    EXPECT_NE(csv.find(part), std::string::npos) << part << " is not in\n" << csv;
  }
}

TEST(StabilityStudy, IsATableOfAtMostAHundredColumnsThatExplainsWhatHasNoLimit) {
  std::istringstream lines(stabilityTable(studied("explicit-euler backward-euler bs32")));
  std::string table;  // in one line: sentences are broken anywhere
  for (std::string line; std::getline(lines, line);) {
    EXPECT_LE(line.size(), 100U) << line;
    table += " " + line.substr(std::min(line.size(), line.find_first_not_of(' ')));
  }
  for (const char* part :
       {"2 ln(G) / (w^2 T)", "backward-euler has no limit: ", "bs32: the limits are those of fixed"}) {
    EXPECT_NE(table.find(part), std::string::npos) << part << " is not in\n" << table;
  }
}

TEST(StabilityRegion, MeetsTheAxesWhereTheMethodsAreKnownTo) {
  const Scene scene = smallCloth(0.1);
  const StabilityRegion rk4 = regionOf(findMethod("rk4"), scene, scene.dt);
  EXPECT_NEAR(rk4.edge.front().imag(), 2.8284, 1e-3);
  EXPECT_NEAR(rk4.onRealAxis, 2.7853, 1e-3);
  EXPECT_NEAR(regionOf(findMethod("leapfrog"), scene, scene.dt).onRealAxis, 1, 1e-6);
  EXPECT_NEAR(regionOf(findMethod("symplectic-euler"), scene, scene.dt).edge.front().imag(), 2, 1e-6);
  EXPECT_TRUE(std::isinf(regionOf(findMethod("imex"), scene, scene.dt).onRealAxis));
  EXPECT_TRUE(regionOf(findMethod("xpbd"), scene, scene.dt).edge.empty());
  EXPECT_GE(regionOf(findMethod("rkc2"), scene, scene.dt).stages.count, 2);
}

TEST(StabilityRegion, HoldsTheScenesRootsBelowTheLimitAndNotAllAboveIt) {
  const Scene scene = smallCloth(0.1);
  const std::vector<std::complex<double>> roots = sceneRoots(scene);
  for (const char* name : {"symplectic-euler", "leapfrog", "rk4", "bs32"}) {
    const Method& method = findMethod(name);
    const double limit = stepLimit(scene, method).predicted;
    const auto growing = [&](double h) {
      const StabilityRegion region = regionOf(method, scene, h);
      return std::ranges::count_if(roots, [&](const auto& mu) { return !holdsAt(method, region, mu, h); });
    };
    EXPECT_EQ(growing(0.99 * limit), 0) << name;
    EXPECT_GT(growing(1.02 * limit), 0) << name;
  }
}

TEST(StabilityStudy, SaysARefusalOnceAndQuotesASceneWhoseNameHoldsAComma) {
  Scene scene = smallCloth(0.1);
  scene.name = "a,x";
  StabilityPlan plan;
  plan.methods = {&findMethod("xpbd")};
  EXPECT_NE(stabilityCsv(studyStability(scene, plan)).find("\n\"a,x\",xpbd,scene"), std::string::npos);
  scene.damping = Damping::Axial;
  scene.structural.kd = 0.1;
  plan.methods = {&findMethod("imex"), &findMethod("imex")};
  EXPECT_EQ(studyStability(scene, plan).refusals.size(), 1U);
}

TEST(StabilityScript, OfMethodsWithoutALimitPlotsNoLimits) {
  const std::string script = stabilityScript(studied("xpbd"));
  EXPECT_EQ(script.find("plot $limits"), std::string::npos);
  EXPECT_NE(script.find("no step is known beyond which"), std::string::npos);
}

TEST(StabilityScript, HasAPanelForEveryMethodWithARegion) {
  const std::string script = stabilityScript(studied("leapfrog rk4 xpbd"));
  for (const char* part : {"$region0", "$region1", "\"leapfrog, undamped\"", "set terminal svg", "pngcairo"}) {
    EXPECT_NE(script.find(part), std::string::npos) << part;
  }
  EXPECT_EQ(script.find("$region2"), std::string::npos);
}

}  // namespace
}  // namespace tyg::test
