// `tyg diet`: what each part of the model costs, what is lost without it, and what the model leaves out.
#include <iostream>
#include <memory>

#include <fmt/core.h>

#include "app/commands/command_options.h"
#include "app/commands/commands.h"
#include "app/output/drawn_files.h"
#include "app/output/exit_code.h"
#include "app/output/progress.h"
#include "app/output/two_cloths.h"
#include "app/reports/diet_report.h"
#include "core/scene/scene_writer.h"
#include "study/motion/tearing.h"
#include "util/amounts.h"
#include "util/calibration_clock.h"
#include "util/interrupt.h"
#include "util/visible_text.h"
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
    R"(The scene runs once as it is written, and once without each part of its model. What is lost is the
distance from a reference that two independent methods agree on. The time saved is computed from the
number of force evaluations and the measured cost of one, so that a busy machine does not disturb
it. Changes that lose no more than --within are then made together, the largest saving first.
DIR gets diet.csv, lean.toml (the most reduced scene within that limit) and overlay.png (both).

Examples:
  tyg diet curtain
  tyg diet flag --within 5mm --out flag-diet
  tyg run out/lean.toml

Exit codes: 0 done; 1 there is no reference to compare with, or rounding errors are larger than
--within; 2 wrong input or usage; 130 interrupted by Ctrl-C, and nothing is written.)";

/// The parts of the work share one line of progress.
class Dieting {
 public:
  Dieting(const DietOptions& options, const Scene& scene)
      : scene_(scene),
        threads_(options.scene.threads.value_or(defaultThreads(scene.columns * scene.rows))),
        progress_("tyg diet " + scene.name) {}

  /// The scene ends where its tears become uncertain, which is said once the progress line is gone.
  Reference reference() {
    Tearing tearing = untilTearsDiffer(scene_, threads_, progress_.part(0, kTears));
    scene_ = tearing.scene;
    tears_ = tearing.words();
    return makeReference(scene_, threads_, progress_.part(kTears, kReference));
  }
  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] const std::string& tears() const { return tears_; }

  Diet diet(const Reference& reference, double within) {
    CostMeter meter(scene_, threads_, calibrationClock);
    DietPlan plan;
    plan.within = within;
    plan.threads = threads_;
    plan.cost = [&](const Scene& scene, int threads) { return meter.secondsPerUnit(scene, threads); };
    plan.observer = progress_.part(kReference, kDiet);
    return dietOf(scene_, reference, plan);
  }

  std::vector<Need> needs(const Reference& reference, double judgedUpTo) {
    return needsOf(scene_, reference, judgedUpTo, threads_, progress_.part(kDiet, 1));
  }

 private:
  static constexpr double kTears = 0.1, kReference = 0.4, kDiet = 0.8;  // where the parts end

  Scene scene_;
  std::string tears_;
  int threads_;
  Progress progress_;
};

/// Why there can be no verdict; empty where there can.
std::string obstacle(const Reference& reference, double within) {
  if (!reference.usable()) {
    return "no reference for this scene: " + reference.whyUnusable() + ". Try a shorter --duration";
  }
  if (reference.horizonOf(within, Precision::Double) > 0) return "";
  return fmt::format(
      "--within: found {}, allowed is more than ten times the rounding errors of this cloth, which are {} from the "
      "start; try a larger one",
      lengthText(within), lengthText(reference.floorAt(0, Precision::Double)));
}

void writeFiles(const DietFindings& findings, const std::filesystem::path& folder) {
  const DietRow& reduced = findings.diet.reduced();
  const Scene& written = findings.diet.written.scene;
  writeWholeFile(folder / "diet.csv", dietCsv(findings));
  writeWholeFile(folder / "lean.toml", sceneToToml(reduced.scene, leanComment(findings)));
  // Last: where nothing can draw, all that was computed is there.
  const std::string title = fmt::format("{}: furthest apart, {}, at t = {}", oneLine(written.title),
                                        lengthText(reduced.lost.rms), timeText(reduced.worstAt));
  const std::string words = "the most reduced scene within " + lengthText(findings.diet.within);
  const Picture picture = overlaid({written, "as written"}, {reduced.scene, words}, reduced.worstAt, title);
  writePng(picture, folder / "overlay.png");
}

int diet(const DietOptions& options) {
  Scene scene = chosenScene(options.scene);
  const double within = parseLength("--within", options.within, makeSheet(scene).size());
  const std::vector<std::string> files{"diet.csv", "lean.toml", "overlay.png"};
  checkFolder(options.out, files);

  const InterruptWatch watch;
  auto dieting = std::make_unique<Dieting>(options, scene);
  const Reference reference = dieting->reference();
  Diet found;
  std::vector<Need> needs;
  const std::string wrong = reference.stopped ? "" : obstacle(reference, within);
  if (!reference.stopped && wrong.empty()) found = dieting->diet(reference, within);
  if (!interrupted() && wrong.empty()) needs = dieting->needs(reference, found.judgedUpTo);
  scene = dieting->scene();
  const std::string tears = dieting->tears();
  dieting.reset();  // wipes the progress line
  if (interrupted()) return sayInterrupted("tyg diet");
  if (!tears.empty()) std::cerr << "tyg diet: " << tears << std::endl;
  if (!wrong.empty() && options.json) std::cout << obstacleJson(scene, within, wrong) << std::endl;
  if (!wrong.empty()) {
    std::cerr << "tyg diet: " << wrong << std::endl;
    return kSimulationFailed;
  }

  const DietFindings findings{reference, found, needs, hangsByPoints(scene),
                              firstCrossingOf(scene, reference.motion, found.judgedUpTo)};
  std::cout << (options.json ? dietJson(findings) : dietTable(findings)) << std::endl;
  const std::filesystem::path folder = preparedFolder(options.out, files);
  writeFiles(findings, folder);
  if (options.json) return kDone;
  for (const std::string& file : files) std::cout << (folder / file).string() << "\n";
  std::cout << std::flush;
  return kDone;
}

}  // namespace

void addDietCommand(CLI::App& app, Action& action) {
  Command command(app, "diet", "What each part of a scene's model costs, and what is lost without it");
  const auto options = std::make_shared<DietOptions>();
  addSceneOptions(command, options->scene);
  command.option("--within", options->within, "How much may be lost: a length, or % of the sheet's size [1%]")
      .typeName("5mm|1%");
  command.option("--out", options->out, "Folder for diet.csv, lean.toml and overlay.png [out]").typeName("DIR");
  command.flag("--json", options->json, "One JSON object on standard output instead of the table");
  command.footer(kExamples);
  command.onChosen([options, &action] { action = [options] { return diet(*options); }; });
}

}  // namespace tyg
