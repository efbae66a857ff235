// What the chart says in words: how the present setting compares with the measured ones, and which of them would serve
// better. Must not know: how the chart is drawn, windows.
#pragma once

#include <string>
#include <vector>

#include "study/advice/present_setting.h"

namespace tyg {

/// What turns the rows' numbers into those of the chart.
struct ChartScale {
  double duration = 1;  ///< s, simulated in every row's run
  double size = 1;      ///< of the sheet, m
  /// ms of computing per simulated second.
  [[nodiscard]] double cost(double seconds) const { return 1e3 * seconds / duration; }
};

/// `step 2 ms`, `tolerance 0.001 mm`.
std::string textOf(const Setting& setting);
Setting settingOf(const WorkRow& row);
/// `0.0123 mm (6.5e-06 of the size)`.
std::string errorText(double error, const ChartScale& scale);
/// `3.4 ms per simulated second`.
std::string costText(double seconds, const ChartScale& scale);

/// One sentence each, for the person; `better` is empty where nothing measured so far is clearly better. `finished`: no
/// further rows will come.
struct ChartAdvice {
  std::string present, better;
};
ChartAdvice adviceOn(const std::vector<WorkRow>& rows, const Setting& present, const ChartScale& scale,
                     bool finished = false);

}  // namespace tyg
