// `tyg check`: another program's motion of a scene: how wrong it is, which method's, and which mistake it holds.
#include <iostream>
#include <memory>

#include <fmt/core.h>

#include "app/commands/command_options.h"
#include "app/commands/commands.h"
#include "app/output/drawn_files.h"
#include "app/output/exit_code.h"
#include "app/output/progress.h"
#include "app/reports/check_report.h"
#include "study/charts/check_chart.h"
#include "util/amounts.h"
#include "util/interrupt.h"
#include "util/whole_file.h"

namespace tyg {
namespace {

struct CheckCommandOptions {
  SceneOptions scene;
  std::string file;
  std::optional<std::string> within, out;
  bool json = false;
};

constexpr const char* kExamples =
    R"(FILE.csv is what your own program wrote of the scene: a header t,particle,x,y,z and a row for every
particle and time, or a header t,x0,y0,z0,x1,... and a row for every time. Times are in s,
positions in m, particles are counted from 0 along the rows from the top left one. The step of your
program is found; --dt says it. --integrator and --precision are not used: every method is tried.

Examples:
  tyg check curtain mine.csv
  tyg check curtain mine.csv --dt 1ms --out marked      also draws the error against time
  tyg check four-particles mine.csv --within 1mm --json

Exit codes: 0 done, and the error is within --within; 1 it is larger; 2 the file cannot be read, or
wrong usage; 130 interrupted by Ctrl-C, and nothing is written.)";

const std::vector<std::string> kFiles{"check.csv", "check.gp", "check.svg", "check.png"};

int check(const CheckCommandOptions& options) {
  const Scene scene = chosenScene(options.scene);
  CheckReport report;
  if (options.within) report.within = parseLength("--within", *options.within, makeSheet(scene).size());
  if (options.file.empty()) throw InputError("tyg check: found no FILE.csv, allowed: tyg check SCENE FILE.csv");
  report.motion =
      readMotion(readWholeFile(options.file, "cannot read the motion", "a CSV file of a motion"), options.file, scene);
  if (options.scene.dt && stepCounts(report.motion, *options.scene.dt).empty()) {
    throw InputError(fmt::format("--dt: found {}, allowed are steps that lead to every time of {}",
                                 timeText(*options.scene.dt), options.file));
  }
  if (options.out) checkFolder(*options.out, kFiles);

  const InterruptWatch watch;
  auto progress = std::make_unique<Progress>("tyg check " + scene.name);
  CheckOptions asked{
      .dt = options.scene.dt, .threads = options.scene.threads.value_or(0), .observer = progress->part()};
  report.check = checkMotion(scene, report.motion, asked);
  progress.reset();  // wipes its line
  if (report.check.stopped || interrupted()) return sayInterrupted("tyg check");
  std::cout << (options.json ? checkJson(report) : checkTable(report)) << std::flush;
  if (options.out) {
    const std::filesystem::path folder = preparedFolder(*options.out, kFiles);
    writeWholeFile(folder / "check.csv", checkCsv(report));
    writeWholeFile(folder / "check.gp", checkScript(report.check));
    const int drawn = drawFiles("tyg check", folder, "check", "check.csv", options.json ? std::cerr : std::cout);
    if (drawn != kDone) return drawn;
  }
  return report.passes() ? kDone : kSimulationFailed;
}

}  // namespace

void addCheckCommand(CLI::App& app, Action& action) {
  Command command(app, "check", "What is wrong with another program's motion of a scene, read from a CSV file");
  const auto options = std::make_shared<CheckCommandOptions>();
  addSceneOptions(command, options->scene, MethodCount::One, "all are tried");
  command.option("FILE.csv", options->file, "The motion that your program wrote").typeName("");
  command.option("--within", options->within, "The largest error allowed: a length, or % of the sheet's size")
      .typeName("1mm|1%");
  command.option("--out", options->out, "Folder for check.csv, check.gp, check.svg and check.png [none are written]")
      .typeName("DIR");
  command.flag("--json", options->json, "Print one JSON object");
  command.footer(kExamples);
  command.onChosen([options, &action] { action = [options] { return check(*options); }; });
}

}  // namespace tyg
