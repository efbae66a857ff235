// The options that every simulating command shares: which scene, and what the command line changes in it.
#include <algorithm>

#include "app/commands/command_options.h"
#include "app/commands/commands.h"
#include "app/commands/option_checks.h"
#include "core/scene/scene_range.h"
#include "tyg/methods.h"
#include "util/text.h"

namespace tyg {
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
              "The same cloth on another grid of columns x rows; its size, mass and drag stay the same [the scene's]")
      .check(sheet)
      .typeName("CxR")
      .group("Scene");
}

Scene chosenScene(const SceneOptions& options) { return overridden(loadScene(options.scene, methodNames()), options); }

Scene overridden(Scene scene, const SceneOptions& options) {
  if (options.sheet) {
    const auto [columns, rows] = parsePair(*options.sheet);
    scene = withSheet(std::move(scene), columns, rows);
  }
  if (options.integrator) scene.integrator = findMethod(*options.integrator).name;
  if (options.precision) scene.precision = *options.precision == "float" ? Precision::Float : Precision::Double;
  scene.dt = options.dt.value_or(scene.dt);
  scene.tolerance = options.tolerance.value_or(scene.tolerance);
  scene.duration = options.duration.value_or(scene.duration);
  refuseExtremes(scene);
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
