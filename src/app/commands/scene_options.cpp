// The options that every simulating command shares: which scene, and what the command line changes in it.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "app/commands/command_options.h"
#include "app/commands/commands.h"
#include "app/commands/option_checks.h"
#include "core/scene/bodies.h"
#include "core/scene/same_sides.h"
#include "core/scene/scene_range.h"
#include "tyg/methods.h"
#include "util/amounts.h"
#include "util/text.h"

namespace tyg {
namespace {

constexpr int kMostParticlesAlongASide = 4096;
constexpr int kMostThreads = 1024;

/// Throws InputError with the nearest grids that fit.
void refuseOtherSides(const Scene& scene, const Grid& grid) {
  const bool hasSides = std::max(scene.columns, scene.rows) > 1 && std::max(grid.columns, grid.rows) > 1;
  if (hasSides && !keepsSides(scene, grid)) throw InputError("--sheet: " + otherSides(scene, grid, kLargestCount));
}

/// A method of fixed steps does not use it.
void refuseCoarseTolerance(const Scene& scene) {
  if (!(scene.tolerance > largestTolerance(scene)) || !findMethod(scene.integrator).adaptive) return;
  throw InputError(fmt::format("--tolerance: found {:g} m, the tolerance for {}, allowed is {}", scene.tolerance,
                               scene.integrator, largestToleranceInWords(scene)));
}

void addNumbers(Command& command, SceneOptions& options) {
  const auto threads = [](const std::string& text) { return checkCount(text, kMostThreads, "threads"); };
  const auto time = [](const char* option) { return [=](const std::string& text) { return parseTime(option, text); }; };
  command.amount("--dt", options.dt, time("--dt"), "Time step of a fixed-step method, such as 2ms [the scene's]")
      .typeName("TIME")
      .group("Scene");
  command.option("--tolerance", options.tolerance, "Error that an adaptive method aims at, such as 0.1mm [the scene's]")
      .typeName("LENGTH")
      .group("Scene");
  command.amount("--duration", options.duration, time("--duration"), "Simulated time, such as 5s [the scene's]")
      .typeName("TIME")
      .group("Scene");
  command
      .option(
          "--threads", options.threads,
          "Threads that share the rows of the sheet; more than there are cores is allowed, and the result is the same "
          "[1 for small sheets, else every core]")
      .check(threads)
      .typeName("N")
      .group("Scene");
}

}  // namespace

void addSceneOptions(Command& command, SceneOptions& options, MethodCount count, const std::string& usual) {
  command
      .option("SCENE", options.scene,
              "A built-in scene (tyg list shows them) or the path of a .toml file [" + options.scene + "]")
      .typeName("");
  const bool one = count == MethodCount::One;
  options.methods = count;
  command
      .option("--integrator,--methods", options.integrator,
              (one ? "Method: " : "Methods with commas between: ") + joined(methodNames()) + " [" + usual + "]")
      .typeName(one ? "NAME" : "NAME,...")
      .group("Scene");
  addNumbers(command, options);
  command
      .option("--precision", options.precision,
              "Numbers of 32 bits (float, faster) or of 64 bits (double, more exact) [the scene's]")
      .check([](const std::string& text) {
        return checkOneOf(text, {"float", "double"});
      })
      .typeName("float|double")
      .group("Scene");
  const auto sheet = [](const std::string& text) {
    return checkPair(text, kMostParticlesAlongASide, "columns x rows, such as 40x30");
  };
  command
      .option("--sheet", options.sheet,
              "The same cloth on another grid of columns x rows; both sides, mass and drag stay the same [the scene's]")
      .check(sheet)
      .typeName("CxR")
      .group("Scene");
}

Scene chosenScene(const SceneOptions& options) { return overridden(loadScene(options.scene, methodNames()), options); }

Scene overridden(Scene scene, const SceneOptions& options) {
  if (options.sheet) {
    const auto [columns, rows] = parsePair(*options.sheet);
    refuseOtherSides(scene, {columns, rows});
    scene = withSheet(std::move(scene), columns, rows);
  }
  const bool list = options.methods == MethodCount::Several && options.integrator &&
                    options.integrator->find(',') != std::string::npos;
  if (options.integrator && !list) scene.integrator = findMethod(*options.integrator, "--integrator").name;
  if (options.precision) scene.precision = *options.precision == "float" ? Precision::Float : Precision::Double;
  if (options.tolerance) scene.tolerance = parseLength("--tolerance", *options.tolerance, makeSheet(scene).size());
  refuseCoarseTolerance(scene);
  scene.dt = options.dt.value_or(scene.dt);
  scene.duration = options.duration.value_or(scene.duration);
  if (scene.duration / scene.dt > kMostSteps) {
    throw InputError(
        fmt::format("--dt, --duration: found {:g} s and {:g} s, which make {:.3g} steps; allowed are up to {:g}",
                    scene.dt, scene.duration, scene.duration / scene.dt, kMostSteps));
  }
  refuseExtremes(scene);
  refuseUnfitBodies(scene);
  return scene;
}

std::vector<const Method*> chosenMethods(const SceneOptions& options, const std::string& usual) {
  constexpr const char* kOption = "--integrator or --methods";
  const std::string names = options.integrator.value_or(usual);
  std::vector<const Method*> chosen;
  for (const std::string& name : splitList(names)) {
    const Method* method = &findMethod(name, kOption);
    if (std::ranges::find(chosen, method) == chosen.end()) chosen.push_back(method);
  }
  if (!chosen.empty()) return chosen;
  if (!names.empty()) {
    throw InputError(fmt::format("{}: found no name, allowed are methods' names with commas between", kOption));
  }
  for (const Method& method : methods()) chosen.push_back(&method);
  return chosen;
}

}  // namespace tyg
