// The chart in words.
#include "viewer/chart_advice.h"

#include <gtest/gtest.h>

#include "tyg/methods.h"

namespace tyg {
namespace {

const ChartScale kScale{.duration = 2, .size = 1.9};

WorkRow row(std::string_view method, double dt, double error, double seconds) {
  WorkRow made;
  made.integrator = method;
  made.dt = dt, made.rmsError = error, made.seconds = seconds, made.floor = 1e-13;
  return made;
}
bool says(const std::string& text, const char* words) { return text.find(words) != std::string::npos; }

TEST(ChartAdvice, NamesMethodStepErrorAndCostWithTheirUnits) {
  const ChartAdvice advice = adviceOn({row("rk4", 0.002, 1.9e-5, 0.02)}, {&findMethod("rk4"), 0.002, 0}, kScale);
  EXPECT_EQ(advice.present, "rk4, step 2 ms: error 0.019 mm (1.0e-05 of the size) for 10 ms per simulated second.");
  EXPECT_EQ(advice.better, "");
}

TEST(ChartAdvice, SaysAboutWhereTheErrorIsReadBetweenTwoRows) {
  const std::vector<WorkRow> rows{row("rk4", 0.004, 1.6e-4, 0.01), row("rk4", 0.002, 1e-5, 0.02)};
  EXPECT_TRUE(says(adviceOn(rows, {&findMethod("rk4"), 0.003, 0}, kScale).present, "error about 0.0506 mm"));
  EXPECT_TRUE(says(adviceOn(rows, {&findMethod("rk4"), 0.002, 0}, kScale).present, "error 0.01 mm"));
}

TEST(ChartAdvice, TellsWhatIsCheaperAndWhatIsCloser) {
  const std::vector<WorkRow> rows{row("rk4", 0.002, 1e-5, 0.02), row("leapfrog", 0.002, 1e-5, 0.005),
                                  row("rk4", 0.0025, 1e-7, 0.02)};
  const ChartAdvice advice = adviceOn(rows, {&findMethod("rk4"), 0.002, 0}, kScale);
  EXPECT_TRUE(says(advice.better,
                   "Faster and at least as accurate: leapfrog, step 2 ms, at 2.5 ms of computing per simulated second, "
                   "4.0 times faster."))
      << advice.better;
  EXPECT_TRUE(
      says(advice.better, "More accurate at no greater cost: rk4, step 2.5 ms, error 0.0001 mm, 100 times smaller."))
      << advice.better;
}

TEST(ChartAdvice, SaysWhatFailsAndWhatIsNotMeasured) {
  WorkRow failed = row("rk4", 0.01, 0, 0);
  failed.status = RowStatus::NotFinite;
  EXPECT_TRUE(says(adviceOn({failed}, {&findMethod("rk4"), 0.02, 0}, kScale).present, "unstable"));
  EXPECT_TRUE(says(adviceOn({}, {&findMethod("rk4"), 0.02, 0}, kScale).present, "not measured yet"));
  EXPECT_FALSE(says(adviceOn({}, {&findMethod("rk4"), 0.02, 0}, kScale, true).present, "not measured"))
      << "nothing more is to come";
}

TEST(ChartAdvice, TellsTheToleranceOfAnAdaptiveMethod) {
  WorkRow adaptive = row("dopri54", 0.01, 1e-5, 0.02);
  adaptive.tolerance = 1e-4;
  EXPECT_TRUE(says(adviceOn({adaptive}, settingOf(adaptive), kScale).present, "dopri54, tolerance 0.1 mm: error"));
}

}  // namespace
}  // namespace tyg
