// A study of step limits as CSV and as a table with what has to be said besides.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "study/limits/stability_study.h"
#include "util/csv.h"
#include "util/visible_text.h"
#include "util/wrapped.h"

namespace tyg {
namespace {

constexpr std::string_view kIndent = "  ";  // of all lines of a paragraph but the first

std::string name(const StabilityCase& entry) { return std::string(entry.method->name); }
const char* dampingOf(const StabilityCase& entry) { return entry.damped ? "scene" : "none"; }

/// Seconds for a file.
std::string field(double step) {
  if (std::isnan(step)) return "";
  return shortNumber(step);
}

/// Milliseconds for people.
std::string cell(double step) {
  if (std::isnan(step)) return "-";
  if (std::isinf(step)) return "all";
  return step == 0 ? "none" : fmt::format("{:.4g}", 1e3 * step);
}

std::string certifiedCell(const StabilityStudy& study, const StabilityCase& entry) {
  return entry.method->stableStep != nullptr && catchesAir(study.scene) ? "none" : cell(entry.limit.certified);
}

std::string firstMode(const StabilityStudy& study, const StabilityCase& entry) {
  const StepLimit& limit = entry.limit;
  std::string appearance = appearanceOf(study.scene, limit);
  if (appearance == "none") return appearance;
  if (limit.byContact) return std::string(causeOf(limit));
  return fmt::format("{} {} by {} q=({:.2f} {:.2f})", appearance, limit.outOfPlane ? "out of plane" : "in plane",
                     causeOf(limit), limit.qx, limit.qy);
}

std::string tableLine(const StabilityStudy& study, const StabilityCase& entry) {
  const StepLimit& limit = entry.limit;
  std::string first = appearanceOf(study.scene, limit);
  if (first != "none") {
    first.append(limit.outOfPlane ? ", out of plane" : "").append(", ").append(causeOf(limit));
  }
  return fmt::format("{:<16}  {:<7} {:>9} {:>9} {:>9} {:>9}   {}\n", entry.method->name, dampingOf(entry),
                     cell(limit.predicted), certifiedCell(study, entry), cell(entry.atRest), cell(entry.inMotion),
                     first);
}

/// What has to be said about a method's limit besides its numbers; empty where nothing has.
std::string noteOn(const StabilityStudy& study, const StabilityCase& entry) {
  const Method& method = *entry.method;
  if (method.noteOnLimit == nullptr) return "";
  return method.noteOnLimit({.damped = entry.damped,
                             .byDamping = entry.limit.byDamping,
                             .predicted = entry.limit.predicted,
                             .w2 = entry.limit.mode.w2,
                             .seconds = study.scene.duration,
                             .survived = entry.inMotion});
}

std::vector<std::string> notesOn(const StabilityStudy& study) {
  std::vector<std::string> notes;
  if (catchesAir(study.scene)) {
    std::string still = study.scene.winds.empty() ? "" : " Around rest was measured in still air.";
    notes.push_back("certified: none with air: a stretched cell catches more of it." + still);
  }
  std::string adaptive;
  for (const StabilityCase& entry : study.cases) {
    if (const std::string own = noteOn(study, entry); !own.empty()) notes.push_back(own);
    if (entry.method->adaptive && adaptive.find(name(entry)) == std::string::npos) {
      adaptive += (adaptive.empty() ? "" : ", ") + name(entry);
    }
    const std::string why(entry.method->whyNoLimit);
    const bool told =
        std::ranges::any_of(notes, [&](const std::string& note) { return note.starts_with(name(entry)); });
    if (!why.empty() && !told) notes.push_back(name(entry) + " has no limit: " + why + ".");
  }
  if (!adaptive.empty()) {
    notes.push_back(adaptive +
                    ": the limits are those of fixed steps. With a tolerance they choose their own: a step past the "
                    "limit makes the error estimate grow and is taken back, so they settle around the limit where the "
                    "tolerance alone would allow more.");
  }
  for (const std::string& refusal : study.refusals) notes.push_back("left out: " + refusal);
  return notes;
}

}  // namespace

std::string stabilityCsv(const StabilityStudy& study) {
  std::string csv =
      csvLine("scene", "integrator", "damping", "predicted_dt", "certified_dt", "measured_dt", "first_mode");
  const auto add = [&](const std::string& scene, const StabilityCase& entry, double measured) {
    csv += csvLine(scene, entry.method->name, dampingOf(entry), field(entry.limit.predicted),
                   field(entry.limit.certified), field(measured), firstMode(study, entry));
  };
  for (const StabilityCase& entry : study.cases) {
    add(study.scene.name + " at rest", entry, entry.atRest);
    add(study.scene.name, entry, entry.inMotion);
  }
  return csv;
}

std::string stabilityTable(const StabilityStudy& study) {
  std::string table = fmt::format("Largest stable steps of {}, {} x {} particles, in ms\n\n",
                                  oneLine(study.scene.title), study.scene.columns, study.scene.rows);
  table += "                                                    measured\n";
  table += "method            damping predicted certified   at rest in motion   first to fail, set by\n";
  for (const StabilityCase& entry : study.cases) table += tableLine(study, entry);
  table += "\n" + paragraph(
                      "predicted: from the modes of the sheet at rest with its pins. certified: for any deformation. "
                      "measured: the largest step found that keeps the energy alarm quiet, in tiny motions around "
                      "rest, or in those of a particle that rests on a body where that is less, and in the scene's own "
                      "motion. none: no step; all: every step tried; -: does not exist "
                      "or takes too long to measure.",
                      kIndent);
  for (const std::string& note : notesOn(study)) table += paragraph(note, kIndent);
  return table;
}

}  // namespace tyg
