// Where things are in a chart of speed against accuracy: its panels in pixels, and their logarithmic axes.
// Must not know: gnuplot, colours.
#pragma once

#include <string>
#include <vector>

#include "study/charts/label_places.h"
#include "study/charts/work_chart.h"

namespace tyg {

/// Pixels of the PNG, and of the SVG before it is scaled, from the top left corner. Two panels above, a lower one and
/// the legend below them.
struct ChartCanvas {
  static constexpr double kWidth = 2400, kHeight = 1810;
  static constexpr double kTop = 245, kBottom = 1200;             ///< of the upper panels
  static constexpr double kLowerTop = 1345, kLowerBottom = 1685;  ///< of the lower one
};

struct LogAxis {
  double low = 1e-3, high = 1;
  /// How far a value is from low to high, on the logarithmic scale: 0 at low, 1 at high.
  [[nodiscard]] double fractionAt(double value) const;
  /// The value at such a fraction.
  [[nodiscard]] double at(double fraction) const;
};

/// One of the panels: its edges in pixels, what its axes show.
struct ChartPanel {
  enum class Work { Seconds, Evaluations };
  enum class Shown { Error, EnergyDrift };
  Work work = Work::Seconds;
  Shown shown = Shown::Error;
  double left = 0, right = 0, top = 0, bottom = 0;  ///< pixels
  double strip = 0;  ///< pixels below the upper edge that are kept for runs that failed; 0 where those are not shown
  LogAxis x, y;

  /// Work of a row per simulated second, of a failed one until it failed; NaN or 0 where it has none to show.
  [[nodiscard]] double workOf(const WorkRow& row, double duration) const;
  /// The error as a fraction of the size, or the energy's drift; NaN or 0 where a row has none to show.
  [[nodiscard]] double heightOf(const WorkRow& row, double size) const;
  /// Where a work and an error or drift are, in pixels.
  [[nodiscard]] Pixel pixel(double across, double height) const;
  [[nodiscard]] bool holds(double across, double height) const;
  /// The heights at the lower edge and in the middle of the strip.
  [[nodiscard]] double belowStrip() const { return y.at(1 - strip / (bottom - top)); }
  [[nodiscard]] double inStrip() const { return y.at(1 - strip / 2 / (bottom - top)); }
};

/// Error against seconds, error against force evaluations, and below the first, with its x-axis, the energy's drift.
std::vector<ChartPanel> chartPanels(const WorkChart& chart);

/// The charted names in the order of the rows, each once.
std::vector<std::string> chartedMethods(const WorkChart& chart);

/// The points of a method's curve in a panel.
std::vector<Pixel> curveOf(const WorkChart& chart, const ChartPanel& panel, const std::string& method,
                           Precision precision);

/// The last row of a method's ladder in double (else in float) that a panel holds, a trusted one where there is any;
/// null where there is none.
const WorkRow* endOfCurve(const WorkChart& chart, const ChartPanel& panel, const std::string& method);

}  // namespace tyg
