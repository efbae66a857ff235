// Ranges of the axes, from the rows.
#include "study/work_chart_axes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tyg {
namespace {

constexpr double kFirstLeft = 150, kFirstRight = 1060, kSecondLeft = 1330, kSecondRight = 2200;

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

}  // namespace

double LogAxis::place(double value) const { return std::log(value / low) / std::log(high / low); }
double LogAxis::at(double place) const { return low * std::pow(high / low, place); }

double ChartPanel::workOf(const WorkRow& row, double duration) const {
  // Adaptive methods stay below their largest step: a failed run of theirs is shown a little left of where it belongs.
  const double simulated = row.status == RowStatus::Ok ? duration : static_cast<double>(row.steps) * row.dt;
  return (work == Work::Seconds ? row.seconds : static_cast<double>(row.forceEvaluations)) / simulated;
}

std::vector<ChartPanel> chartPanels(const WorkChart& chart) {
  std::vector<ChartPanel> panels{
      {.work = ChartPanel::Work::Seconds, .left = kFirstLeft, .right = kFirstRight, .x = {}},
      {.work = ChartPanel::Work::Evaluations, .left = kSecondLeft, .right = kSecondRight, .x = {}}};
  for (ChartPanel& panel : panels) {
    Extent extent;
    for (const WorkRow& row : chart.rows) {
      if (row.status == RowStatus::Ok) extent.include(panel.workOf(row, chart.duration));
    }
    if (panel.work == ChartPanel::Work::Seconds) extent.include(1);  // real time
    panel.x = extent.widened(2.5, 2);                                // room for the failed runs to the left
  }
  return panels;
}

ErrorAxis errorAxis(const WorkChart& chart) {
  LogAxis data{1e-12, 1};
  if (chart.range) {
    data = {chart.range->lowest, chart.range->highest};
  } else {
    Extent extent;
    extent.include(chart.floorOfDouble / chart.size);
    for (const WorkRow& row : chart.rows) extent.include(row.rmsError / chart.size);
    if (chart.spatial) extent.include(chart.spatial->distance / chart.size);
    if (extent.high > 0) data = extent.widened(3, 3);
  }
  // The strip lies above the data.
  return {{data.low, data.at(1 / (1 - ErrorAxis::kStrip))}};
}

std::vector<std::string> chartedMethods(const WorkChart& chart) {
  std::vector<std::string> names;
  for (const WorkRow& row : chart.rows) {
    if (std::ranges::find(names, row.integrator) == names.end()) names.push_back(row.integrator);
  }
  return names;
}

double pixelX(const ChartPanel& panel, double work) {
  return panel.left + panel.x.place(work) * (panel.right - panel.left);
}
double pixelY(const ErrorAxis& axis, double error) {
  return ChartCanvas::kBottom - axis.y.place(error) * (ChartCanvas::kBottom - ChartCanvas::kTop);
}

std::vector<Pixel> curveOf(const WorkChart& chart, const ChartPanel& panel, const ErrorAxis& axis,
                           const std::string& method, Precision precision) {
  std::vector<Pixel> curve;
  for (const WorkRow& row : chart.rows) {
    const double work = panel.workOf(row, chart.duration);
    if (row.integrator != method || row.precision != precision || row.status != RowStatus::Ok) continue;
    if (work > 0 && row.rmsError > 0) curve.push_back({pixelX(panel, work), pixelY(axis, row.rmsError / chart.size)});
  }
  return curve;
}

const WorkRow* endOfCurve(const WorkChart& chart, const std::string& method) {
  const WorkRow* end = nullptr;
  const auto rank = [&](const WorkRow& row) {
    return (row.precision == Precision::Double ? 2 : 0) + (row.trusted(chart.duration) ? 1 : 0);
  };
  for (const WorkRow& row : chart.rows) {
    if (row.integrator != method || row.status != RowStatus::Ok || !(row.rmsError > 0)) continue;
    if (end == nullptr || rank(row) >= rank(*end)) end = &row;
  }
  return end;
}

}  // namespace tyg
