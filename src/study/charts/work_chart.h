// The chart of a speed-against-accuracy study: a gnuplot script that draws it from rows.csv.
// Must not know: how rows come about, gnuplot as a program, files.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/work/work_rows.h"

namespace tyg {

/// An error below this one cannot be seen: a finer sheet of the same cloth is this far away.
struct SpatialError {
  int columns = 0, rows = 0;  ///< of the finer sheet
  double distance = 0;        ///< m
};

/// Errors between which a chart is drawn, as fractions of the sheet's size.
struct ErrorRange {
  double lowest = 0, highest = 0;
};

/// What the chart shows and says.
struct WorkChart {
  std::string scene;                           ///< its title
  std::vector<std::string> notes;              ///< smaller lines below it
  std::vector<WorkRow> rows;                   ///< as in rows.csv beside the script
  double duration = 1;                         ///< simulated s of every run
  double size = 1;                             ///< of the sheet, m: errors are shown as fractions of it
  double runBudget = 1;                        ///< s, after which a run was given up
  double floorOfDouble = 0, floorOfFloat = 0;  ///< m
  std::optional<SpatialError> spatial;
  std::optional<ErrorRange> range;         ///< else what the rows need
  std::optional<double> comparedDuration;  ///< simulated s of the runs of compare.csv, where there is one
};

/// The script: draws chart.svg and chart.png from rows.csv (and compare.csv) in its own folder. Upper left panel: error
/// against seconds of the clock per simulated second; right panel: error against force evaluations per simulated
/// second; lower left panel: drift of the energy against seconds.
std::string workChartScript(const WorkChart& chart);

}  // namespace tyg
