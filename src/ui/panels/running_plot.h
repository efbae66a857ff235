// A plot of a few running quantities against simulated time, in a panel.
// Must not know: what the quantities are.
#pragma once

#include <string>

#include "ui/panels/panel.h"
#include "viewer/running_series.h"

namespace tyg {

/// One curve: a channel of the series from `zero` on, multiplied by `scale`. NaN is a gap.
struct RunningCurve {
  std::string name;
  std::size_t channel = 0;
  Colour colour = 0;
  float scale = 1;
  float zero = 0;
  [[nodiscard]] double value(const RunningSeries& series, std::size_t k) const {
    return double(scale) * (double(series.value(k, channel)) - double(zero));
  }
};

struct RunningPlot {
  const char* title;  ///< the quantity; names the widget
  const char* unit;
  float height = 0;  ///< pixels, with the numbers at its axes
  double least = 0;  ///< of the axis from end to end: what differs by less is drawn as flat
};
/// Draws the curves over the panel's width: the last sample at the right, the time of the cloth that is shown marked
/// where it is a past one. The sample under the cursor is read out; pressed there, the cloth goes back to it.
void runningPlot(const PanelScope& scope, const RunningPlot& plot, const RunningSeries& series,
                 std::span<const RunningCurve> curves);

}  // namespace tyg
