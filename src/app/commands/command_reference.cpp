// `tyg reference`: the nearly exact motion of a scene, as a file that other programs can be compared with.
#include <iostream>
#include <memory>

#include <fmt/core.h>

#include "app/commands/command_options.h"
#include "app/commands/commands.h"
#include "app/commands/option_checks.h"
#include "app/output/exit_code.h"
#include "app/output/motion_file.h"
#include "app/output/progress.h"
#include "app/reports/reference_report.h"
#include "study/motion/reference.h"
#include "study/motion/tearing.h"
#include "tyg/methods.h"
#include "util/interrupt.h"

namespace tyg {
namespace {

struct ReferenceOptions {
  SceneOptions scene;
  int samples = 20;
  std::string out = "reference.csv";
  bool wide = false, json = false;
};

constexpr const char* kExamples =
    R"(The file has a header t,particle,x,y,z and a row for every particle and time, with --wide a header
t,x0,y0,z0,x1,... and a row for every time. Times are in s and positions in m, with 17 significant
digits; the K sample times after t = 0 are duration/K apart. `tyg check` reads both forms. The
motion is that of dopri54 at a tolerance of 1e-13 of the sheet's size; rk4 and a twin that starts
beside it tell how far it can be trusted. --integrator, --dt, --tolerance and --precision are not
used.

Examples:
  tyg reference four-particles --samples 80 --out four-particles.csv
  tyg reference curtain --duration 1 --wide
  for scene in curtain flag poke; do tyg reference $scene --out $scene.csv; done

Exit codes: 0 done; 1 there is no exact motion of this scene; 2 wrong input or usage; 130 interrupted
by Ctrl-C. After 1 and 130 no file is written.)";

constexpr double kTearsPart = 0.05, kReferencePart = 0.9;

/// The motion itself, at the sample times that were asked for.
SampledMotion sampled(const Reference& reference, const ReferenceOptions& options, Progress& progress) {
  const double duration = reference.scene.duration;
  std::vector<double> times;
  for (int k = 1; k <= options.samples; ++k) {
    times.push_back(k == options.samples ? duration : duration * k / options.samples);
  }
  const auto shown = progress.part(kReferencePart, 1);
  return sampledRun(
      reference.scene, findMethod("dopri54"), times,
      {.threads = options.scene.threads.value_or(0), .observer = [&](double time) { return shown(time / duration); }});
}

int makeReferenceFile(const ReferenceOptions& options) {
  const Scene scene = chosenScene(options.scene);
  MotionFile file(options.out, options.wide ? MotionForm::Wide : MotionForm::Long, scene.columns * scene.rows);
  const double bytesOfParticle = options.wide ? 62 : 78;
  sayLargeOutput("tyg reference", options.out, scene, std::size_t(options.samples), bytesOfParticle);
  const int threads = options.scene.threads.value_or(0);

  const InterruptWatch watch;
  auto progress = std::make_unique<Progress>("tyg reference " + scene.name);
  const Tearing tearing = untilTearsDiffer(scene, threads, progress->part(0, kTearsPart));
  ReferenceReport report{.scene = scene,
                         .reference = makeReference(tearing.scene, threads, progress->part(kTearsPart, kReferencePart)),
                         .motion = {},
                         .tears = tearing.words(),
                         .file = options.out};
  if (!report.reference.stopped && report.reference.usable()) {
    report.motion = sampled(report.reference, options, *progress);
  }
  progress.reset();  // wipes its line
  if (interrupted() || report.reference.stopped || report.motion.stopped) return sayInterrupted("tyg reference");
  if (!report.reference.usable() || report.motion.status != Status::Ok) {
    std::cerr << "tyg reference: there is no exact motion of " << scene.name << ": " << report.reference.whyUnusable()
              << "; a shorter --duration may have one" << std::endl;
    return kSimulationFailed;
  }
  for (std::size_t k = 0; k < report.motion.times.size(); ++k) {
    file.add(report.motion.times[k], report.motion.positions[k]);
  }
  file.keep();
  std::cout << (options.json ? referenceJson(report) : referenceText(report)) << std::flush;
  return kDone;
}

}  // namespace

void addReferenceCommand(CLI::App& app, Action& action) {
  Command command(app, "reference", "The nearly exact motion of a scene as a CSV file, to compare other programs with");
  const auto options = std::make_shared<ReferenceOptions>();
  addSceneOptions(command, options->scene, MethodCount::One, "not used");
  constexpr int kMostSamples = 1000000;
  command.option("--samples", options->samples, "Number of equally spaced sample times after t = 0 [20]")
      .check([](const std::string& text) { return checkCount(text, kMostSamples, "sample times"); })
      .typeName("K");
  command.option("--out", options->out, "The file [reference.csv]").typeName("FILE.csv");
  command.flag("--wide", options->wide, "One row for every time instead of one for every particle and time");
  command.flag("--json", options->json, "Print one JSON object");
  command.footer(kExamples);
  command.onChosen([options, &action] { action = [options] { return makeReferenceFile(*options); }; });
}

}  // namespace tyg
