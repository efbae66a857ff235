// What `tyg diet` says: a table for people, JSON and CSV for scripts.
// Must not know: options, files, how the diet was done.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/diet/diet.h"
#include "study/diet/model_needs.h"

namespace tyg {

/// A diet and what belongs to it.
struct DietFindings {
  const Reference& reference;
  const Diet& diet;
  const std::vector<Need>& needs;
  bool byPoints = false;  ///< does the sheet hang by points?
  std::optional<FirstCrossing> crossing{};
};

/// At most 80 columns wide.
std::string dietTable(const DietFindings& findings);
/// The JSON object where there can be no verdict, which says why.
std::string obstacleJson(const Scene& scene, double within, const std::string& problem);
/// One JSON object; lengths in m, times in s, energies in J.
std::string dietJson(const DietFindings& findings);
/// part,change,columns,rows,integrator,precision,dt,tolerance,status,rms_error_m,max_error_m,floor_m,horizon_s,
/// max_stretch,sag_m,energy_J,work,seconds,saved,within: a row for the scene as written, each change alone, each
/// together, and each finer model (of which only the distance and the stretch are known).
std::string dietCsv(const DietFindings& findings);
/// What the file of the reduced scene says in its first lines.
std::string leanComment(const DietFindings& findings);

}  // namespace tyg
