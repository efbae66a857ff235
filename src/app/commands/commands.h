// The commands of the program, one file each, and the scene options that all of them share.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tyg/method.h"
#include "tyg/scene.h"

namespace CLI {
class App;
}

namespace tyg {

class Command;

/// What the chosen command does once the whole command line is understood; the result is the exit code.
/// It throws InputError for wrong input (exit code 2).
using Action = std::function<int()>;

/// A scene and what the command line changes in it.
struct SceneOptions {
  std::string scene = "curtain";
  std::optional<std::string> integrator, precision, sheet;
  std::optional<double> dt, tolerance, duration;
  std::optional<int> threads;
};
/// Adds SCENE and --integrator, --dt, --tolerance, --duration, --precision, --threads, --sheet to a command.
/// `options` must live as long as `command`.
void addSceneOptions(Command& command, SceneOptions& options, bool sceneRequired = true);
/// The scene with the overrides applied. Throws InputError.
Scene chosenScene(const SceneOptions& options);
Scene overridden(Scene scene, const SceneOptions& options);
/// The methods that --methods names, each once; where it is empty the one of --integrator, else those of `usual`, else
/// all. Throws InputError.
std::vector<const Method*> chosenMethods(const std::string& list, const SceneOptions& options,
                                         const std::string& usual = {});

// Each adds its subcommand to `app`; when it is chosen, `action` is set.
void addViewCommand(CLI::App& app, Action& action);
void addRunCommand(CLI::App& app, Action& action);
void addRenderCommand(CLI::App& app, Action& action);
void addPlotCommand(CLI::App& app, Action& action);
void addChartCommand(CLI::App& app, Action& action);
void addStabilityCommand(CLI::App& app, Action& action);
void addDietCommand(CLI::App& app, Action& action);
void addAdviseCommand(CLI::App& app, Action& action);
void addListCommand(CLI::App& app, Action& action);

}  // namespace tyg
