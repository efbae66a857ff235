// `tyg chart`: speed against accuracy, every method on one chart.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <iostream>
#include <memory>

#include "app/command_line.h"
#include "app/commands/commands.h"
#include "app/commands/option_checks.h"
#include "app/output/drawn_files.h"
#include "app/output/progress.h"
#include "app/reports/chart_report.h"
#include "study/work/work_precision.h"
#include "tyg/methods.h"
#include "util/calibration_clock.h"
#include "util/interrupt.h"
#include "util/machine.h"
#include "util/whole_file.h"
#include "util/workers.h"

namespace tyg {
namespace {

namespace fs = std::filesystem;

constexpr double kRunBudget = 1, kQuickRunBudget = 0.1;  // s

struct ChartOptions {
  SceneOptions scene;
  std::string methods, errorRange, sheets, compare, out = "out";
  std::optional<double> horizon;
  bool quick = false;
};

constexpr const char* kExamples =
    "Every method runs with coarse to fine steps or tolerances (so --dt and --tolerance are not used), in float and "
    "in\n"
    "double, until its error cannot or need not shrink, or one run takes over a second (a tenth with --quick). Runs "
    "that\n"
    "fail stay in rows.csv with their status, and are crosses at the upper edge of the chart. Ctrl-C keeps the rows so "
    "far.\n\n"
    "Examples:\n"
    "  tyg chart curtain                                  all methods, up to three minutes\n"
    "  tyg chart curtain --quick --methods leapfrog,rk4   seconds\n"
    "  tyg chart stiff --sheets 39x39 --error-range 1e-8:1\n"
    "  tyg chart poke --horizon 0.5 --out poke\n"
    "  tyg chart curtain --compare before/rows.csv        did my change help?\n\n"
    "Exit codes: 0 done; 1 there is no reference to compare with; 2 wrong input or usage; 130 Ctrl-C.";

std::optional<ErrorRange> chosenRange(const std::string& text) {
  if (text.empty()) return std::nullopt;
  ErrorRange range;
  const char *end = text.data() + text.size(), *colon = std::find(text.data(), end, ':');
  const auto isNumber = [](const char* first, const char* last, double& value) {
    const auto [stop, error] = std::from_chars(first, last, value);
    return error == std::errc() && stop == last && std::isfinite(value) && value > 0;
  };
  if (colon == end || !isNumber(text.data(), colon, range.lowest) || !isNumber(colon + 1, end, range.highest) ||
      range.lowest >= range.highest) {
    throw InputError("--error-range: found '" + text +
                     "', allowed are two fractions of the sheet's size above 0, the smaller first, such as 1e-6:1e-2");
  }
  return range;
}

std::vector<Grid> chosenSheets(const Scene& scene, const std::string& list) {
  std::vector<Grid> grids;
  for (const std::string& text : splitList(list)) {
    const std::string wrong = checkPair(text, kLargestCount, "columns x rows, such as 39x39");
    if (!wrong.empty()) throw InputError("--sheets: " + wrong);
    const auto [columns, rows] = parsePair(text);
    grids.push_back({columns, rows});
    checkFiner(scene, grids.back());
  }
  return grids;
}

/// An earlier study of the same scene, and its text.
struct Earlier {
  std::string text;
  std::vector<WorkRow> rows;
};

Earlier readEarlier(const Scene& scene, const std::string& path) {
  Earlier earlier;
  if (path.empty()) return earlier;
  earlier.text = readWholeFile(path, "--compare: cannot read", "a rows.csv of tyg chart");
  earlier.rows = parseWorkCsv(earlier.text, path);
  const auto grid = [](int columns, int rows) { return std::to_string(columns) + "x" + std::to_string(rows); };
  const std::string here = "'" + scene.name + "' of " + grid(scene.columns, scene.rows);
  if (earlier.rows.empty()) throw InputError("--compare: found no row in '" + path + "', allowed are rows of " + here);
  for (const WorkRow& row : earlier.rows) {
    if (row.scene == scene.name && row.columns == scene.columns && row.rows == scene.rows) continue;
    throw InputError("--compare: found rows of '" + row.scene + "' of " + grid(row.columns, row.rows) +
                     ", allowed are rows of " + here);
  }
  return earlier;
}

/// Simulated seconds of an earlier file's runs: steps of equal size make up the whole run.
double durationOf(const std::vector<WorkRow>& rows, double otherwise) {
  for (const WorkRow& row : rows) {
    if (row.status == RowStatus::Ok && row.tolerance == 0) return static_cast<double>(row.steps) * row.dt;
  }
  return otherwise;
}

/// The parts of the work share one line of progress.
class Charting {
 public:
  Charting(const ChartOptions& options, const Scene& scene)
      : options_(options), scene_(scene), progress_("tyg chart " + scene.name) {
    threads_ = options.scene.threads.value_or(defaultThreads(scene.columns * scene.rows));
  }

