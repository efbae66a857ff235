// The chart's script and the places of its labels.
#include "study/charts/work_chart.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "study/charts/label_places.h"
#include "study/charts/work_chart_axes.h"

namespace tyg {
namespace {

WorkRow row(const std::string& method, double error, double seconds) {
  WorkRow one;
  one.scene = "test", one.integrator = method;
  one.dt = 0.01, one.steps = 100, one.forceEvaluations = 400;
  one.seconds = seconds, one.rmsError = error, one.floor = 1e-14, one.horizon = 1;
  one.energyDrift = error / 10;
  return one;
}

WorkChart someChart() {
  WorkChart chart;
  chart.scene = "It's a test";
  chart.rows = {row("rk4", 1e-3, 0.01), row("rk4", 1e-5, 0.02), row("leapfrog", 1e-2, 0.005)};
  WorkRow failed = row("leapfrog", WorkRow::kNone, 0.001);
  failed.status = RowStatus::Unstable;
  chart.rows.push_back(failed);
  chart.floorOfDouble = 1e-14, chart.floorOfFloat = 1e-7;
  return chart;
}

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(WorkChart, DrawsBothPicturesFromTheRowsBesideIt) {
  const std::string script = workChartScript(someChart());
  for (const char* part : {"rows.csv", "svg", "pngcairo", "\"It\\047s a test: speed against accuracy\"",
                           "is(\"rk4\",'double')", "is(\"leapfrog\",'float')"}) {
    EXPECT_TRUE(holds(script, part)) << part;
  }
  EXPECT_FALSE(holds(script, "compare.csv"));
}

TEST(WorkChart, ShowsAnEarlierFileAndAFinerSheetOnlyWhereThereIsOne) {
  WorkChart chart = someChart();
  EXPECT_FALSE(holds(workChartScript(chart), "39x39"));
  chart.comparedDuration = 2;
  chart.spatial = SpatialError{39, 39, 1e-3};
  EXPECT_TRUE(holds(workChartScript(chart), "compare.csv"));
  EXPECT_TRUE(holds(workChartScript(chart), "39x39"));
}

TEST(WorkChart, ComparesHorizonsWithADurationOfAllItsDigits) {
  WorkChart chart = someChart();
  chart.duration = 0.6666667;
  const std::string script = workChartScript(chart), start = "\nduration = ";
  EXPECT_EQ(std::stod(script.substr(script.find(start) + start.size())), chart.duration);
}

TEST(WorkChart, TheAxesHoldEveryRowAndRealTime) {
  const WorkChart chart = someChart();
  for (const ChartPanel& panel : chartPanels(chart)) {
    for (const WorkRow& one : chart.rows) {
      if (one.status != RowStatus::Ok) continue;
      EXPECT_TRUE(panel.holds(panel.workOf(one, chart.duration), panel.heightOf(one, chart.size)));
    }
  }
  EXPECT_LT(chartPanels(chart)[0].x.fractionAt(1), 1);
}

TEST(WorkChart, TheErrorRangeIsTheAxis) {
  WorkChart chart = someChart();
  chart.range = ErrorRange{1e-6, 1e-2};
  const ChartPanel panel = chartPanels(chart)[0];
  EXPECT_DOUBLE_EQ(panel.y.low, 1e-6);
  EXPECT_NEAR(panel.belowStrip(), 1e-2, 1e-12);
}

TEST(WorkChart, ACurveEndsAtItsLastTrustedRowInsideThePanel) {
  WorkChart chart = someChart();
  const auto endOf = [&](const std::string& method) { return endOfCurve(chart, chartPanels(chart)[0], method); };
  EXPECT_EQ(endOf("rk4")->rmsError, 1e-5);
  chart.rows[1].horizon = 0.5;
  EXPECT_EQ(endOf("rk4")->rmsError, 1e-3);
  EXPECT_EQ(endOf("xpbd"), nullptr);
  chart.rows[1].horizon = 1;
  chart.range = ErrorRange{1e-4, 1e-2};
  EXPECT_EQ(endOf("rk4")->rmsError, 1e-3);
}

TEST(WorkChart, RowsWithoutAnEnergyDriftAreNotInThePanelOfIt) {
  WorkChart chart = someChart();
  const ChartPanel::Shown drift = ChartPanel::Shown::EnergyDrift;
  EXPECT_EQ(chartPanels(chart)[2].shown, drift);
  EXPECT_EQ(curveOf(chart, chartPanels(chart)[2], "rk4", Precision::Double).size(), 2U);
  chart.rows[0].energyDrift = WorkRow::kNone, chart.rows[1].energyDrift = 0;
  EXPECT_TRUE(curveOf(chart, chartPanels(chart)[2], "rk4", Precision::Double).empty());
  EXPECT_FALSE(holds(workChartScript(chart), "nan"));
}

TEST(WorkChart, TellsAHorizonThatIsShorterThanTheRun) {
  WorkChart chart = someChart();
  EXPECT_FALSE(holds(workChartScript(chart), "T* = "));
  chart.rows[1].horizon = 0.25;
  EXPECT_TRUE(holds(workChartScript(chart), "1 of 3 runs in double from T* = 0.25 s of 1 s on"));
}

TEST(WorkChart, TheWorkOfAFailedRunIsThatOfTheTimeItReached) {
  WorkRow failed = row("rk4", WorkRow::kNone, 0.1);
  failed.status = RowStatus::Unstable;
  failed.steps = 50;  // half a second
  const ChartPanel panel;
  EXPECT_DOUBLE_EQ(panel.workOf(failed, 2), 0.2);
}

TEST(Labels, OfCurvesThatEndAtOnePointDoNotHideEachOther) {
  const std::vector<WantedLabel> wanted(11, {{500, 300}, 180, 30});
  const PixelBox bounds{0, 1000, 0, 600};
  const std::vector<PixelBox> boxes = placeLabels(wanted, {}, {}, bounds);
  ASSERT_EQ(boxes.size(), wanted.size());
  for (std::size_t a = 0; a < boxes.size(); ++a) {
    EXPECT_GE(boxes[a].left, bounds.left);
    EXPECT_LE(boxes[a].right, bounds.right);
    for (std::size_t b = 0; b < a; ++b) EXPECT_FALSE(boxes[a].meets(boxes[b])) << a << " and " << b;
  }
}

TEST(Labels, AvoidCurvesAndTakenPlaces) {
  const WantedLabel wanted{{500, 300}, 180, 30};
  const std::vector<Pixel> toTheRight{{500, 300}, {900, 300}};
  const PixelBox taken{0, 1000, 0, 290};
  const PixelBox box = placeLabels({wanted}, {toTheRight}, {taken}, {0, 1000, 0, 600}).at(0);
  EXPECT_FALSE(box.meets(taken));
  EXPECT_FALSE(box.meetsLine(toTheRight[0], toTheRight[1]));
}

TEST(Labels, ALineMeetsABoxOnlyWhereItTouchesIt) {
  const PixelBox box{10, 20, 10, 20};
  EXPECT_TRUE(box.meetsLine({0, 0}, {30, 30}));
  EXPECT_TRUE(box.meetsLine({15, 0}, {15, 30}));
  EXPECT_TRUE(box.meetsLine({15, 15}, {15, 15}));
  EXPECT_FALSE(box.meetsLine({0, 15}, {5, 15}));
  EXPECT_FALSE(box.meetsLine({0, 0}, {30, 0}));
  EXPECT_FALSE(box.meetsLine({0, 25}, {25, 50}));
}

}  // namespace
}  // namespace tyg
