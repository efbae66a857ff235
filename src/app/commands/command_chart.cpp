// `tyg chart`: speed against accuracy, every method on one chart.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <utility>

#include <fmt/core.h>

#include "app/commands/command_options.h"
#include "app/commands/commands.h"
#include "app/commands/device_options.h"
#include "app/commands/option_checks.h"
#include "app/output/drawn_files.h"
#include "app/output/exit_code.h"
#include "app/output/progress.h"
#include "app/reports/chart_report.h"
#include "study/motion/tearing.h"
#include "study/work/work_precision.h"
#include "tyg/methods.h"
#include "util/amounts.h"
#include "util/calibration_clock.h"
#include "util/interrupt.h"
#include "util/machine.h"
#include "util/visible_text.h"
#include "util/whole_file.h"
#include "util/workers.h"

namespace tyg {
namespace {

namespace fs = std::filesystem;

constexpr double kRunBudget = 1, kQuickRunBudget = 0.1;  // s

struct ChartOptions {
  SceneOptions scene;
  DeviceOptions device;
  std::string errorRange, sheets, compare, out = "out";
  std::optional<double> horizon;
  bool quick = false;
};

constexpr const char* kExamples =
    R"(Every method runs with large to small steps or tolerances (so --dt and --tolerance are not used),
in float and in double. A method is done when its error cannot or need not become smaller, or when
one run takes more than a second (a tenth of a second with --quick). Runs that fail stay in rows.csv
with their status; on the chart they are marks with a cross at the upper edge. Ctrl-C keeps the rows so far.

Examples:
  tyg chart curtain                                  all methods, up to three minutes
  tyg chart curtain --quick --methods leapfrog,rk4   two methods, some seconds
  tyg chart stiff --sheets 39x39 --error-range 1e-8:1
  tyg chart poke --horizon 0.5 --out poke
  tyg chart curtain --compare before/rows.csv        did my change help?

Exit codes: 0 done; 1 there is no reference to compare with; 2 wrong input or usage; 130 interrupted
by Ctrl-C.)";

std::optional<ErrorRange> chosenRange(const std::string& text) {
  if (text.empty()) return std::nullopt;
  const std::size_t colon = std::min(text.find(':'), text.size());
  const std::string lowest = text.substr(0, colon), highest = text.substr(std::min(colon + 1, text.size()));
  const ErrorRange range{parseShare("--error-range", lowest), parseShare("--error-range", highest)};
  if (range.lowest < range.highest) return range;
  throw InputError("--error-range: found '" + text +
                   "', allowed are two shares of the sheet's size, the smaller first, such as 1e-6:1e-2 or 0.1%:1%");
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

/// Simulated seconds of an earlier file's runs: steps of equal size make up the whole run.
double durationOf(const std::vector<WorkRow>& rows, double otherwise) {
  for (const WorkRow& row : rows) {
    if (row.status == RowStatus::Ok && row.tolerance == 0) return static_cast<double>(row.steps) * row.dt;
  }
  return otherwise;
}

Earlier readEarlier(const Scene& scene, const std::string& path) {
  Earlier earlier;
  if (path.empty()) return earlier;
  earlier.text = readWholeFile(path, "--compare: cannot read", "a rows.csv of tyg chart");
  earlier.rows = parseWorkCsv(earlier.text, path);
  const auto rowsOf = [](const std::string& name, int columns, int rows) {
    return fmt::format("rows of '{}' of {}x{}", name, columns, rows);
  };
  const std::string allowed = "allowed are " + rowsOf(scene.name, scene.columns, scene.rows);
  if (earlier.rows.empty()) throw InputError("--compare: found no row in '" + path + "', " + allowed);
  for (const WorkRow& row : earlier.rows) {
    if (row.scene == scene.name && row.columns == scene.columns && row.rows == scene.rows) continue;
    throw InputError("--compare: found " + rowsOf(row.scene, row.columns, row.rows) + ", " + allowed);
  }
  if (const double duration = durationOf(earlier.rows, scene.duration); !std::isfinite(duration)) {
    throw InputError("--compare: found steps in '" + path + "' that add up to no finite time, " + allowed);
  }
  return earlier;
}

/// The parts of the work share one line of progress.
class Charting {
 public:
  Charting(const ChartOptions& options, const Scene& scene, std::shared_ptr<Device> device)
      : options_(options), scene_(scene), device_(std::move(device)), progress_("tyg chart " + scene.name) {
    threads_ = options.scene.threads.value_or(defaultThreads(scene.columns * scene.rows));
  }

  /// The scene ends where its tears become uncertain.
  Reference reference() {
    Tearing tearing = untilTearsDiffer(scene_, threads_, progress_.part(0, kTearsPart));
    scene_ = tearing.scene;
    tears_ = tearing.words();
    return makeReference(scene_, threads_, progress_.part(kTearsPart, kReferencePart));
  }

  std::vector<SheetDistance> sheets(const Reference& reference, const std::vector<Grid>& grids) {
    return sheetDistances(scene_, reference.motion, grids, threads_, progress_.part(kReferencePart, kReferencePart));
  }

  Study study(const Reference& reference, const std::optional<ErrorRange>& range) {
    StudyPlan plan;
    plan.methods = chosenMethods(options_.scene);
    if (options_.scene.precision) plan.precisions = {scene_.precision};
    plan.runBudget = budget();
    plan.lowestError = range ? range->lowest * reference.size : 0;
    if (options_.quick) plan.fewestRepeats = 2, plan.repeatSeconds = 0.03, plan.roundsBudget = 5;
    plan.threads = threads_;
    plan.device = device_;
    // A card works beside this thread: only the clock knows how long.
    plan.clock = [threads = device_ ? std::max(2, threads_) : threads_] { return calibrationClock(threads); };
    plan.observer = progress_.part(kReferencePart, 1);
    return workPrecision(scene_, reference, plan);
  }

  [[nodiscard]] double budget() const { return options_.quick ? kQuickRunBudget : kRunBudget; }
  [[nodiscard]] int threads() const { return threads_; }
  [[nodiscard]] const std::string& tears() const { return tears_; }

 private:
  static constexpr double kTearsPart = 0.02, kReferencePart = 0.05;

  const ChartOptions& options_;
  Scene scene_;
  std::shared_ptr<Device> device_;  // null: the processor
  std::string tears_;
  int threads_ = 1;
  Progress progress_;
};

int sayNoReference(const Reference& reference) {
  std::cerr << "tyg chart: no reference for this scene: " << reference.whyUnusable()
            << "; nothing was written. Try a shorter --duration" << std::endl;
  return kSimulationFailed;
}

WorkChart chartOf(const Reference& reference, const Study& study, const Charting& charting) {
  WorkChart chart;
  chart.rows = study.rows;
  chart.scene = reference.scene.title;
  chart.notes = chartNotes(reference, machineName(), charting.threads());
  if (!charting.tears().empty()) chart.notes.push_back(charting.tears());
  if (study.tornElsewhere > 0) {
    chart.notes.push_back(fmt::format("in {} of {} runs other springs broke before that than in the reference",
                                      study.tornElsewhere, study.rows.size()));
  }
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
  chosenMethods(options.scene);
  const std::optional<ErrorRange> range = chosenRange(options.errorRange);
  const std::vector<Grid> grids = chosenSheets(scene, options.sheets);
  const Earlier earlier = readEarlier(scene, options.compare);
  const std::vector<std::string> files{"rows.csv",   "chart.gp",    "chart.svg",       "chart.png",
                                       "sheets.csv", "compare.csv", "past_horizon.csv"};
  checkFolder(options.out, files);

  const ChosenDevice device = deviceForStudy(options.device, scene, "tyg chart");
  const InterruptWatch watch;
  auto charting = std::make_unique<Charting>(options, scene, device.device);
  const Reference reference = charting->reference();
  if (reference.stopped || !reference.usable()) charting.reset();  // wipes the progress line
  if (reference.stopped) return sayInterrupted("tyg chart");
  if (!reference.usable()) return sayNoReference(reference);
  const std::vector<SheetDistance> sheets = charting->sheets(reference, grids);
  if (interrupted()) {
    charting.reset();
    return sayInterrupted("tyg chart");
  }
  const Study study = charting->study(reference, range);
  for (const std::string& refusal : study.refusals) std::cerr << "\ntyg chart: left out: " << refusal << std::endl;

  WorkChart drawn = chartOf(reference, study, *charting);
  if (device.device) drawn.notes.push_back("in float, where the card takes it: " + sentenceOn(device.report));
  charting.reset();
  const bool stopped = interrupted();
  drawn.range = range;
  if (!sheets.empty())
    drawn.spatial = {sheets.back().grid.columns, sheets.back().grid.rows, sheets.back().distance.rms};
  if (!earlier.rows.empty()) drawn.comparedDuration = durationOf(earlier.rows, scene.duration);

  if (stopped && drawn.rows.empty()) return sayInterrupted("tyg chart");
  // A whole chart is worth more than the part of one.
  const fs::path out = options.out;
  const fs::path folder = preparedFolder(stopped && fs::exists(out / "rows.csv") ? out / "interrupted" : out, files);
  writeWholeFile(folder / "rows.csv", workCsv(drawn.rows));
  // What an earlier chart left here does not belong to these rows.
  const auto writeOrRemove = [&](const char* name, const std::string& text) {
    text.empty() ? void(fs::remove(folder / name)) : writeWholeFile(folder / name, text);
  };
  writeOrRemove("sheets.csv", sheets.empty() ? "" : sheetsCsv(sheets));
  writeOrRemove("compare.csv", earlier.rows.empty() ? "" : earlier.text);
  writeOrRemove("past_horizon.csv", study.pastHorizon.empty() ? "" : pastHorizonCsv(study.pastHorizon));
  writeWholeFile(folder / "chart.gp", workChartScript(drawn));
  if (stopped) {
    return sayInterrupted("tyg chart",
                          fmt::format("the {} rows so far are in {}; `cd {} && gnuplot chart.gp` draws them",
                                      drawn.rows.size(), (folder / "rows.csv").string(), shellWord(folder.string())));
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
  Command command(app, "chart", "Speed against accuracy: every method's error and cost on one chart");
  const auto options = std::make_shared<ChartOptions>();
  addSceneOptions(command, options->scene, MethodCount::Several, "all");
  addDeviceOption(command, options->device);
  command
      .option("--error-range", options->errorRange,
              "Draw only errors between these shares of the sheet's size, and stop below them [all errors]")
      .typeName("A:B");
  command
      .amount(
          "--horizon", options->horizon, [](const std::string& text) { return parseTime("--horizon", text); },
          "Simulate and compare only the first part of the scene, such as 0.5s [the whole scene]")
      .typeName("TIME");
  command
      .option("--sheets", options->sheets,
              "Finer sheets of the same cloth; a line on the chart shows how far away the last one is")
      .typeName("CxR,...");
  command.option("--compare", options->compare, "An earlier rows.csv of the same scene, which is drawn in grey")
      .typeName("ROWS.csv");
  command.flag("--quick", options->quick, "Fewer steps and fewer repeats: the curtain takes less than 20 s");
  command.option("--out", options->out, "Folder for rows.csv, chart.gp, chart.svg and chart.png [out]").typeName("DIR");
  command.footer(kExamples);
  command.onChosen([options, &action] { action = [options] { return chart(*options); }; });
}

}  // namespace tyg