  Reference reference() { return makeReference(scene_, threads_, part(0, kReferencePart)); }

  std::vector<SheetDistance> sheets(const Reference& reference, const std::vector<Grid>& grids) {
    return sheetDistances(scene_, reference.motion, grids, threads_, part(kReferencePart, kReferencePart));
  }

  Study study(const Reference& reference, const std::optional<ErrorRange>& range) {
    StudyPlan plan;
    plan.methods = chosenMethods(options_.methods, options_.scene);
    if (options_.scene.precision) plan.precisions = {scene_.precision};
    plan.runBudget = budget();
    plan.lowestError = range ? range->lowest * reference.size : 0;
    if (options_.quick) plan.fewestRepeats = 2, plan.repeatSeconds = 0.03, plan.roundsBudget = 5;
    plan.threads = threads_;
    plan.clock = wallClock;
    plan.observer = part(kReferencePart, 1);
    return workPrecision(scene_, reference, plan);
  }

  [[nodiscard]] double budget() const { return options_.quick ? kQuickRunBudget : kRunBudget; }
  [[nodiscard]] int threads() const { return threads_; }

 private:
  static constexpr double kReferencePart = 0.05;

  std::function<bool(double)> part(double from, double to) {
    return [this, from, to](double fraction) {
      progress_.show(from + (to - from) * fraction);
      return !interrupted();
    };
  }

