// `tyg view`: its options, the record of the run, and what happens where no window can be opened.
#include <functional>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "app/commands/command_options.h"
#include "app/commands/commands.h"
#include "app/commands/device_options.h"
#include "app/commands/option_checks.h"
#include "app/output/exit_code.h"
#include "app/output/render.h"
#include "ui/frame_loop.h"
#include "util/amounts.h"
#include "util/calibration_clock.h"
#include "util/interrupt.h"
#include "util/sudden_end.h"
#include "util/whole_file.h"
#include "viewer/cure.h"
#include "viewer/viewer.h"
#include "viewer/window_memory.h"

namespace tyg {
namespace {

constexpr int kMostPixels = 16384;
constexpr const char* kUsualSize = "1280x720";

std::string checkSize(const std::string& text) {
  return checkPair(text, kMostPixels, "width x height in pixels, such as 1280x720");
}

struct ViewOptions {
  SceneOptions scene;
  DeviceOptions device;
  std::string window = "glfw";
  std::optional<double> uiScale;
  std::optional<std::string> size, log, record;
  bool light = false;
  LookOptions look;
};

/// Pixels: as asked for, else as remembered, else the usual size.
std::string sizeOf(const ViewOptions& options, WindowMemory& memory) {
  if (options.size) return *options.size;
  std::string remembered = memory.find("size").value_or(kUsualSize);
  if (checkSize(remembered).empty()) return remembered;
  memory.refuse("size");
  return kUsualSize;
}

OpeningOptions openingOptions(const ViewOptions& options, WindowMemory& memory) {
  const auto [width, height] = parsePair(sizeOf(options, memory));
  return {.library = options.window == "glut" ? WindowLibrary::Glut : WindowLibrary::Glfw,
          .size = {.width = width, .height = height},
          .uiScale = options.uiScale.value_or(1)};
}

/// Xlib ends the program itself where its display has gone.
void sayAndKeep(const std::function<void()>& keep) {
  try {
    keep();
    std::cerr << "tyg view: the display has gone, and the window with it" << std::endl;
  } catch (const std::exception& error) {
    std::cerr << "tyg view: the display has gone; " << error.what() << std::endl;
  }
}

int renderWithoutWindow(const ViewOptions& options, const Scene& scene, const NoDisplay& why) {
  std::cerr << "tyg view: " << why.what() << "; drawing off-screen instead" << std::endl;
  if (options.log || options.record)
    std::cerr << "tyg view: without a window nothing is logged or recorded" << std::endl;
  const auto [width, height] = parsePair(options.size.value_or(kUsualSize));
  RenderRequest like;
  like.size = {width, height};
  like.draw.background = options.light ? Background::Light : Background::Dark;
  like.threads = options.scene.threads.value_or(0);
  like.show = chosenShow(options.look, scene);
  if (options.device.asksForCard()) {
    like.chooseDevice = [&](Offscreen::Find drawing) {
      return chosenDevice(options.device, scene, like.threads, "tyg view", drawing).device;
    };
  }
  return renderInstead(scene, like);
}

/// A window that cannot be opened, or a driver that refuses the shaders.
int sayNoWindow(const std::runtime_error& why) {
  std::cerr << "tyg view: " << why.what() << "; tyg render draws without a window" << std::endl;
  return kSimulationFailed;
}

int show(const ViewOptions& options, const Scene& scene, const std::string& said, OpeningWindow& opening,
         WindowMemory& memory) {
  const int threads = options.scene.threads.value_or(0);
  const GlFinder drawing = opening.window().finder();
  const ChosenDevice chosen = chosenDevice(options.device, scene, threads, "tyg view", drawing);
  Viewer viewer(scene, Settings{.threads = threads, .device = chosen.device}, wallClock);
  viewer.scenes().offerCard([=](const Scene& moved) { return offeredCard(moved, threads, drawing); });
  if (chosen.device) viewer.notes().say(sentenceOn(chosen.report));
  if (options.light) viewer.perform(InputAction::ChangeBackground);
  if (const auto show = chosenShow(options.look, scene)) viewer.show(*show);
  if (!said.empty()) viewer.notes().warn(said);
  bool kept = false;
  const auto keep = [&options, &kept](const EventLog& log) {
    kept = true;
    if (options.record) writeWholeFile(*options.record, formatEventLog(log));
  };
  viewer.run().onRunEnd(keep);
  // A run that was never started does not replace the one before the restart.
  const auto keepWhatRan = [&viewer, &keep] {
    if (const EventLog log = viewer.run().record(); log.ticks > 0) keep(log);
  };
  // Of a large sheet a frame may take longer than that, and a record is worth its end.
  constexpr double kForTheRecord = 60;  // s
  const InterruptWatch watch(options.record ? kForTheRecord : InterruptWatch::kPatience);
  ignoreClosedPipes();  // whoever reads the messages may leave before the window does
  const AtExit recordFirst([&] { sayAndKeep(keepWhatRan); });
  try {
    const std::string left = FrameLoop(opening, viewer, memory, options.log).run();
    if (!left.empty()) std::cerr << "tyg view: " << left << std::endl;
  } catch (const InputError&) {
    keepWhatRan();
    throw;
  } catch (const std::runtime_error& error) {
    keepWhatRan();
    return sayNoWindow(error);
  }
  keepWhatRan();
  if (!kept) keep(viewer.run().record());
  return interrupted() ? kInterrupted : kDone;
}

int view(const ViewOptions& options) {
  Scene scene = chosenScene(options.scene);
  takeFloatOnCard(scene, options.device, options.scene.precision.has_value());
  (void)chosenShow(options.look, scene);  // refuses a picture that cannot be read before a window opens
  // A scene's own step is for its own sheet. One that was asked for is taken, and the window tells its limit.
  const std::string said = options.scene.sheet && !options.scene.dt ? takeStepThatHolds(scene) : "";
  if (options.log) checkWritable(*options.log);
  if (options.record) checkWritable(*options.record);
  WindowMemory memory(options.log ? std::nullopt : windowMemoryFile());
  std::optional<OpeningWindow> opening;
  try {
    opening.emplace(openingOptions(options, memory), scene);
  } catch (const NoDisplay& error) {
    return renderWithoutWindow(options, scene, error);
  } catch (const WindowError& error) {
    return sayNoWindow(error);
  }
  return show(options, scene, said, *opening, memory);
}

double parseScale(const std::string& text) {
  const double scale = parseShare("--ui-scale", text);
  if (scale >= 0.25 && scale <= 8) return scale;
  throw InputError("--ui-scale: found '" + text + "', allowed is a number from 0.25 to 8; 1 is the ordinary size");
}

}  // namespace

void addViewCommand(CLI::App& app, Action& action) {
  Command command(app, "view", "The window: space starts and pauses, a left click pushes the cloth, F1 shows all keys");
  auto options = std::make_shared<ViewOptions>();
  addSceneOptions(command, options->scene);
  addDeviceOption(command, options->device);
  command.option("--window", options->window, "Library that opens the window [glfw]")
      .check([](const std::string& text) {
        return checkOneOf(text, {"glfw", "glut"});
      })
      .typeName("glfw|glut");
  command.option("--size", options->size, "Pixels of the window [as it was last, at first 1280x720]")
      .check(checkSize)
      .typeName("WxH");
  command
      .amount("--ui-scale", options->uiScale, parseScale,
              "Size of text and lines, on top of the screen's own scale [1]")
      .typeName("X");
  command.flag("--light", options->light, "Begin with a light background; B changes it");
  command.option("--log", options->log, "Write one CSV line a frame here, for scripts that watch the window")
      .typeName("FILE.csv");
  command.option("--record", options->record, "Write the run here, its scene, pushes and changes, for tyg run --replay")
      .typeName("FILE");
  addLookOption(command, options->look);
  command.onChosen([&action, options] { action = [options] { return view(*options); }; });
}

}  // namespace tyg
