// `tyg export`: the moving cloth as files for other programs.
#include <memory>
#include <optional>

#include <fmt/core.h>

#include "app/commands/command_options.h"
#include "app/commands/commands.h"
#include "app/output/export.h"
#include "util/file_names.h"

namespace tyg {
namespace {

struct ExportOptions {
  SceneOptions scene;
  FrameOptions frames;
  std::optional<std::string> out;
};

constexpr const char* kExamples =
    R"(FILE.usda is a text file of USD, which Blender and usdview open: metres, y up, and the time code
of each frame is its number, counted from --from. A folder gets frame_00000.obj and on.
The cloth is one mesh whose faces stay the same; its first points are the particles in their order.
A scene in which the cloth is cut or tears is simulated twice, so that its cuts can open.

Examples:
  tyg export curtain                                   curtain.usda
  tyg export flag --from 1 --to 3 --fps 30 --out flag.usda
  tyg export tablecloth --out frames                   numbered OBJ files

Exit codes: 0 done; 1 the run became unstable; 2 wrong input or usage; 130 interrupted by Ctrl-C.
After 1, 2 and 130 nothing is written.)";

int exportChosen(const ExportOptions& options) {
  const Scene scene = chosenScene(options.scene);
  ExportRequest request;
  request.times = chosenFrames(options.frames, scene, request.fps);
  sayLastFrame("tyg export", request.times.back(), options.frames, scene);
  request.fps = options.frames.fps.value_or(request.fps);
  request.out = options.out.value_or(fileStem(scene.name) + ".usda");
  request.threads = options.scene.threads.value_or(0);
  return exportScene(scene, request);
}

}  // namespace

void addExportCommand(CLI::App& app, Action& action) {
  Command command(app, "export", "Write the moving cloth for other programs, as USD or OBJ");
  const auto options = std::make_shared<ExportOptions>();
  addSceneOptions(command, options->scene);
  addFrameOptions(command, options->frames, {"frames", "Frames", ExportRequest{}.fps});
  command.option("--out", options->out, "FILE.usda or a folder [SCENE.usda]").typeName("PATH");
  command.footer(kExamples);
  command.onChosen([options, &action] { action = [options] { return exportChosen(*options); }; });
}

}  // namespace tyg
