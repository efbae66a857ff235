// `tyg stability`: how large a step may be, predicted, certified and measured, method by method.
#include <algorithm>
#include <iostream>
#include <memory>

#include "app/commands/command_options.h"
#include "app/commands/commands.h"
#include "app/commands/option_checks.h"
#include "app/output/drawn_files.h"
#include "app/output/exit_code.h"
#include "app/output/progress.h"
#include "study/charts/stability_chart.h"
#include "study/limits/stability_study.h"
#include "tyg/methods.h"
#include "util/interrupt.h"
#include "util/whole_file.h"
#include "util/workers.h"

namespace tyg {
namespace {

struct StabilityOptions {
  SceneOptions scene;
  std::string out = "out";
};

constexpr const char* kExamples =
    R"(The limits are measured by bisection: a step is too large where the energy alarm goes off. It is
tried with 2000 steps of tiny motions around rest, and with the scene's own motion, each with the
scene's damping and without. The chart draws the stability region of every method, and in it the
modes of the scene for the step of --dt.

Examples:
  tyg stability curtain                               all methods, less than a minute
  tyg stability wet --methods leapfrog,rk4,rkc2
  tyg stability curtain --sheet 40x40 --dt 0.001 --out limits

Exit codes: 0 done; 2 wrong input or usage; 130 interrupted by Ctrl-C, and nothing is written.)";

int stability(const StabilityOptions& options) {
  const Scene scene = chosenScene(options.scene);
  StabilityPlan plan;
  plan.methods = chosenMethods(options.scene);
  plan.threads = options.scene.threads.value_or(defaultThreads(scene.columns * scene.rows));
  const std::vector<std::string> files{"stability.csv", "stability.gp", "stability.svg", "stability.png"};
  checkFolder(options.out, files);

  const InterruptWatch watch;
  auto progress = std::make_unique<Progress>("tyg stability " + scene.name);
  plan.observer = progress->part();
  const StabilityStudy study = studyStability(scene, plan);
  progress.reset();  // wipes its line
  if (study.stopped) return sayInterrupted("tyg stability");
  const std::filesystem::path folder = preparedFolder(options.out, files);
  writeWholeFile(folder / "stability.csv", stabilityCsv(study));
  writeWholeFile(folder / "stability.gp", stabilityScript(study));
  std::cout << stabilityTable(study) << "\n" << std::flush;
  return drawFiles("tyg stability", folder, "stability", "stability.csv");
}

}  // namespace

void addStabilityCommand(CLI::App& app, Action& action) {
  Command command(app, "stability", "Step limits: predicted, certified for any deformation, and measured");
  const auto options = std::make_shared<StabilityOptions>();
  addSceneOptions(command, options->scene, MethodCount::Several, "all");
  command.option("--out", options->out, "Folder for stability.csv, .gp, .svg and .png [out]").typeName("DIR");
  command.footer(kExamples);
  command.onChosen([options, &action] { action = [options] { return stability(*options); }; });
}

}  // namespace tyg
