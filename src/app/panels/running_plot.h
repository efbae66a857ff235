// A plot of a few running quantities against simulated time, in a panel.
// Must not know: what the quantities are.
#pragma once

#include <span>

#include "app/panels/panel.h"
#include "app/running_series.h"

namespace tyg {

/// One curve: a channel of the series, multiplied by `scale`.
struct RunningCurve {
  std::size_t channel = 0;
  Colour colour = 0;
  float scale = 1;
};
/// Draws the curves over the panel's width, `height` pixels high with the numbers at its axes; `title` says the
/// quantity and its unit, and names the widget. The last sample is at the right. A moment under the cursor is read out,
/// and a click goes back to it.
void runningPlot(const PanelScope& scope, const char* title, const RunningSeries& series,
                 std::span<const RunningCurve> curves, float height);

}  // namespace tyg
