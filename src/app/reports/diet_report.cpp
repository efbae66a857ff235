// The table, the objects and the rows of a diet; numbers in the table are cut to what they can mean.
#include "app/reports/diet_report.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "app/reports/json.h"
#include "tyg/methods.h"
#include "util/amounts.h"
#include "util/csv.h"
#include "util/text.h"
#include "util/visible_text.h"

namespace tyg {
namespace {

std::string settingWords(const Scene& scene) {
  const bool adaptive = findMethod(scene.integrator).adaptive;
  return fmt::format("{}, {}, {}", scene.integrator,
                     adaptive ? fmt::format("tolerance {:.3g} m", scene.tolerance) : fmt::format("{:.4g} s", scene.dt),
                     nameOf(scene.precision));
}

/// A number in eight characters at most. `least`: below it, rounding is all that is left.
std::string cell(double number, double least = 0) {
  if (!std::isfinite(number)) return "-";
  return std::abs(number) < least ? "0" : fmt::format("{:.3g}", number);
}

std::string metres(double number) { return std::isfinite(number) ? fmt::format("{:.3f}", number) : "-"; }

std::string percent(double fraction) {
  if (!std::isfinite(fraction)) return "-";
  constexpr double kNearlyAll = 0.99;
  return fmt::format("{:.{}f} %", 100 * fraction, fraction > kNearlyAll && fraction < 1 ? 1 : 0);
}

constexpr const char* kTableLine = "{:<20} {:>9} {:>8} {:>7} {:>7} {:>9} {:>6}";

std::string tableLine(const DietRow& row, const Diet& diet, const std::string& words) {
  const bool failed = row.status != RowStatus::Ok;
  const char* verdict = failed ? "fails" : row.within ? "within" : "beyond";
  constexpr double kLeast = 1e-5, kLeastStretch = 1e-3, kLeastEnergy = 1e-6;  // mm, %, J: below is rounding
  const std::string lost = cell(1e3 * row.lost.rms, kLeast);
  const bool uncertain = !failed && lost != "0" && !row.meant(diet.judgedUpTo);
  return fmt::format(kTableLine, words, (uncertain ? "~" : "") + lost, cell(1e3 * row.lost.largest, kLeast),
                     cell(100 * row.maxStretch, kLeastStretch), metres(row.sag), cell(row.energy, kLeastEnergy),
                     percent(row.saved)) +
         "  " + verdict + "\n";
}

std::string togetherSentence(const Diet& diet) {
  if (!diet.written.within) {
    return "The scene as written is already further off than that, so nothing can be left out.\n";
  }
  if (diet.together.empty()) return "Together: nothing can be left out.\n";
  const DietRow& reduced = diet.reduced();
  return fmt::format("Together these changes save {} of the time and lose {}.\n", percent(reduced.saved),
                     lengthText(reduced.lost.rms));
}

std::string judgedSentence(const DietFindings& findings) {
  const Diet& diet = findings.diet;
  const double duration = findings.reference.scene.duration;
  std::string text = fmt::format(
      "lost: largest RMS distance from the exact motion over the run; most: of any one\n"
      "particle; within or beyond {} ({:.3g} % of the sheet).\n",
      lengthText(diet.within), 100 * diet.within / findings.reference.size);
  if (diet.judgedUpTo < duration) {
    text += fmt::format("Judged up to {:.3g} s of {:.3g} s: later a rounding error grows to a tenth of that.\n",
                        diet.judgedUpTo, duration);
  }
  return text + "~: most of this number may be rounding errors, which this cloth amplifies.\n";
}

std::string needLine(const Need& need, const Diet& diet) {
  const std::string text = fmt::format("{:<20} {:>9}  ", need.words, cell(1e3 * need.change.rms));
  if (std::isnan(need.change.rms)) return text + "its run fails\n";
  const char* part = need.kind == Need::Kind::Sheet ? "sheet" : "step";
  if (!need.tooLean(diet.within)) return text + fmt::format("enough: the present {} will do\n", part);
  return text + fmt::format("TOO COARSE: the present {} is further off than {}\n", part, lengthText(diet.within));
}

std::string needsText(const DietFindings& findings) {
  std::string text = "What it leaves out          mm\n";
  for (const Need& need : findings.needs) {
    text += needLine(need, findings.diet);
    constexpr double kGrows = 1.1;
    if (need.kind == Need::Kind::Sheet && findings.byPoints && need.finerStretch > kGrows * need.stretch) {
      text += fmt::format(
          "It hangs by points: the largest stretch grows from {:.3g} to {:.3g} % on the finer\n"
          "sheet and would go on growing. Pin a patch or an edge where that matters.\n",
          100 * need.stretch, 100 * need.finerStretch);
    }
  }
  if (findings.crossing) {
    const CrossingCells& cells = findings.crossing->cells;
    text += fmt::format(
        "Contact of the cloth with itself: it passes through itself, at {:.3g} s or before,\n"
        "where the cell right and below of [{}, {}] meets that of [{}, {}].\n",
        findings.crossing->time, cells.column, cells.row, cells.otherColumn, cells.otherRow);
  }
  return text;
}

Json rowJson(const DietRow& row, const Diet& diet) {
  return {
      {"change", row.words},
      {"columns", row.scene.columns},
      {"rows", row.scene.rows},
      {"integrator", row.scene.integrator},
      {"precision", nameOf(row.scene.precision)},
      {"dt", row.scene.dt},
      {"tolerance", row.scene.tolerance},
      {"status", nameOf(row.status)},
      {"rms_error_m", row.lost.rms},
      {"max_error_m", row.lost.largest},
      {"floor_m", row.floor},
      {"horizon_s", row.horizon},
      {"max_stretch", row.maxStretch},
      {"sag_m", row.sag},
      {"energy_J", row.energy},
      {"work", row.work},
      {"seconds", row.seconds},
      {"saved", row.saved},
      {"within", row.within},
      {"meant", row.meant(diet.judgedUpTo)},
  };
}

Json needJson(const Need& need, const Diet& diet) {
  return {
      {"finer", need.words},
      {"change_m", need.change.rms},
      {"max_stretch", need.stretch},
      {"finer_max_stretch", need.finerStretch},
      {"too_lean", need.tooLean(diet.within)},
  };
}

template <class Item, class ToJson>
Json listJson(const std::vector<Item>& items, const ToJson& toJson) {
  Json list = Json::array();
  for (const Item& item : items) list.append(toJson(item));
  return list;
}

std::string rowCsv(const char* part, const DietRow& row) {
  const Scene& scene = row.scene;
  return csvLine(part, row.words, scene.columns, scene.rows, scene.integrator, nameOf(scene.precision), scene.dt,
                 scene.tolerance, nameOf(row.status), row.lost.rms, row.lost.largest, row.floor, row.horizon,
                 row.maxStretch, row.sag, row.energy, row.work, row.seconds, row.saved, int(row.within));
}

}  // namespace

std::string dietTable(const DietFindings& findings) {
  const Diet& diet = findings.diet;
  const Scene& scene = diet.written.scene;
  std::string text = fmt::format("{}: {} x {} particles, {:.4g} s, {}\n\n", oneLine(scene.title), scene.columns,
                                 scene.rows, scene.duration, settingWords(scene));
  text += fmt::format(kTableLine, "one change at a time", "lost", "most", "stretch", "sag", "energy", "saved") + "\n";
  text += fmt::format(kTableLine, "", "mm", "mm", "%", "m", "J", "time") + "\n";
  text += tableLine(diet.written, diet, diet.written.words);
  for (const DietRow& row : diet.alone) text += tableLine(row, diet, row.words);
  if (!diet.together.empty()) text += "together\n";
  for (const DietRow& row : diet.together) text += tableLine(row, diet, "+ " + row.words);
  return text + "\n" + judgedSentence(findings) + togetherSentence(diet) + "\n" + needsText(findings);
}

std::string obstacleJson(const Scene& scene, double within, const std::string& problem) {
  return jsonText({{"scene", scene.name}, {"within_m", within}, {"problem", problem}});
}

std::string dietJson(const DietFindings& findings) {
  const Diet& diet = findings.diet;
  const auto row = [&](const DietRow& item) { return rowJson(item, diet); };
  const auto tooLean = [&](const Need& need) { return need.tooLean(diet.within); };
  return jsonText({
      {"scene", diet.written.scene.name},
      {"size_m", findings.reference.size},
      {"within_m", diet.within},
      {"judged_up_to_s", diet.judgedUpTo},
      {"written", row(diet.written)},
      {"alone", listJson(diet.alone, row)},
      {"together", listJson(diet.together, row)},
      {"finer", listJson(findings.needs, [&](const Need& need) { return needJson(need, diet); })},
      {"too_lean", std::ranges::any_of(findings.needs, tooLean)},
      {"passes_through_itself_s", findings.crossing ? Json(findings.crossing->time) : Json()},
      {"hangs_by_points", findings.byPoints},
  });
}

std::string dietCsv(const DietFindings& findings) {
  std::string csv = csvLine("part", "change", "columns", "rows", "integrator", "precision", "dt", "tolerance", "status",
                            "rms_error_m", "max_error_m", "floor_m", "horizon_s", "max_stretch", "sag_m", "energy_J",
                            "work", "seconds", "saved", "within");
  csv += rowCsv("written", findings.diet.written);
  for (const DietRow& row : findings.diet.alone) csv += rowCsv("alone", row);
  for (const DietRow& row : findings.diet.together) csv += rowCsv("together", row);
  for (const Need& need : findings.needs) {
    csv += csvLine("finer", need.words, "", "", "", "", "", "", std::isfinite(need.change.rms) ? "ok" : "unstable",
                   need.change.rms, need.change.largest, "", "", need.finerStretch, "", "", "", "", "",
                   int(!need.tooLean(findings.diet.within)));
  }
  return csv;
}

std::string leanComment(const DietFindings& findings) {
  const Diet& diet = findings.diet;
  std::vector<std::string> words;
  for (const DietRow& row : diet.together) words.push_back(row.words);
  return fmt::format(
      "Made by `tyg diet {}`: the most reduced scene found within {}.\n{}\nIt loses {} and saves {:.0f} % of the time.",
      diet.written.scene.name, lengthText(diet.within),
      words.empty() ? "Nothing could be left out." : "Changes: " + joined(words) + ".",
      lengthText(diet.reduced().lost.rms), 100 * diet.reduced().saved);
}

}  // namespace tyg
