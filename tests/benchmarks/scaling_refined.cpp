// The same cloth on finer and finer grids: what one simulated second costs each method at 0.9 of its stable limit. Work
// is evaluations, or steps where a method has none, times their price on this machine.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <sstream>

#include "scaling.h"
#include "study/charts/gnuplot.h"
#include "study/charts/method_style.h"
#include "study/limits/stability.h"
#include "study/work/cost.h"
#include "tyg/methods.h"

namespace tyg::scaling {
namespace {

constexpr double kOfLimit = 0.9;
constexpr const char* kScenes[] = {"curtain", "wet"};

std::vector<int> gridsOf(const Options& options) {
  return options.quick ? std::vector{20, 39} : std::vector{20, 39, 77, 153, 305};
}

/// A method's scene on a grid at its step there. A limit of 0, or none, is told by dt.
Scene sceneOn(const char* name, int grid, const Method& method) {
  Scene scene = withSheet(loadScene(name), grid, grid);
  scene.integrator = method.name;
  scene.tolerance = 0;  // adaptive methods too take the step that they are given
  const double limit = restLatticeLimit(scene, method);
  scene.dt = std::isfinite(limit) ? kOfLimit * limit : 0;
  return scene;
}

struct Cost {
  double dt = 0, seconds = 0;  // per simulated second
};

Cost costOf(const Scene& scene, CostMeter& meter) {
  const Method& method = findMethod(scene.integrator);
  constexpr int kTrialSteps = 3;
  Simulation trial(scene, method, {.threads = 1, .keepGoing = true});
  trial.advanceTo(kTrialSteps * scene.dt);
  const double atStart = std::max(method.evaluationsAtStart, 0);
  const double units =
      method.evaluationsPerStep == 0 ? 1 : (double(trial.forceEvaluations()) - atStart) / double(trial.steps());
  return {scene.dt, units / scene.dt * meter.secondsPerUnit(scene, 1)};
}

using Costs = std::map<std::string, std::vector<Cost>>;  // by method, as far as its grids go

Costs costsOf(const char* name, const Options& options) {
  CostMeter meter(sceneOn(name, 20, findMethod("leapfrog")), 1, seconds);
  Costs costs;
  for (const Method& method : methods()) {
    constexpr double kMostSolvedGrid = 77;  // a direct solve of a finer one takes longer than all the rest
    for (const int grid : gridsOf(options)) {
      const Scene scene = sceneOn(name, grid, method);
      if (!(scene.dt > 0) || (method.name == "imex" && grid > kMostSolvedGrid)) break;
      say("one second of the " + std::string(name) + ", " + std::string(method.name) + ", " + std::to_string(grid));
      costs[std::string(method.name)].push_back(costOf(scene, meter));
    }
  }
  return costs;
}

/// How the cost grows where the grid becomes twice as fine, as a power of it.
double power(const std::vector<Cost>& costs, std::size_t k) {
  return k == 0 ? std::nan("") : std::log2(costs[k].seconds / costs[k - 1].seconds);
}

void print(const char* name, const Costs& costs, const std::vector<int>& grids) {
  std::printf(
      "\n%s: ms for one simulated second at %.1f of the limit, one thread, double; in brackets its growth, as a "
      "power of the fineness\n%-18s",
      name, kOfLimit, "");
  for (const int grid : grids) std::printf("%10dx%-4d", grid, grid);
  std::printf("\n");
  for (const auto& [method, row] : costs) {
    std::printf("%-18s", method.c_str());
    for (std::size_t k = 0; k < row.size(); ++k) {
      std::printf(k == 0 ? "%8.2f       " : "%8.2f (%3.1f) ", 1e3 * row[k].seconds, power(row, k));
    }
    std::printf("\n");
  }
}

std::string chartOf(const std::vector<std::string>& names, const std::vector<Costs>& costs) {
  std::ostringstream script;
  script << "  set multiplot layout 1," << names.size()
         << " margins 0.06,0.81,0.13,0.9 spacing 0.07\n"
            "  set logscale xy; set grid lc rgb '#dddddd' lt 1; set xrange [16:380]\n"
            "  set xtics (20, 39, 77, 153, 305); set format y '10^{%T}'\n"
            "  set xlabel 'particles along a side of the same cloth'\n";
  for (std::size_t scene = 0; scene < names.size(); ++scene) {
    script << "  set title " << gnuplotQuoted(names[scene] + ": seconds for a simulated second") << "\n"
           << (scene + 1 == names.size() ? "  set key at screen 0.99,0.9 right top samplen 2\n" : "  unset key\n")
           << "  plot ";
    for (const auto& [method, row] : costs[scene]) {
      const MethodStyle look = styleOfMethod(method);
      script << "data using (stringcolumn(1) eq " << gnuplotQuoted(names[scene]) << " && stringcolumn(2) eq "
             << gnuplotQuoted(method) << " ? $3 : NaN):5 skip 1 w lp lw 2 pt " << 4 + int(look.mark) << " dt "
             << (look.dashed ? 2 : 1) << " lc rgb '" << chartColour(look.colour) << "' t " << gnuplotQuoted(method)
             << " noenhanced, ";
    }
    const double start = costs[scene].at("leapfrog").front().seconds / 4;
    script << start << "*(x/20)**3 w l lw 1.5 dt 3 lc rgb '#777777' t 'N^3', " << start
           << "*(x/20)**4 w l lw 1.5 dt 4 lc rgb '#777777' t 'N^4'\n";
  }
  script << "  unset multiplot\n";
  return script.str();
}

}  // namespace

void measureRefinement(const Options& options) {
  const std::vector<int> grids = gridsOf(options);
  std::ostringstream csv;
  csv << "scene,method,grid,dt_s,seconds_per_second\n";
  std::vector<Costs> all;
  for (const char* name : kScenes) {
    all.push_back(costsOf(name, options));
    print(name, all.back(), grids);
    for (const auto& [method, row] : all.back()) {
      for (std::size_t k = 0; k < row.size(); ++k) {
        csv << name << "," << method << "," << grids[k] << "," << row[k].dt << "," << row[k].seconds << "\n";
      }
    }
  }
  std::printf("(backward-euler and xpbd have no limit: their step follows from the error that one accepts)\n");
  writeAndDraw(options, "refined", csv.str(), chartOf({std::begin(kScenes), std::end(kScenes)}, all));
}

}  // namespace tyg::scaling
