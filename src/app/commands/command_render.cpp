// `tyg render`: a picture, a sequence of pictures or a movie of a scene, without a display.
#include <memory>
#include <optional>

#include <fmt/core.h>

#include "app/commands/command_options.h"
#include "app/commands/commands.h"
#include "app/commands/device_options.h"
#include "app/commands/option_checks.h"
#include "app/output/render.h"
#include "study/motion/telling_moment.h"
#include "util/amounts.h"
#include "util/file_names.h"

namespace tyg {
namespace {

constexpr int kMostPixels = 16384;

struct RenderOptions {
  SceneOptions scene;
  DeviceOptions device;
  std::optional<double> at;
  FrameOptions frames;
  std::string size = "1280x720";
  std::optional<std::string> out;
  bool light = false;
  LookOptions look;
};

constexpr const char* kExamples =
    R"(Without --at, --from and --to there is one picture, of a time that shows what the scene is about.
Where --out is a movie or a folder, the whole run is drawn. A movie needs ffmpeg; a folder of PNG
pictures needs nothing.

Examples:
  tyg render curtain                                   curtain.png
  tyg render poke --at 0.6 --out poke.png --light      on a light background, for print
  tyg render flag --from 0 --to 3 --fps 60 --out flag.mp4
  tyg render hammock --out frames                      numbered pictures)";

std::vector<double> chosenTimes(const Scene& scene, const RenderOptions& options) {
  const FrameOptions& frames = options.frames;
  if (options.at && (frames.from || frames.to)) {
    throw InputError(
        "found --at together with --from or --to, allowed is --at for one picture or --from and --to for "
        "several");
  }
  const std::string out = options.out.value_or("");
  const bool isPicture = out.empty() || endingOf(out) == ".png";
  if (options.at) return {*options.at};
  if (!frames.from && !frames.to && isPicture) return {tellingMoment(scene)};
  const double usualFps = RenderRequest{}.fps;
  std::vector<double> times = chosenFrames(frames, scene, usualFps);
  if (times.size() == 1 && !isPicture) {
    throw InputError(fmt::format(
        "--to: found less than one frame after --from, allowed for a movie or a folder is {:.4g} s or more at {:.4g} "
        "pictures per second",
        times.front() + 1 / frames.fps.value_or(usualFps), frames.fps.value_or(usualFps)));
  }
  return times;
}

int renderChosen(const RenderOptions& options) {
  Scene scene = chosenScene(options.scene);
  takeFloatOnCard(scene, options.device, options.scene.precision.has_value());
  RenderRequest request;
  request.show = chosenShow(options.look, scene);
  request.times = chosenTimes(scene, options);
  sayLastFrame("tyg render", request.times.back(), options.frames, scene);
  request.fps = options.frames.fps.value_or(request.fps);
  const auto [width, height] = parsePair(options.size);
  request.size = {width, height};
  request.out = options.out.value_or(fileStem(scene.name) + (request.times.size() > 1 ? "" : ".png"));
  request.draw.background = options.light ? Background::Light : Background::Dark;
  request.threads = options.scene.threads.value_or(0);
  if (options.device.asksForCard()) {
    request.chooseDevice = [&](Offscreen::Find drawing) {
      return chosenDevice(options.device, scene, request.threads, "tyg render", drawing).device;
    };
  }
  return render(scene, request);
}

}  // namespace

void addRenderCommand(CLI::App& app, Action& action) {
  Command command(app, "render", "Draw a picture, a sequence or a movie, without a display");
  const auto options = std::make_shared<RenderOptions>();
  addSceneOptions(command, options->scene);
  addDeviceOption(command, options->device);
  const auto time = [](const std::string& text) { return parseTime("--at", text, Zero::Allowed); };
  command.amount("--at", options->at, time, "One picture at this simulated time").typeName("TIME");
  addFrameOptions(command, options->frames, {"pictures", "Pictures", RenderRequest{}.fps});
  command.option("--size", options->size, "Pixels of each picture, width x height [1280x720]")
      .typeName("WxH")
      .check([](const std::string& text) { return checkPair(text, kMostPixels, "pixels, such as 1280x720"); });
  command.option("--out", options->out, "FILE.png, FILE.mp4, FILE.gif or a folder [SCENE.png, or the folder SCENE]")
      .typeName("PATH");
  command.flag("--light", options->light, "A light background");
  addLookOption(command, options->look);
  command.footer(kExamples);
  command.onChosen([options, &action] { action = [options] { return renderChosen(*options); }; });
}

}  // namespace tyg
