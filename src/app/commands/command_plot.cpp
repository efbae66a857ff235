// `tyg plot`: x, y, z of chosen particles against time, as rows, a gnuplot script, and pictures where gnuplot is there.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>

#include <fmt/core.h>

#include "app/commands/command_options.h"
#include "app/commands/commands.h"
#include "app/commands/option_checks.h"
#include "app/output/drawn_files.h"
#include "app/output/exit_code.h"
#include "app/output/progress.h"
#include "core/scene/bodies.h"
#include "study/charts/trajectory_chart.h"
#include "study/motion/trajectories.h"
#include "tyg/methods.h"
#include "util/interrupt.h"
#include "util/whole_file.h"

namespace tyg {
namespace {

constexpr std::size_t kMostParticles = 6;
constexpr const char* kUsualMethods = "symplectic-euler,report-rk4,rk4";

struct PlotOptions {
  SceneOptions scene;
  std::string particles, out = "out";
};

constexpr const char* kExamples =
    R"(The lowest panel shows how far each method is from the method of the highest order, on a logarithmic
axis. A run that fails stays in the chart and is marked with a cross. Without gnuplot the rows and
the script are written, but no pictures.

Examples:
  tyg plot four-particles                  the Euler and Runge-Kutta methods of the 2017 report
                                           beside the true Runge-Kutta method
  tyg plot poke --particles middle,bottom-left --methods leapfrog,rk4 --dt 0.004
  tyg plot curtain --particles 5:10,middle --out charts)";

std::vector<ChartedParticle> chosenParticles(const Scene& scene, const std::string& list) {
  if (list.empty()) return usualParticles(scene);
  std::vector<ChartedParticle> particles;
  for (const std::string& name : splitList(list)) particles.push_back(chartedParticle(scene, name));
  if (particles.empty() || particles.size() > kMostParticles) {
    throw InputError(fmt::format("--particles: found {} names, allowed are 1 to {} with commas between",
                                 particles.size(), kMostParticles));
  }
  return particles;
}

TrajectoryStudy followed(const Scene& scene, const PlotOptions& options) {
  const std::vector<const Method*> methods = chosenMethods(options.scene, kUsualMethods);
  Progress progress("tyg plot " + scene.name);
  return followParticles(scene, chosenParticles(scene, options.particles), methods, options.scene.threads.value_or(0),
                         [&](std::size_t run, double time) {
                           return progress.show((double(run) + time / scene.duration) / double(methods.size()));
                         });
}

void sayWhatFailed(const TrajectoryStudy& study) {
  for (const Trajectory& run : study.runs) {
    if (run.status == Status::Ok) continue;
    const std::string setting = run.method->adaptive
                                    ? fmt::format("a tolerance of {:.4g} m", usedTolerance(study.scene))
                                    : fmt::format("a step of {:.4g} s", study.scene.dt);
    std::cerr << fmt::format("tyg plot: {} with {} was {} at t = {:g} s; its curve ends there", run.method->name,
                             setting, nameOf(run.status), run.failedAt)
              << std::endl;
  }
}

int plot(const PlotOptions& options) {
  const Scene scene = chosenScene(options.scene);
  chosenMethods(options.scene, kUsualMethods);
  chosenParticles(scene, options.particles);
  const std::vector<std::string> files{"plot.csv", "plot.gp", "plot.svg", "plot.png"};
  checkFolder(options.out, files);

  const InterruptWatch watch;
  const TrajectoryStudy study = followed(scene, options);
  if (interrupted()) return sayInterrupted("tyg plot");
  sayWhatFailed(study);
  const std::filesystem::path folder = preparedFolder(options.out, files);
  writeWholeFile(folder / "plot.csv", trajectoryCsv(study));
  writeWholeFile(folder / "plot.gp", trajectoryScript(study));
  return drawFiles("tyg plot", folder, "plot", "plot.csv");
}

}  // namespace

void addPlotCommand(CLI::App& app, Action& action) {
  Command command(app, "plot", "Chart x, y, z of chosen particles against time, by one or more methods");
  const auto options = std::make_shared<PlotOptions>();
  addSceneOptions(command, options->scene, MethodCount::Several, kUsualMethods);
  command
      .option("--particles", options->particles,
              "Which particles: top-left, top-right, bottom-left, bottom-right, middle, or COLUMN:ROW; at most six "
              "[those that the scene displaces or pushes, else bottom-left and middle]")
      .typeName("NAME,...");
  command.option("--out", options->out, "Folder for plot.csv, plot.gp, plot.svg and plot.png [out]").typeName("DIR");
  command.footer(kExamples);
  command.onChosen([options, &action] { action = [options] { return plot(*options); }; });
}

}  // namespace tyg
