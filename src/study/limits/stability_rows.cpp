// A study of step limits as CSV and as a table with what has to be said besides.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "integrators/chebyshev.h"
#include "study/limits/measured_limit.h"
#include "study/limits/stability_study.h"
#include "util/csv.h"
#include "util/wrapped.h"

namespace tyg {
namespace {

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

std::string firstMode(const StabilityStudy& study, const StabilityCase& entry) {
  const StepLimit& limit = entry.limit;
  std::string appearance = appearanceOf(study.scene, limit);
  if (appearance == "none") return appearance;
  return fmt::format("{} {} by {} q=({:.2f} {:.2f})", appearance, limit.outOfPlane ? "out of plane" : "in plane",
                     limit.byDamping ? "damping" : "stiffness", limit.qx, limit.qy);
}

std::string tableLine(const StabilityStudy& study, const StabilityCase& entry) {
  const StepLimit& limit = entry.limit;
  std::string first = appearanceOf(study.scene, limit);
  if (first != "none") {
    first.append(limit.outOfPlane ? ", out of plane" : "").append(limit.byDamping ? ", damping" : ", stiffness");
  }
  return fmt::format("{:<16}  {:<7} {:>9} {:>9} {:>9} {:>9}   {}\n", entry.method->name, dampingOf(entry),
                     cell(limit.predicted), cell(limit.certified), cell(entry.atRest), cell(entry.inMotion), first);
}

/// The words in lines of a page; all but the first line are indented.
std::string paragraph(const std::string& words) {
  constexpr float kWidth = 94;
  std::string page;
  for (const char c : wrapped(words, kWidth, [](std::string_view line) { return float(line.size()); })) {
    page += c;
    if (c == '\n') page += "  ";
  }
  return page + "\n";
}

/// What explicit Euler's row without damping means.
std::string explicitNote(const StabilityStudy& study, const StabilityCase& entry) {
  const double w2 = entry.limit.mode.w2, seconds = study.scene.duration;
  constexpr double kGrowth = 1000;
  std::string note = fmt::format(
      "explicit-euler without damping: no step is stable. Each multiplies the fastest mode by sqrt(1 + h^2 w^2), "
      "w = {:.4g} /s, so that over T seconds a growth by G is survived only below h = 2 ln(G) / (w^2 T): {:.3g} ms for "
      "G = 1000 in {:.3g} s.",
      std::sqrt(w2), 1e3 * survivedStep(w2, seconds, kGrowth), seconds);
  if (entry.inMotion > 0 && std::isfinite(entry.inMotion)) {
    const double decades = entry.inMotion * w2 * seconds / 2 / std::log(10.0);
    note += fmt::format(" The {:.3g} ms that held had it grow by 10^{:.1f}, from rounding and buckling.",
                        1e3 * entry.inMotion, decades);
  }
  return note;
}

/// The same for rkc2, which takes two stages where none hold: |P_2(i y)|^2 = 1 + y^4 / 4.
std::string stagesNote(const StabilityStudy& study, const StabilityCase& entry) {
  const double w2 = entry.limit.mode.w2, seconds = study.scene.duration;
  return fmt::format(
      "rkc2 without damping: no step is stable, whatever the stages. Two, the fewest, multiply the fastest mode by "
      "1 + (h w)^4 / 8 each step, w = {:.4g} /s: a growth by 1000 in {:.3g} s is survived only below {:.3g} ms.",
      std::sqrt(w2), seconds, 1e3 * std::cbrt(8 * std::log(1000.0) / (w2 * w2 * seconds)));
}

/// What has to be said about a method's limit besides its numbers; empty where nothing has.
std::string noteOn(const StabilityStudy& study, const StabilityCase& entry) {
  const std::string_view method = entry.method->name;
  const bool limited = entry.limit.predicted > 0;
  if (method == "explicit-euler" && entry.limit.predicted == 0 && !entry.damped) return explicitNote(study, entry);
  if (method == "explicit-euler" && limited && !entry.limit.byDamping) {
    return "explicit-euler with damping: past its limit the least damped mode grows, but slowly; what holds above the "
           "prediction is what the run was too short to show.";
  }
  if (method == "dopri54" && limited && !entry.damped) {
    return "dopri54 without damping: just past its limit the fastest mode grows by less than a ten-thousandth a step; "
           "what holds above the prediction is what the run was too short to show.";
  }
  if (method == "rkc2" && entry.limit.predicted == 0) return stagesNote(study, entry);
  if (method == "rkc2" && limited) {
    return fmt::format(
        "rkc2 takes as many stages as its step needs to hold every wave, {} at most; past its limit none do.",
        kMostChebyshevStages);
  }
  return "";
}

std::vector<std::string> notesOn(const StabilityStudy& study) {
  std::vector<std::string> notes;
  std::string adaptive;
  for (const StabilityCase& entry : study.cases) {
    if (const std::string own = noteOn(study, entry); !own.empty()) notes.push_back(own);
    if (entry.method->adaptive && adaptive.find(name(entry)) == std::string::npos) {
      adaptive += (adaptive.empty() ? "" : ", ") + name(entry);
    }
    const std::string why = whyNoLimit(*entry.method);
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
  std::string table = fmt::format("Largest stable steps of {}, {} x {} particles, in ms\n\n", study.scene.title,
                                  study.scene.columns, study.scene.rows);
  table += "                                                    measured\n";
  table += "method            damping predicted certified   at rest in motion   first to fail, set by\n";
  for (const StabilityCase& entry : study.cases) table += tableLine(study, entry);
  table += "\n" + paragraph(
                      "predicted: from the modes of the sheet at rest with its pins. certified: for any deformation. "
                      "measured: the largest step found that keeps the energy alarm quiet, in tiny motions around "
                      "rest and in the scene's own motion. none: no step; all: every step tried; -: does not exist "
                      "or takes too long to measure.");
  for (const std::string& note : notesOn(study)) table += paragraph(note);
  return table;
}

}  // namespace tyg
