// `tyg advise`: the cheapest method, step, precision and threads for an error or a time budget, with proof.
#include <iostream>
#include <limits>
#include <memory>
#include <thread>

#include "app/commands/command_options.h"
#include "app/commands/commands.h"
#include "app/commands/device_options.h"
#include "app/commands/option_checks.h"
#include "app/output/exit_code.h"
#include "app/output/progress.h"
#include "app/reports/advice_report.h"
#include "core/scene/scene_writer.h"
#include "study/motion/tearing.h"
#include "tyg/methods.h"
#include "util/amounts.h"
#include "util/calibration_clock.h"
#include "util/interrupt.h"
#include "util/whole_file.h"
#include "util/workers.h"

namespace tyg {
namespace {

struct AdviseOptions {
  SceneOptions scene;
  DeviceOptions device{.device = ""};
  std::string error, budget, write;
  bool json = false;
};

constexpr const char* kExamples =
    R"(A short study runs the settings of method, step and precision that are likely to be cheapest. The
cheapest of them is then run once more: it is timed, and compared with a reference that a second
method confirms. The error is the largest RMS distance of all particles from the exact motion. The
cost is the computing time for a sixtieth of a second. --integrator, --precision, --threads and
--device narrow the choice; --dt and --tolerance are not used. Where there is a graphics card that
gives the processor's bits, it is measured too.

The study ends where a smaller error could not be told from the error of the reference. It leaves
out runs that take longer than what they simulate (or than 1.5 s, or than four times the cheapest
run), and runs that cost more than the best choice so far. The built-in scenes take 1 to 15 s, the
77x77 sheet of fail-refined up to half a minute. Larger sheets take longer.

Examples:
  tyg advise curtain --error 1mm
  tyg advise flag --error 0.1% --write flag-advised.toml
  tyg advise curtain --sheet 200x200 --duration 0.5 --budget 4ms

Exit codes: 0 done; 1 the request cannot be met (the nearest choice is printed), or there is no
proof; 2 wrong input or usage; 130 interrupted by Ctrl-C.)";

Request requested(const AdviseOptions& options, const Scene& scene) {
  if (options.error.empty() == options.budget.empty()) {
    throw InputError(std::string("found ") +
                     (options.error.empty() ? "neither --error nor --budget" : "--error and --budget together") +
                     ", allowed is one of them, such as --error 1mm or --budget 4ms");
  }
  Request request;
  if (!options.error.empty()) request.error = parseLength("--error", options.error, makeSheet(scene).size());
  if (!options.budget.empty()) request.budget = parseTime("--budget", options.budget);
  return request;
}

/// One thread for sheets that do not gain by more, else the powers of two up to the cores.
std::vector<int> threadChoices(const AdviseOptions& options, const Scene& scene) {
  if (options.scene.threads) return {*options.scene.threads};
  std::vector<int> choices{1};
  if (defaultThreads(scene.columns * scene.rows) == 1) return choices;
  const int cores = static_cast<int>(std::thread::hardware_concurrency());
  for (int threads = 2; threads < cores; threads *= 2) choices.push_back(threads);
  if (cores > 1) choices.push_back(cores);
  return choices;
}

/// None where only double is allowed, which is refused where the card was asked for.
ChosenDevice cardFor(const AdviseOptions& options, const Scene& scene) {
  const bool onlyDouble = options.scene.precision && scene.precision == Precision::Double;
  if (!onlyDouble) return deviceForStudy(options.device, scene, "tyg advise");
  if (!options.device.asksForCard()) return {};
  throw InputError("precision: found double, allowed on the graphics card is float");
}

/// The scene is made to end where its tears become uncertain, which `tears` then says.
Advice advised(const AdviseOptions& options, Scene& scene, const Request& request, const ChosenDevice& card,
               std::string& tears) {
  Progress progress("tyg advise " + scene.name);
  constexpr double kTears = 0.1;  // of the work
  const int usual = options.scene.threads.value_or(defaultThreads(scene.columns * scene.rows));
  Tearing tearing = untilTearsDiffer(scene, usual, progress.part(0, kTears));
  scene = std::move(tearing.scene);
  tears = tearing.words();
  CostMeter meter(scene, 1, calibrationClock);
  AdvicePlan plan;
  plan.request = request;
  plan.methods = chosenMethods(options.scene);
  if (options.scene.precision) plan.precisions = {scene.precision};
  plan.threads = threadChoices(options, scene);
  plan.cost = [&](const Scene& priced, int threads) { return meter.secondsPerUnit(priced, threads); };
  plan.device.device = card.device;
  plan.device.cost = [&](const Scene& priced, int threads) {
    try {
      return meter.secondsPerUnit(priced, threads, card.device);
    } catch (const InputError&) {  // a method or a precision that the card does not know
      return std::numeric_limits<double>::infinity();
    }
  };
  plan.clock = calibrationClock;
  plan.observer = progress.part(tears.empty() ? 0 : kTears, 1);
  return adviseOn(scene, plan);
}

int advise(const AdviseOptions& options) {
  Scene scene = chosenScene(options.scene);
  const Request request = requested(options, scene);
  if (!options.write.empty()) checkWritable(options.write);
  const InterruptWatch watch;
  const ChosenDevice card = cardFor(options, scene);
  std::string tears;
  const Advice advice = advised(options, scene, request, card, tears);
  if (interrupted()) return sayInterrupted("tyg advise");
  if (!tears.empty()) std::cerr << "tyg advise: " << tears << std::endl;
  if (!options.write.empty() && advice.promise) {
    writeWholeFile(options.write, sceneToToml(advice.promise->scene, adviceComment(scene, advice)));
  }
  std::cout << (options.json ? adviceJson(scene, advice, card.report) + "\n" : adviceText(scene, advice, card.report));
  if (!options.json && !options.write.empty() && advice.promise) std::cout << options.write << "\n";
  std::cout << std::flush;
  return advice.met && advice.held ? kDone : kSimulationFailed;
}

}  // namespace

void addAdviseCommand(CLI::App& app, Action& action) {
  Command command(app, "advise",
                  "The cheapest method, step, precision and threads for an error or a time budget, with proof");
  const auto options = std::make_shared<AdviseOptions>();
  addSceneOptions(command, options->scene, MethodCount::Several, "all");
  command.option("--error", options->error, "The largest error allowed: a length, or % of the sheet's size")
      .typeName("1mm|1%");
  command.option("--budget", options->budget, "The computing time allowed for each frame of 1/60 s").typeName("4ms");
  command
      .option("--device", options->device.device,
              "What may move the cloth: the processor alone (cpu), or the graphics card too (gpu) [gpu where there is "
              "a card]")
      .check([](const std::string& text) {
        return checkOneOf(text, {"cpu", "gpu"});
      })
      .typeName("cpu|gpu");
  command.option("--write", options->write, "Write the scene with the advised settings to this file")
      .typeName("FILE.toml");
  command.flag("--json", options->json, "One JSON object on standard output instead of the lines");
  command.footer(kExamples);
  command.onChosen([options, &action] { action = [options] { return advise(*options); }; });
}

}  // namespace tyg
