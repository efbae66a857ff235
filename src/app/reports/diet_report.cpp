// Words and numbers of a diet.
#include "app/reports/diet_report.h"

#include <cmath>

#include "app/reports/json.h"
#include "tyg/methods.h"
#include "util/amounts.h"
#include "util/text.h"

namespace tyg {
namespace {

std::string settingWords(const Scene& scene) {
  const bool adaptive = findMethod(scene.integrator).adaptive;
  return scene.integrator +
         (adaptive ? formatted(", tolerance %.3g m, ", scene.tolerance) : formatted(", %.4g s, ", scene.dt)) +
         nameOf(scene.precision);
}

/// A number in eight characters at most. `least`: below it, rounding is all that is left.
std::string cell(double number, const char* format = "%.3g", double least = 0) {
  if (!std::isfinite(number)) return "-";
  return std::abs(number) < least ? "0" : formatted(format, number);
}

std::string percent(double fraction) {
  constexpr double kNearlyAll = 0.99;
  return cell(100 * fraction, fraction > kNearlyAll && fraction < 1 ? "%.1f %%" : "%.0f %%");
}

std::string tableLine(const DietRow& row, const Diet& diet, const std::string& words) {
  const bool failed = row.status != RowStatus::Ok;
  const char* verdict = failed ? "fails" : row.within ? "within" : "beyond";
  constexpr double kLeast = 1e-5, kLeastStretch = 1e-3, kLeastEnergy = 1e-6;  // mm, %, J: below is rounding
  const std::string lost = cell(1e3 * row.lost.rms, "%.3g", kLeast);
  const bool uncertain = !failed && lost != "0" && !row.meant(diet.judgedUpTo);
  return formatted("%-20s %9s %8s %7s %7s %9s %6s  %s\n", words.c_str(), ((uncertain ? "~" : "") + lost).c_str(),
                   cell(1e3 * row.lost.largest, "%.3g", kLeast).c_str(),
                   cell(100 * row.maxStretch, "%.3g", kLeastStretch).c_str(), cell(row.sag, "%.3f").c_str(),
                   cell(row.energy, "%.3g", kLeastEnergy).c_str(), percent(row.saved).c_str(), verdict);
}

std::string togetherSentence(const Diet& diet) {
  if (!diet.written.within) {
    return "The scene as written is itself further off than that: nothing can be taken away.\n";
  }
  if (diet.together.empty()) return "Together: nothing can be taken away.\n";
  const DietRow& lean = diet.leanest();
  return "Together " + percent(lean.saved) + " of the time is saved and " + lengthText(lean.lost.rms) + " is lost.\n";
}

std::string judgedSentence(const DietFindings& findings) {
  const Diet& diet = findings.diet;
  const double duration = findings.reference.scene.duration;
  std::string text = formatted(
      "lost: largest RMS distance from the exact motion over the run; most: of any one\n"
      "particle; within or beyond %s (%.3g %% of the sheet).\n",
      lengthText(diet.within).c_str(), 100 * diet.within / findings.reference.size);
  if (diet.judgedUpTo < duration) {
    text += formatted("Judged up to %.3g s of %.3g: from there on a rounding error grows to a tenth of that.\n",
                      diet.judgedUpTo, duration);
  }
  return text + "~: rounding errors, as this cloth amplifies them, may be most of it.\n";
}

std::string needLine(const Need& need, const Diet& diet) {
  const bool lean = need.tooLean(diet.within);
  std::string text = formatted("%-20s %9s  ", need.words.c_str(), cell(1e3 * need.change.rms).c_str());
  if (std::isnan(need.change.rms)) return text + "its run fails\n";
  return text + (lean ? "TOO LEAN: " : "enough: ") +
         (need.kind == Need::Kind::Sheet ? "the present sheet" : "the present step") +
         (lean ? " is further off than " + lengthText(diet.within) : std::string(" will do")) + "\n";
}

std::string needsText(const DietFindings& findings) {
  std::string text = "What it leaves out          mm\n";
  for (const Need& need : findings.needs) {
    text += needLine(need, findings.diet);
    constexpr double kGrows = 1.1;
    if (need.kind == Need::Kind::Sheet && findings.byPoints && need.finerStretch > kGrows * need.stretch) {
      text += formatted(
          "It hangs by points: the largest stretch grows from %.3g to %.3g %% on the finer\n"
          "sheet and would go on growing. Pin a patch or an edge where that matters.\n",
          100 * need.stretch, 100 * need.finerStretch);
    }
  }
  return text;
}

std::string rowJson(const DietRow& row, const Diet& diet) {
  JsonObject json;
  json.add("change", row.words);
  json.add("columns", row.scene.columns);
  json.add("rows", row.scene.rows);
  json.add("integrator", row.scene.integrator);
  json.add("precision", nameOf(row.scene.precision));
  json.add("dt", row.scene.dt);
  json.add("tolerance", row.scene.tolerance);
  json.add("status", nameOf(row.status));
  json.add("rms_error_m", row.lost.rms);
  json.add("max_error_m", row.lost.largest);
  json.add("floor_m", row.floor);
  json.add("horizon_s", row.horizon);
  json.add("max_stretch", row.maxStretch);
  json.add("sag_m", row.sag);
  json.add("energy_J", row.energy);
  json.add("work", row.work);
  json.add("seconds", row.seconds);
  json.add("saved", row.saved);
  json.addRaw("within", row.within ? "true" : "false");
  json.addRaw("meant", row.meant(diet.judgedUpTo) ? "true" : "false");
  return json.text();
}

template <class Item, class Json>
std::string listJson(const std::vector<Item>& items, const Json& json) {
  return "[" + joined(items, json) + "]";
}

std::string needJson(const Need& need, const Diet& diet) {
  JsonObject json;
  json.add("finer", need.words);
  json.add("change_m", need.change.rms);
  json.add("max_stretch", need.stretch);
  json.add("finer_max_stretch", need.finerStretch);
  json.addRaw("too_lean", need.tooLean(diet.within) ? "true" : "false");
  return json.text();
}

std::string rowCsv(const char* part, const DietRow& row) {
  const Scene& scene = row.scene;
  std::string text = formatted("%s,%s,%d,%d,%s,%s,%.17g,%.17g,%s", part, row.words.c_str(), scene.columns, scene.rows,
                               scene.integrator.c_str(), nameOf(scene.precision), scene.dt, scene.tolerance,
                               std::string(nameOf(row.status)).c_str());
  for (const double number :
       {row.lost.rms, row.lost.largest, row.floor, row.horizon, row.maxStretch, row.sag, row.energy}) {
    text += formatted(",%.17g", number);
  }
  return text + formatted(",%lld,%.6g,%.6g,%d\n", static_cast<long long>(row.work), row.seconds, row.saved,
                          row.within ? 1 : 0);
}

}  // namespace

std::string dietTable(const DietFindings& findings) {
  const Diet& diet = findings.diet;
  const Scene& scene = diet.written.scene;
  std::string text = scene.title +
                     formatted(": %d x %d particles, %.4g s, ", scene.columns, scene.rows, scene.duration) +
                     settingWords(scene) + "\n\n";
  text += formatted("%-20s %9s %8s %7s %7s %9s %6s\n", "one change at a time", "lost", "most", "stretch", "sag",
                    "energy", "saved");
  text += formatted("%-20s %9s %8s %7s %7s %9s %6s\n", "", "mm", "mm", "%", "m", "J", "time");
  text += tableLine(diet.written, diet, diet.written.words);
  for (const DietRow& row : diet.alone) text += tableLine(row, diet, row.words);
  if (!diet.together.empty()) text += "together\n";
  for (const DietRow& row : diet.together) text += tableLine(row, diet, "+ " + row.words);
  return text + "\n" + judgedSentence(findings) + togetherSentence(diet) + "\n" + needsText(findings);
}

std::string obstacleJson(const Scene& scene, double within, const std::string& problem) {
  JsonObject json;
  json.add("scene", scene.name);
  json.add("within_m", within);
  json.add("problem", problem);
  return json.text();
}

std::string dietJson(const DietFindings& findings) {
  const Diet& diet = findings.diet;
  const auto row = [&](const DietRow& item) { return rowJson(item, diet); };
  bool lean = false;
  for (const Need& need : findings.needs) lean = lean || need.tooLean(diet.within);
  JsonObject json;
  json.add("scene", diet.written.scene.name);
  json.add("size_m", findings.reference.size);
  json.add("within_m", diet.within);
  json.add("judged_up_to_s", diet.judgedUpTo);
  json.addRaw("written", row(diet.written));
  json.addRaw("alone", listJson(diet.alone, row));
  json.addRaw("together", listJson(diet.together, row));
  json.addRaw("finer", listJson(findings.needs, [&](const Need& need) { return needJson(need, diet); }));
  json.addRaw("too_lean", lean ? "true" : "false");
  json.addRaw("hangs_by_points", findings.byPoints ? "true" : "false");
  return json.text();
}

std::string dietCsv(const DietFindings& findings) {
  std::string csv =
      "part,change,columns,rows,integrator,precision,dt,tolerance,status,rms_error_m,max_error_m,floor_m,horizon_s,"
      "max_stretch,sag_m,energy_J,work,seconds,saved,within\n";
  csv += rowCsv("written", findings.diet.written);
  for (const DietRow& row : findings.diet.alone) csv += rowCsv("alone", row);
  for (const DietRow& row : findings.diet.together) csv += rowCsv("together", row);
  for (const Need& need : findings.needs) {
    csv += formatted("finer,%s,,,,,,,%s,%.17g,%.17g,,,%.17g,,,,,,%d\n", need.words.c_str(),
                     std::isfinite(need.change.rms) ? "ok" : "unstable", need.change.rms, need.change.largest,
                     need.finerStretch, need.tooLean(findings.diet.within) ? 0 : 1);
  }
  return csv;
}

std::string leanComment(const DietFindings& findings) {
  const Diet& diet = findings.diet;
  std::vector<std::string> words;
  for (const DietRow& row : diet.together) words.push_back(row.words);
  return "Made by `tyg diet " + diet.written.scene.name + "`: the leanest scene found within " +
         lengthText(diet.within) + ".\n" +
         (words.empty() ? std::string("Nothing could be taken away.") : "Changes: " + joined(words) + ".") + "\n" +
         "It loses " + lengthText(diet.leanest().lost.rms) +
         formatted(" and saves %.0f %% of the time.", 100 * diet.leanest().saved);
}

}  // namespace tyg
