// Where things are in a chart of speed against accuracy: its two panels in pixels, and their logarithmic axes.
// Must not know: gnuplot, colours.
#pragma once

#include <string>
#include <vector>

#include "study/label_places.h"
#include "study/work_chart.h"

namespace tyg {

/// Pixels of the PNG, and of the SVG before it is scaled: sixteen to nine, as projectors are. From the top left corner.
struct ChartCanvas {
  static constexpr double kWidth = 2400, kHeight = 1350;
  static constexpr double kTop = 210, kBottom = 1180;  ///< of the panels
};

struct LogAxis {
  double low = 1e-3, high = 1;
  /// Where a value stands between the ends: 0 at low, 1 at high.
  [[nodiscard]] double place(double value) const;
  /// The value at such a place.
  [[nodiscard]] double at(double place) const;
};

/// One of the two panels: its edges in pixels, what its x-axis shows.
struct ChartPanel {
  enum class Work { Seconds, Evaluations };
  Work work = Work::Seconds;
  double left = 0, right = 0;  ///< pixels
  LogAxis x;
  /// Work of a row per simulated second, of a failed one until it failed; NaN or 0 where it has none to show.
  [[nodiscard]] double workOf(const WorkRow& row, double duration) const;
};

/// E as a fraction of the size. The uppermost `kStrip` of the axis' height is kept for runs that failed.
struct ErrorAxis {
  static constexpr double kStrip = 0.05;
  LogAxis y;
  [[nodiscard]] double failures() const { return y.at(1 - kStrip / 2); }
};

/// Places in pixels.
double pixelX(const ChartPanel& panel, double work);
double pixelY(const ErrorAxis& axis, double error);

std::vector<ChartPanel> chartPanels(const WorkChart& chart);
ErrorAxis errorAxis(const WorkChart& chart);

/// The charted names in the order of the rows, each once.
std::vector<std::string> chartedMethods(const WorkChart& chart);

/// The way of a method's curve through a panel.
std::vector<Pixel> curveOf(const WorkChart& chart, const ChartPanel& panel, const ErrorAxis& axis,
                           const std::string& method, Precision precision);

/// The last row of a method's ladder in double (else in float) that has an error, a trusted one where there is any;
/// null where every run failed.
const WorkRow* endOfCurve(const WorkChart& chart, const std::string& method);

}  // namespace tyg