  const ChartOptions& options_;
  const Scene& scene_;
  int threads_ = 1;
  Progress progress_;
};

int sayNoReference(const Reference& reference) {
  std::cerr << "tyg chart: no reference for this scene: " << reference.whyUnusable()
            << "; nothing was written. Try a shorter --duration" << std::endl;
  return kSimulationFailed;
}

int sayInterrupted(const std::string& kept) {
  std::cerr << "tyg chart: interrupted; " << kept << std::endl;
  return kInterrupted;
}

WorkChart chartOf(const Reference& reference, const Study& study, const Charting& charting) {
  WorkChart chart;
  chart.rows = study.rows;
  chart.title = reference.scene.title + ": speed against accuracy";
  chart.notes = chartNotes(reference, machineName(), charting.threads());
  chart.duration = reference.scene.duration;
  chart.size = reference.size;
  chart.runBudget = charting.budget();
  chart.floorOfDouble = reference.floorOf(Precision::Double);
  chart.floorOfFloat = reference.floorOf(Precision::Float);
  return chart;
}

int chart(const ChartOptions& options) {
  Scene scene = chosenScene(options.scene);
  if (options.horizon) scene.duration = std::min(scene.duration, *options.horizon);
  chosenMethods(options.methods, options.scene);
  const std::optional<ErrorRange> range = chosenRange(options.errorRange);
  const std::vector<Grid> grids = chosenSheets(scene, options.sheets);
  const Earlier earlier = readEarlier(scene, options.compare);
  const std::vector<std::string> files{"rows.csv",   "chart.gp",    "chart.svg",       "chart.png",
                                       "sheets.csv", "compare.csv", "past_horizon.csv"};
  fs::path folder = preparedFolder(options.out, files);

  const InterruptWatch watch;
  auto charting = std::make_unique<Charting>(options, scene);
  const Reference reference = charting->reference();
  if (reference.stopped || !reference.usable()) charting.reset();  // wipes the progress line
  if (reference.stopped) return sayInterrupted("nothing was written");
  if (!reference.usable()) return sayNoReference(reference);
  const std::vector<SheetDistance> sheets = charting->sheets(reference, grids);
  if (interrupted()) {
    charting.reset();
    return sayInterrupted("nothing was written");
  }
  const Study study = charting->study(reference, range);
  for (const std::string& refusal : study.refusals) std::cerr << "\ntyg chart: left out: " << refusal << std::endl;

  WorkChart drawn = chartOf(reference, study, *charting);
  charting.reset();
  const bool stopped = interrupted();
  drawn.range = range;
  if (!sheets.empty())
    drawn.spatial = {sheets.back().grid.columns, sheets.back().grid.rows, sheets.back().distance.rms};
  if (!earlier.rows.empty()) drawn.comparedDuration = durationOf(earlier.rows, scene.duration);

  if (stopped && drawn.rows.empty()) return sayInterrupted("nothing was written");
  // A whole chart is worth more than the part of one.
  if (stopped && fs::exists(folder / "rows.csv")) folder = preparedFolder(folder / "interrupted", files);
  // What an earlier chart left here does not belong to these rows.
  for (const std::string& old : files) fs::remove(folder / old);
  writeWholeFile(folder / "rows.csv", workCsv(drawn.rows));
  if (!sheets.empty()) writeWholeFile(folder / "sheets.csv", sheetsCsv(sheets));
  if (!earlier.rows.empty()) writeWholeFile(folder / "compare.csv", earlier.text);
  if (!study.pastHorizon.empty()) writeWholeFile(folder / "past_horizon.csv", pastHorizonCsv(study.pastHorizon));
  writeWholeFile(folder / "chart.gp", workChartScript(drawn));
  if (stopped) {
    return sayInterrupted("the " + std::to_string(drawn.rows.size()) + " rows so far are in " +
                          (folder / "rows.csv").string() + "; `cd " + folder.string() +
                          " && gnuplot chart.gp` draws them");
  }
  for (const std::string& note : drawn.notes) std::cout << note << "\n";
  for (const std::string& line : pastHorizonLines(study.pastHorizon)) {
    std::cout << line << "; see " << (folder / "past_horizon.csv").string() << "\n";
  }
  std::cout << sheetLines(sheets, reference.size) << cheapestMethods(drawn) << speedChanges(drawn, earlier.rows)
            << std::flush;
  return drawFiles("tyg chart", folder, "chart", "rows.csv");
}

}  // namespace

void addChartCommand(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("chart", "Speed against accuracy: every method's error and cost on one chart");
  const auto options = std::make_shared<ChartOptions>();
  addSceneOptions(*command, options->scene);
  command->add_option("--methods", options->methods, "Which methods (tyg list shows them) [all]")
      ->type_name("NAME,...");
  command
      ->add_option("--error-range", options->errorRange,
                   "Draw only errors between these fractions of the sheet's size, and stop below them [what there is]")
      ->type_name("A:B");
  command->add_option("--horizon", options->horizon, "Simulate and compare only the first S seconds [the whole scene]")
      ->type_name("S")
      ->check([](const std::string& text) { return checkPositive(text, "seconds, such as 0.5"); });
  command
      ->add_option("--sheets", options->sheets,
                   "Finer sheets of the same cloth: how far the last one is becomes a line on the chart")
      ->type_name("CxR,...");
  command->add_option("--compare", options->compare, "An earlier rows.csv of the same scene, drawn beneath in grey")
      ->type_name("ROWS.csv");
  command->add_flag("--quick", options->quick, "Shorter ladders and fewer repeats: within 20 s for the curtain");
  command->add_option("--out", options->out, "Folder for rows.csv, chart.gp, chart.svg and chart.png [out]")
      ->type_name("DIR");
  command->footer(kExamples);
  command->callback([options, &action] { action = [options] { return chart(*options); }; });
}

}  // namespace tyg
