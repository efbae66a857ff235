// `tyg diet`: what each part of the model costs, what is lost without it, and what the model leaves out.
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "app/command_line.h"
#include "app/commands/commands.h"
#include "app/output/drawn_files.h"
#include "app/output/progress.h"
#include "app/output/two_cloths.h"
#include "app/reports/diet_report.h"
#include "core/scene/scene_writer.h"
#include "util/amounts.h"
#include "util/calibration_clock.h"
#include "util/interrupt.h"
#include "util/whole_file.h"
#include "util/workers.h"

namespace tyg {
namespace {

struct DietOptions {
  SceneOptions scene;
  std::string within = "1%", out = "out";
  bool json = false;
};

constexpr const char* kExamples =
    "The scene runs once as it is and once for each thing left out; what is lost is measured against a reference that\n"
    "two independent methods agree on. Time saved is work (force evaluations) times its cost, calibrated in short "
    "turns\n"
    "that a busy machine does not disturb. Changes that stay within are then put together, the largest saving first.\n"
    "DIR gets diet.csv, lean.toml (the leanest scene within, which runs) and overlay.png (both cloths).\n\n"
    "Examples:\n"
    "  tyg diet curtain\n"
    "  tyg diet flag --within 5mm --out flag-diet\n"
    "  tyg run out/lean.toml\n\n"
    "Exit codes: 0 done; 1 there is no reference to compare with, or nothing to be said at so small a tolerance; 2\n"
    "wrong input or usage; 130 Ctrl-C, nothing is written.";

/// The parts of the work share one line of progress.
class Dieting {
 public:
  Dieting(const DietOptions& options, const Scene& scene)
      : scene_(scene),
        threads_(options.scene.threads.value_or(defaultThreads(scene.columns * scene.rows))),
        progress_("tyg diet " + scene.name) {}

  Reference reference() { return makeReference(scene_, threads_, part(0, kReference)); }

  Diet diet(const Reference& reference, double within) {
    CostMeter meter(scene_, threads_, calibrationClock);
    DietPlan plan;
    plan.within = within;
    plan.threads = threads_;
    plan.cost = [&](const Scene& scene, int threads) { return meter.secondsPerUnit(scene, threads); };
    plan.observer = part(kReference, kDiet);
    return dietOf(scene_, reference, plan);
  }

  std::vector<Need> needs(const Reference& reference, double judgedUpTo) {
    return needsOf(scene_, reference, judgedUpTo, threads_, part(kDiet, 1));
  }

 private:
  static constexpr double kReference = 0.4, kDiet = 0.8;  // where the parts end

  std::function<bool(double)> part(double from, double to) {
    return [this, from, to](double fraction) {
      progress_.show(from + (to - from) * fraction);
      return !interrupted();
    };
  }

  const Scene& scene_;
  int threads_;
  Progress progress_;
};

int say(int code, const std::string& words) {
  std::cerr << "tyg diet: " << words << std::endl;
  return code;
}

/// Why there can be no verdict; empty where there can.
std::string obstacle(const Reference& reference, double within) {
  if (!reference.usable()) {
    return "no reference for this scene: " + reference.whyUnusable() + ". Try a shorter --duration";
  }
  if (reference.horizonOf(within, Precision::Double) > 0) return "";
  return "--within " + lengthText(within) + ": found less than ten times what rounding errors make of this cloth, " +
         lengthText(reference.floorAt(0, Precision::Double)) + " from the first moment on; try a larger one";
}

void writeFiles(const DietFindings& findings, const std::filesystem::path& folder) {
  const DietRow& lean = findings.diet.leanest();
  writeWholeFile(folder / "diet.csv", dietCsv(findings));
  writeWholeFile(folder / "lean.toml", sceneToToml(lean.scene, leanComment(findings)));
  // Last: where nothing can draw, all that was computed is there.
  const std::string differ = "furthest apart, " + lengthText(lean.lost.rms) + ", at t = " + timeText(lean.worstAt);
  const Picture picture = overlaid({findings.diet.written.scene, "as written"},
                                   {lean.scene, "the leanest within " + lengthText(findings.diet.within)}, lean.worstAt,
                                   findings.diet.written.scene.title + ": " + differ);
  writePng(picture, folder / "overlay.png");
}

int diet(const DietOptions& options) {
  const Scene scene = chosenScene(options.scene);
  const double within = parseLength("--within", options.within, makeSheet(scene).size());
  const std::vector<std::string> files{"diet.csv", "lean.toml", "overlay.png"};
  const std::filesystem::path folder = preparedFolder(options.out, files);

  const InterruptWatch watch;
  auto dieting = std::make_unique<Dieting>(options, scene);
  const Reference reference = dieting->reference();
  Diet found;
  std::vector<Need> needs;
  const std::string wrong = reference.stopped ? "" : obstacle(reference, within);
  if (!reference.stopped && wrong.empty()) found = dieting->diet(reference, within);
  if (!interrupted() && wrong.empty()) needs = dieting->needs(reference, found.judgedUpTo);
  dieting.reset();  // wipes the progress line
  if (interrupted()) return say(kInterrupted, "interrupted; nothing was written");
  if (!wrong.empty() && options.json) std::cout << obstacleJson(scene, within, wrong) << std::endl;
  if (!wrong.empty()) return say(kSimulationFailed, wrong);

  const DietFindings findings{reference, found, needs, hangsByPoints(scene)};
  std::cout << (options.json ? dietJson(findings) : dietTable(findings)) << std::endl;
  writeFiles(findings, folder);
  if (options.json) return kDone;
  for (const std::string& file : files) std::cout << (folder / file).string() << "\n";
  std::cout << std::flush;
  return kDone;
}

}  // namespace

void addDietCommand(CLI::App& app, Action& action) {
  CLI::App* command =
      app.add_subcommand("diet", "What each part of a scene's model costs, and what is lost without it");
  const auto options = std::make_shared<DietOptions>();
  addSceneOptions(*command, options->scene);
  command->add_option("--within", options->within, "How much may be lost: a length, or % of the sheet's size [1%]")
      ->type_name("5mm|1%");
  command->add_option("--out", options->out, "Folder for diet.csv, lean.toml and overlay.png [out]")->type_name("DIR");
  command->add_flag("--json", options->json, "One JSON object on standard output instead of the table");
  command->footer(kExamples);
  command->callback([options, &action] { action = [options] { return diet(*options); }; });
}

}  // namespace tyg
