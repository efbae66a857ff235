// The options that every simulating command shares: which scene, and what the command line changes in it.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "app/commands/command_options.h"
#include "app/commands/commands.h"
#include "app/commands/option_checks.h"
#include "tyg/methods.h"
#include "util/text.h"

namespace tyg {
namespace {

/// Whether a grid has the sides of another one, to within half a cell; cells stay square.
bool keepsSides(const Scene& scene, int columns, int rows) {
  const double wide = scene.columns - 1, tall = scene.rows - 1;
  const double cell = std::max(wide, tall) / std::max({columns - 1, rows - 1, 1});
  constexpr double kHalf = 0.5 + 1e-9;
  return std::abs((columns - 1) * cell - wide) <= kHalf * cell && std::abs((rows - 1) * cell - tall) <= kHalf * cell;
}

/// Throws InputError with the nearest grids that fit.
void refuseOtherSides(const Scene& scene, int columns, int rows) {
  const bool hasSides = std::max(scene.columns, scene.rows) > 1 && std::max(columns, rows) > 1;
  if (!hasSides || keepsSides(scene, columns, rows)) return;
  std::vector<std::string> fitting;
  const auto offer = [&](double width, double height) {
    const auto in = [](double count) { return count >= 1 && count <= kLargestCount; };
    if (!in(width) || !in(height) || !keepsSides(scene, int(width), int(height))) return;
    const std::string grid = fmt::format("{}x{}", int(width), int(height));
    if (std::ranges::find(fitting, grid) == fitting.end()) fitting.push_back(grid);
  };
  const double tallness = double(scene.rows - 1) / std::max(scene.columns - 1, 1);
  const double width = double(scene.columns - 1) / std::max(scene.rows - 1, 1);
  offer(columns, std::round((columns - 1) * tallness) + 1);
  offer(std::round((rows - 1) * width) + 1, rows);
  if (fitting.empty()) fitting.push_back(fmt::format("{}x{}", scene.columns, scene.rows));
  throw InputError(fmt::format(
      "--sheet: found {}x{}, which is not the shape of a sheet of {}x{} particles; allowed are grids with its sides, "
      "the nearest of which {} {}",
      columns, rows, scene.columns, scene.rows, fitting.size() > 1 ? "are" : "is", joined(fitting)));
}

}  // namespace
namespace {

constexpr int kMostParticlesAlongASide = 4096;
constexpr int kMostThreads = 1024;

void addNumbers(Command& command, SceneOptions& options) {
  const auto seconds = [](const std::string& text) { return checkPositive(text, "seconds, such as 0.002"); };
  const auto metres = [](const std::string& text) { return checkPositive(text, "metres, such as 1e-4"); };
  const auto threads = [](const std::string& text) { return checkCount(text, kMostThreads, "threads"); };
  command.option("--dt", options.dt, "Time step of a fixed-step method, in s [the scene's]")
      .check(seconds)
      .typeName("S")
      .group("Scene");
  command.option("--tolerance", options.tolerance, "Error that an adaptive method aims at, in m [the scene's]")
      .check(metres)
      .typeName("M")
      .group("Scene");
  command.option("--duration", options.duration, "Simulated time, in s [the scene's]")
      .check(seconds)
      .typeName("S")
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

void addSceneOptions(Command& command, SceneOptions& options, bool sceneRequired) {
  CommandOption scene =
      command.option("SCENE", options.scene,
                     std::string("A built-in scene (tyg list shows them) or the path of a .toml file") +
                         (sceneRequired ? "" : " [" + options.scene + "]"));
  scene.required(sceneRequired).typeName("");
  command.option("--integrator", options.integrator, "Method: " + joined(methodNames()) + " [the scene's]")
      .typeName("NAME")
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
    refuseOtherSides(scene, columns, rows);
    scene = withSheet(std::move(scene), columns, rows);
  }
  if (options.integrator) scene.integrator = findMethod(*options.integrator).name;
  if (options.precision) scene.precision = *options.precision == "float" ? Precision::Float : Precision::Double;
  scene.dt = options.dt.value_or(scene.dt);
  scene.tolerance = options.tolerance.value_or(scene.tolerance);
  scene.duration = options.duration.value_or(scene.duration);
  return scene;
}

std::vector<const Method*> chosenMethods(const std::string& list, const SceneOptions& options,
                                         const std::string& usual) {
  const std::string names = list.empty() ? options.integrator.value_or(usual) : list;
  std::vector<const Method*> chosen;
  for (const std::string& name : splitList(names)) {
    const Method* method = &findMethod(name, "--methods");
    if (std::ranges::find(chosen, method) == chosen.end()) chosen.push_back(method);
  }
  if (!chosen.empty()) return chosen;
  if (!names.empty()) throw InputError("--methods: found no name, allowed are methods' names with commas between");
  for (const Method& method : methods()) chosen.push_back(&method);
  return chosen;
}

}  // namespace tyg
