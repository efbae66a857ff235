// The axes are as long as the rows need, with some space around them.
#include "study/charts/work_chart_axes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tyg {
namespace {

constexpr double kFirstLeft = 150, kFirstRight = 1000, kSecondLeft = 1340, kSecondRight = 2160, kStrip = 48;

struct Extent {
  double low = std::numeric_limits<double>::infinity(), high = 0;
  void include(double value) {
    if (!(value > 0) || std::isinf(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  [[nodiscard]] LogAxis widened(double down, double up) const {
    if (high == 0) return {};
    // At least two decades: an axis needs more than one number on it.
    const double wider = std::max(1.0, std::sqrt(100 / (high * up / (low / down))));
    return {low / down / wider, high * up * wider};
  }
};

LogAxis workAxis(const WorkChart& chart, const ChartPanel& panel) {
  Extent extent;
  for (const WorkRow& row : chart.rows) {
    if (row.status == RowStatus::Ok) extent.include(panel.workOf(row, chart.duration));
  }
  if (panel.work == ChartPanel::Work::Seconds) extent.include(1);  // real time
  return extent.widened(2.5, 2);                                   // room for the failed runs to the left
}

LogAxis errorAxis(const WorkChart& chart) {
  if (chart.range) return {chart.range->lowest, chart.range->highest};
  Extent extent;
  extent.include(chart.floorOfDouble / chart.size);
  for (const WorkRow& row : chart.rows) extent.include(row.rmsError / chart.size);
  if (chart.spatial) extent.include(chart.spatial->distance / chart.size);
  return extent.high > 0 ? extent.widened(3, 3) : LogAxis{1e-12, 1};
}

LogAxis driftAxis(const WorkChart& chart) {
  Extent extent;
  for (const WorkRow& row : chart.rows) extent.include(row.energyDrift);
  return extent.high > 0 ? extent.widened(3, 3) : LogAxis{1e-12, 1};
}

}  // namespace

double LogAxis::fractionAt(double value) const { return std::log(value / low) / std::log(high / low); }
double LogAxis::at(double fraction) const { return low * std::pow(high / low, fraction); }

double ChartPanel::workOf(const WorkRow& row, double duration) const {
  // Adaptive methods stay below their largest step: a failed run of theirs is shown a little left of where it belongs.
  const double simulated = row.status == RowStatus::Ok ? duration : static_cast<double>(row.steps) * row.dt;
  return (work == Work::Seconds ? row.seconds : static_cast<double>(row.forceEvaluations)) / simulated;
}

double ChartPanel::heightOf(const WorkRow& row, double size) const {
  return shown == Shown::Error ? row.rmsError / size : row.energyDrift;
}

Pixel ChartPanel::pixel(double across, double height) const {
  return {left + x.fractionAt(across) * (right - left), bottom - y.fractionAt(height) * (bottom - top)};
}

bool ChartPanel::holds(double across, double height) const {
  if (!(across > 0) || !(height > 0)) return false;
  const Pixel at = pixel(across, height);
  return at.x >= left && at.x <= right && at.y >= top + strip && at.y <= bottom;
}

std::vector<ChartPanel> chartPanels(const WorkChart& chart) {
  using enum ChartPanel::Work;
  using enum ChartPanel::Shown;
  constexpr double kTop = ChartCanvas::kTop, kBottom = ChartCanvas::kBottom;
  std::vector<ChartPanel> panels(3);
  panels[0].work = panels[2].work = Seconds;
  panels[1].work = Evaluations;
  panels[0].shown = panels[1].shown = Error;
  panels[2].shown = EnergyDrift;
  for (ChartPanel& panel : panels) {
    const bool upper = panel.shown == Error, first = panel.work == Seconds;
    panel.left = first ? kFirstLeft : kSecondLeft, panel.right = first ? kFirstRight : kSecondRight;
    panel.top = upper ? kTop : ChartCanvas::kLowerTop, panel.bottom = upper ? kBottom : ChartCanvas::kLowerBottom;
    panel.strip = upper ? kStrip : 0;
    panel.x = workAxis(chart, panel);
    panel.y = upper ? errorAxis(chart) : driftAxis(chart);
    panel.y.high = panel.y.at(1 / (1 - panel.strip / (panel.bottom - panel.top)));  // the strip lies above the data
  }
  return panels;
}

std::vector<std::string> chartedMethods(const WorkChart& chart) {
  std::vector<std::string> names;
  for (const WorkRow& row : chart.rows) {
    if (std::ranges::find(names, row.integrator) == names.end()) names.push_back(row.integrator);
  }
  return names;
}

std::vector<Pixel> curveOf(const WorkChart& chart, const ChartPanel& panel, const std::string& method,
                           Precision precision) {
  std::vector<Pixel> curve;
  for (const WorkRow& row : chart.rows) {
    if (row.integrator != method || row.precision != precision || row.status != RowStatus::Ok) continue;
    const double work = panel.workOf(row, chart.duration), height = panel.heightOf(row, chart.size);
    if (work > 0 && height > 0) curve.push_back(panel.pixel(work, height));
  }
  return curve;
}

const WorkRow* endOfCurve(const WorkChart& chart, const ChartPanel& panel, const std::string& method) {
  const WorkRow* end = nullptr;
  const auto rank = [&](const WorkRow& row) {
    return (row.precision == Precision::Double ? 2 : 0) + (row.trusted(chart.duration) ? 1 : 0);
  };
  for (const WorkRow& row : chart.rows) {
    if (row.integrator != method || row.status != RowStatus::Ok) continue;
    if (!panel.holds(panel.workOf(row, chart.duration), panel.heightOf(row, chart.size))) continue;
    if (end == nullptr || rank(row) >= rank(*end)) end = &row;
  }
  return end;
}

}  // namespace tyg
