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

/// Whether a command takes one method, or several with commas between.
enum class MethodCount { One, Several };

/// A scene and what the command line changes in it.
struct SceneOptions {
  std::string scene = "curtain";
  std::optional<std::string> integrator, tolerance, precision, sheet;
  std::optional<double> dt, duration;  // s
  std::optional<int> threads;
  MethodCount methods = MethodCount::One;
};
/// Adds SCENE and --integrator, --dt, --tolerance, --duration, --precision, --threads, --sheet to a command.
/// `options` must live as long as `command`. `usual`: what the help says of the methods that are taken without
/// --integrator.
void addSceneOptions(Command& command, SceneOptions& options, MethodCount count = MethodCount::One,
                     const std::string& usual = "the scene's");
/// The scene with the overrides applied. Throws InputError.
Scene chosenScene(const SceneOptions& options);
Scene overridden(Scene scene, const SceneOptions& options);
/// The methods that --integrator names, each once; without it those of `usual`, else all. Throws InputError.
std::vector<const Method*> chosenMethods(const SceneOptions& options, const std::string& usual = {});

/// Which times of a run become frames; what is not given is the scene's or the command's own.
struct FrameOptions {
  std::optional<double> from, to;  // s
  std::optional<double> fps;       // frames to a simulated second
};
/// What the help calls frames, and how many of them there are to a second without --fps.
struct FrameWords {
  const char *frames, *framesAtFirst;
  double usualFps;
};
/// Adds --from, --to and --fps to a command. `options` must live as long as `command`.
void addFrameOptions(Command& command, FrameOptions& options, const FrameWords& words);
/// The times of the frames, s, both ends included. Throws InputError.
std::vector<double> chosenFrames(const FrameOptions& options, const Scene& scene, double usualFps);
/// Says on standard error where the last frame, at this time, s, is earlier than was asked for, or where it needs the
/// cloth to move on past the end of the run.
void sayLastFrame(const char* command, double last, const FrameOptions& options, const Scene& scene);

/// How to draw the cloth, besides what its scene says.
struct LookOptions {
  std::optional<std::string> show;
};
/// Adds --look to a command. `options` must live as long as `command`.
void addLookOption(Command& command, LookOptions& options);
/// How the command line wants the cloth drawn; nothing: as the scene has it. Throws InputError where the cloth is to be
/// drawn with a picture on it that cannot be read.
std::optional<Show> chosenShow(const LookOptions& options, const Scene& scene);

// Each adds its subcommand to `app`; when it is chosen, `action` is set.
void addViewCommand(CLI::App& app, Action& action);
void addRunCommand(CLI::App& app, Action& action);
void addRenderCommand(CLI::App& app, Action& action);
void addExportCommand(CLI::App& app, Action& action);
void addPlotCommand(CLI::App& app, Action& action);
void addChartCommand(CLI::App& app, Action& action);
void addStabilityCommand(CLI::App& app, Action& action);
void addLimitCommand(CLI::App& app, Action& action);
void addDietCommand(CLI::App& app, Action& action);
void addAdviseCommand(CLI::App& app, Action& action);
void addCheckCommand(CLI::App& app, Action& action);
void addReferenceCommand(CLI::App& app, Action& action);
void addListCommand(CLI::App& app, Action& action);

}  // namespace tyg
