// Error against cost as a picture in a panel: a curve per method, failures at the upper edge, the frontier, and the
// present setting as a large dot. Must not know: how rows come about, what a click leads to.
#pragma once

#include <vector>

#include "study/charts/work_chart_axes.h"
#include "ui/panels/panel.h"
#include "viewer/chart_advice.h"

struct ImDrawList;
struct ImVec2;

namespace tyg {

class ChartPlot {
 public:
  struct Contents {
    const std::vector<WorkRow>& rows;
    ChartScale scale;
    Setting present;
    bool allMethods = true;  ///< have had their first rows
  };
  /// Draws plot and legend over the whole width that the panel has, `height` pixels high in all. The row under the
  /// cursor, null where there is none: it is read out beside the cursor.
  const WorkRow* draw(const PanelScope& scope, const Contents& contents, float height);

 private:
  struct Layout;
  void chooseAxes(const Contents& contents, const SettingEstimate& estimate);
  void legend(const PanelScope& scope, const Contents& contents);
  [[nodiscard]] static const WorkRow* nearest(const Layout& layout, const Contents& contents);
  static void drawGrid(const Layout& layout);
  static void drawCostTicks(const Layout& layout);
  static void drawErrorTicks(const Layout& layout);
  void drawCurves(const Layout& layout, const Contents& contents) const;
  static void drawPresent(const Layout& layout, const Contents& contents, const SettingEstimate& estimate);
  static void readOut(const Layout& layout, const WorkRow& row);

  LogAxis cost_{1, 100}, error_{1e-6, 1};  ///< ms per simulated second; mm
  const Method* emphasised_ = nullptr;     ///< its name in the legend is under the cursor
};

}  // namespace tyg
