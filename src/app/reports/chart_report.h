// What `tyg chart` says in words: the notes on the chart, and the cheapest methods on standard output.
// Must not know: options, files.
#pragma once

#include <string>
#include <vector>

#include "study/charts/work_chart.h"
#include "study/motion/reference.h"
#include "study/motion/refinement.h"

namespace tyg {

/// Smaller lines below the title: sheet and machine, then the reference and how far it can be trusted.
std::vector<std::string> chartNotes(const Reference& reference, const std::string& machine, int threads);

/// A few lines: for each error the three cheapest methods by seconds and by force evaluations.
std::string cheapestMethods(const WorkChart& chart);

/// Per method the middle ratio of seconds, per simulated second, to those of the same rows in an earlier file; empty
/// where no row is the same.
std::string speedChanges(const WorkChart& chart, const std::vector<WorkRow>& earlier);

/// One line per finer sheet.
std::string sheetLines(const std::vector<SheetDistance>& sheets, double size);
/// The same as CSV: columns,rows,rms_distance_m,max_distance_m.
std::string sheetsCsv(const std::vector<SheetDistance>& sheets);

}  // namespace tyg
