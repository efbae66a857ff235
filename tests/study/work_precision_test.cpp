// The study of speed against accuracy on a small sheet, with a clock that only counts how often it is asked.
#include "study/work/work_precision.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "test_systems.h"
#include "tyg/methods.h"

namespace tyg::test {
namespace {

constexpr double kTick = 1e-3;  // s a look at the clock: it is looked at every 64 steps

Scene smoothSheet() {
  Scene scene = softSheet(Damping::Relative);
  scene.duration = 1;
  return scene;
}

Reference referenceOf(const Scene& scene) {
  return makeReference(scene, 1, [](double) { return true; });
}

StudyPlan planOf(const std::vector<std::string>& names) {
  StudyPlan plan;
  for (const std::string& name : names) plan.methods.push_back(&findMethod(name));
  plan.runBudget = 60 * kTick;  // some thousand steps
  plan.fewestRepeats = 1;
  plan.repeatSeconds = 0;
  plan.threads = 1;
  plan.clock = [now = 0.0]() mutable { return now += kTick; };
  return plan;
}

Study studyOf(const Scene& scene, const StudyPlan& plan) { return workPrecision(scene, referenceOf(scene), plan); }

std::vector<WorkRow> rowsOf(const Study& study, const std::string& method, Precision precision, RowStatus status) {
  std::vector<WorkRow> rows;
  for (const WorkRow& row : study.rows) {
    if (row.integrator == method && row.precision == precision && row.status == status) rows.push_back(row);
  }
  return rows;
}

TEST(WorkPrecision, TheOrderOfEveryFixedStepMethodCanBeReadOffItsRows) {
  constexpr double kOrderTolerance = 0.2;  // both neighbouring orders are excluded by far
  std::vector<std::string> names;
  for (const Method& method : methods()) {
    if (!method.adaptive) names.emplace_back(method.name);
  }
  StudyPlan plan = planOf(names);
  plan.precisions = {Precision::Double};
  const Study study = studyOf(smoothSheet(), plan);
  for (const std::string& name : names) {
    const std::vector<WorkRow> rows = rowsOf(study, name, Precision::Double, RowStatus::Ok);
    ASSERT_GE(rows.size(), 5U) << name;
    std::size_t k = rows.size() - 1;
    while (k > 1 && rows[k].rmsError < 100 * rows[k].floor) --k;  // above what rounding blurs
    const double order = std::log(rows[k - 1].rmsError / rows[k].rmsError) / std::log(rows[k - 1].dt / rows[k].dt);
    EXPECT_NEAR(order, findMethod(name).order, kOrderTolerance) << name;
  }
}

TEST(WorkPrecision, AnAdaptiveMethodsErrorFallsWithItsTolerance) {
  const Study study = studyOf(smoothSheet(), planOf({"bs32", "dopri54"}));
  for (const char* name : {"bs32", "dopri54"}) {
    const std::vector<WorkRow> rows = rowsOf(study, name, Precision::Double, RowStatus::Ok);
    ASSERT_GE(rows.size(), 4U) << name;
    EXPECT_DOUBLE_EQ(rows[0].tolerance / rows[1].tolerance, 10) << name;
    EXPECT_LT(rows.back().rmsError, 1e-4 * rows.front().rmsError) << name;
    EXPECT_GT(rows.back().forceEvaluations, rows.front().forceEvaluations) << name;
  }
}

TEST(WorkPrecision, ALadderBeginsPastTheLimitAndKeepsWhatFailed) {
  Scene scene = smoothSheet();
  scene.structural.ks = 1e4;  // a limit well below the time between samples
  const Study study = studyOf(scene, planOf({"leapfrog"}));
  const std::vector<WorkRow> failed = rowsOf(study, "leapfrog", Precision::Double, RowStatus::Unstable);
  const std::vector<WorkRow> good = rowsOf(study, "leapfrog", Precision::Double, RowStatus::Ok);
  ASSERT_FALSE(failed.empty());
  ASSERT_FALSE(good.empty());
  EXPECT_GT(failed.front().dt, good.front().dt);
  EXPECT_TRUE(std::isnan(failed.front().rmsError));
  EXPECT_GT(failed.front().forceEvaluations, 0);
}

TEST(WorkPrecision, FloatStopsAtItsFloorAndDoubleGoesOn) {
  const Study study = studyOf(smoothSheet(), planOf({"rk4"}));
  const auto least = [&](Precision precision) {
    double error = 1;
    for (const WorkRow& row : rowsOf(study, "rk4", precision, RowStatus::Ok)) error = std::min(error, row.rmsError);
    return error;
  };
  const double size = makeSheet(smoothSheet()).size();
  EXPECT_GT(least(Precision::Float), 1e-9 * size);
  EXPECT_LT(least(Precision::Float), 1e-5 * size);
  EXPECT_LT(least(Precision::Double), 1e-11 * size);
  EXPECT_FALSE(rowsOf(study, "rk4", Precision::Float, RowStatus::Ok).back().trusted(1)) << "too near its floor";
}

/// Explicit Euler holds with steps far smaller than those of other methods.
TEST(WorkPrecision, UntilTwoRunsOfAMethodHaveHeldARunMayTakeSomewhatLonger) {
  StudyPlan plan = planOf({"explicit-euler"});
  const std::vector<WorkRow> held =
      rowsOf(studyOf(smoothSheet(), plan), "explicit-euler", Precision::Double, RowStatus::Ok);
  ASSERT_FALSE(held.empty());
  plan.runBudget = held.front().seconds / 2;
  EXPECT_FALSE(rowsOf(studyOf(smoothSheet(), plan), "explicit-euler", Precision::Double, RowStatus::Ok).empty());
}

TEST(WorkPrecision, ARunThatTakesTooLongEndsItsLadder) {
  StudyPlan plan = planOf({"symplectic-euler", "rk4"});
  plan.runBudget = 10 * kTick;
  const Study study = studyOf(smoothSheet(), plan);
  const std::vector<WorkRow> late = rowsOf(study, "symplectic-euler", Precision::Double, RowStatus::TooSlow);
  ASSERT_EQ(late.size(), 1U);
  EXPECT_TRUE(std::isnan(late[0].rmsError));
  EXPECT_GE(late[0].seconds, plan.runBudget);
  EXPECT_FALSE(rowsOf(study, "rk4", Precision::Double, RowStatus::Ok).empty()) << "the other methods still run";
}

TEST(WorkPrecision, ALadderEndsBelowTheLowestErrorAsked) {
  StudyPlan plan = planOf({"rk4"});
  plan.lowestError = 1e-6;
  const std::vector<WorkRow> rows = rowsOf(studyOf(smoothSheet(), plan), "rk4", Precision::Double, RowStatus::Ok);
  ASSERT_GE(rows.size(), 2U);
  EXPECT_LT(rows.back().rmsError, 1e-6);
  EXPECT_GE(rows[rows.size() - 2].rmsError, 1e-6);
}

TEST(WorkPrecision, StepsDivideTheTimeBetweenSamplesAndWorkIsCountedExactly) {
  for (const WorkRow& row :
       rowsOf(studyOf(smoothSheet(), planOf({"rk4", "leapfrog"})), "leapfrog", Precision::Double, RowStatus::Ok)) {
    EXPECT_EQ(row.steps % 20, 0);
    EXPECT_NEAR(row.dt * double(row.steps), 1, 1e-12);
    EXPECT_EQ(row.forceEvaluations, row.steps + 1);  // one more at the start
  }
}

/// The CSV without the column of seconds.
std::string withoutSeconds(const std::vector<WorkRow>& rows) {
  std::vector<WorkRow> still = rows;
  for (WorkRow& row : still) row.seconds = 0;
  return workCsv(still);
}

TEST(WorkPrecision, EverythingButTheSecondsIsTheSameInASecondStudy) {
  const auto study = [] { return studyOf(smoothSheet(), planOf({"leapfrog", "dopri54"})); };
  EXPECT_EQ(withoutSeconds(study().rows), withoutSeconds(study().rows));
}

TEST(WorkPrecision, TheFirstRungsOfAllMethodsComeBeforeTheRestOfAny) {
  StudyPlan plan = planOf({"leapfrog", "dopri54"});
  const std::string whole = withoutSeconds(studyOf(smoothSheet(), plan).rows);
  plan = planOf({"leapfrog", "dopri54"});
  plan.firstRungs = 2;
  std::vector<std::string> came;
  plan.rowObserver = [&came](const WorkRow& row) { came.push_back(row.integrator); };
  EXPECT_EQ(withoutSeconds(studyOf(smoothSheet(), plan).rows), whole);  // in the same order in the end
  ASSERT_GT(came.size(), 8U);                                           // two precisions
  const std::vector<std::string> first(came.begin(), came.begin() + 8);
  EXPECT_EQ(std::ranges::count(first, "leapfrog"), 4);
  EXPECT_EQ(came[4], "dopri54");
}

TEST(WorkPrecision, AnInterruptedStudyKeepsTheRowsSoFar) {
  StudyPlan plan = planOf({"leapfrog", "rk4"});
  const std::string whole = withoutSeconds(studyOf(smoothSheet(), plan).rows);
  plan = planOf({"leapfrog", "rk4"});
  plan.observer = [calls = 0](double) mutable { return ++calls < 40; };
  const Study study = studyOf(smoothSheet(), plan);
  EXPECT_TRUE(study.stopped);
  ASSERT_FALSE(study.rows.empty());
  const std::string part = withoutSeconds(study.rows);
  EXPECT_LT(part.size(), whole.size());
  EXPECT_EQ(part, whole.substr(0, part.size()));
}

TEST(WorkPrecision, AMethodThatRefusesTheSceneIsLeftOutAndSaysWhy) {
  Scene scene = smoothSheet();
  scene.damping = Damping::Axial;
  const Study study = studyOf(scene, planOf({"imex", "rk4"}));
  ASSERT_EQ(study.refusals.size(), 1U);
  EXPECT_NE(study.refusals[0].find("imex"), std::string::npos);
  EXPECT_FALSE(rowsOf(study, "rk4", Precision::Double, RowStatus::Ok).empty());
}

TEST(WorkPrecision, ProgressNeverGoesBackwardsAndEndsNearTheEnd) {
  StudyPlan plan = planOf({"leapfrog", "bs32"});
  plan.fewestRepeats = 3;
  double last = 0;
  bool forwards = true;
  plan.observer = [&](double fraction) {
    forwards = forwards && fraction >= last && fraction <= 1;
    last = fraction;
    return true;
  };
  studyOf(smoothSheet(), plan);
  EXPECT_TRUE(forwards);
  EXPECT_GT(last, 0.8);
}

}  // namespace
}  // namespace tyg::test
