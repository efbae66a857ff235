// `tyg view`: opens the window and runs its frame loop, or draws off-screen where there is no display.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "app/command_line.h"
#include "app/commands/commands.h"
#include "app/commands/option_checks.h"
#include "app/output/render.h"
#include "gfx/contexts/offscreen.h"
#include "gfx/passes/sheet_renderer.h"
#include "ui/hud.h"
#include "ui/keeper.h"
#include "ui/windows/window.h"
#include "util/calibration_clock.h"
#include "util/interrupt.h"
#include "util/whole_file.h"
#include "viewer/hints.h"
#include "viewer/view_log.h"
#include "viewer/viewer.h"

namespace tyg {
namespace {

constexpr int kMostPixels = 16384;
/// While nothing moves the loop wakes this often, for the log's ten lines a second.
constexpr double kIdleSeconds = 0.08;
/// Frames shown after an event: panels find their size and place over a few of them.
constexpr int kFramesToSettle = 4;
/// And this often without a log, to notice an interrupt.
constexpr double kAsleepSeconds = 0.25;
/// Frames come no faster than this where the screen sets no rhythm.
constexpr double kShortestFrame = 1.0 / 250;

struct ViewOptions {
  SceneOptions scene;
  std::string window = "glfw", size = "1280x720", uiScale = "1";
  std::optional<std::string> log, record;
};

std::string titleOf(const Scene& scene) { return "Tyg: " + scene.title; }

std::unique_ptr<Window> openWindow(const ViewOptions& options, const Scene& scene) {
  const auto [width, height] = parsePair(options.size);
  const WindowOptions wanted{.title = titleOf(scene), .size = {.width = width, .height = height}};
  return options.window == "glut" ? openGlutWindow(wanted) : openGlfwWindow(wanted);
}

/// The window, what is drawn in it and what is written about it.
class View {
 public:
  View(const ViewOptions& options, const Scene& scene, Viewer& viewer)
      : viewer_(viewer),
        window_(openWindow(options, scene)),
        renderer_(std::make_unique<SheetRenderer>(viewer.simulation().sheet())),
        drawnSheet_(viewer.sheetsSoFar()),
        hud_(*window_, std::stod(options.uiScale)),
        panels_(hud_.textSize(), viewer),
        hints_(options.log ? std::nullopt : hintsFile()),
        opened_(wallClock()) {
    if (options.log) log_ = std::make_unique<ViewLog>(*options.log);
  }

  void run() {
    while (!window_->closeRequested() && !viewer_.leaving() && !interrupted()) {
      const double began = wallClock();
      takeEvents();
      viewer_.resize(window_->framebuffer(), margins());
      const bool moving = !viewer_.idle() || panels_.busy();
      viewer_.frame();
      panels_.follow(viewer_);
      if (stale_ > 0 || moving || !viewer_.idle()) show();
      writeLog();
      spare_ = std::max(0.0, kShortestFrame - (wallClock() - began));
    }
    try {
      if (const std::string end = keeper_.endMovie(); !end.empty()) std::cerr << "tyg view: " << end << std::endl;
    } catch (const InputError& error) {
      std::cerr << "tyg view: " << error.what() << std::endl;
    }
  }

 private:
  void takeEvents() {
    const bool hidden = shown_ == Extent{};
    const double rest = log_ ? kIdleSeconds : kAsleepSeconds;
    const double patience = viewer_.idle() || hidden ? rest : spare_;
    for (const WindowEvent& event : window_->events(stale_ > 0 || panels_.busy() ? spare_ : patience)) {
      stale_ = kFramesToSettle;
      if (hud_.takes(event) || panels_.handle(event, viewer_) || hud_.handle(event, viewer_) || keeps(event)) continue;
      viewer_.handle(event);
    }
    if (window_->framebuffer() != shown_) stale_ = kFramesToSettle;
  }

  /// Something is to be kept in a file: at the next frame.
  bool keeps(const WindowEvent& event) {
    const Input* input = event.kind == WindowEvent::Kind::Press && !event.control ? findInput(event.key) : nullptr;
    if (input == nullptr) return false;
    picture_ = picture_ || input->action == InputAction::KeepPicture;
    film_ = film_ != (input->action == InputAction::Film);
    return input->action == InputAction::KeepPicture || input->action == InputAction::Film;
  }

  /// What a deed with files said, or why it failed.
  template <class Deed>
  void tell(const Deed& deed) {
    try {
      if (std::string said = deed(); !said.empty()) viewer_.note(std::move(said));
    } catch (const std::exception& error) {
      viewer_.warn(error.what());
    }
  }

  /// The cloth alone, without the text over it.
  void film() {
    if (std::exchange(film_, false)) {
      tell([this]() -> std::string {
        if (keeper_.filming()) return keeper_.endMovie();
        keeper_.beginMovie(viewer_.scene().name, shown_.width, shown_.height);
        return {};
      });
    }
    if (!keeper_.filming()) return;
    readFramebuffer(shown_.width, shown_.height, pixels_);
    tell([this] { return keeper_.film(pixels_, wallClock()); });
  }

  /// What the window shows, text included.
  void keepPicture() {
    if (viewer_.seeking() || !std::exchange(picture_, false)) return;  // what is shown is left at this moment
    readFramebuffer(shown_.width, shown_.height, pixels_);
    tell([this] { return keeper_.keep(pixels_, viewer_.recordShown()); });
  }

  void giveNotice() {
    if (viewer_.pushes() > 0) hints_.did(Hints::Deed::Poke);
    if (panels_.isOpen(InputAction::OpenChart)) hints_.did(Hints::Deed::Chart);
    if (panels_.isOpen(InputAction::OpenGhost)) hints_.did(Hints::Deed::Ghost);
    std::array<char, 160> text{};
    if (keeper_.filming()) {
      std::snprintf(text.data(), text.size(), "filming into %s  \u00b7  %.1f s  \u00b7  Z ends it",
                    keeper_.movieName().c_str(), keeper_.filmed());
    }
    hud_.filming(text.data());
    hud_.notice(viewer_.state() == RunState::Running ? hints_.show(wallClock()) : std::string_view());
  }

  /// Where an edge has panels, they are there instead of the keys.
  [[nodiscard]] Margins margins() const {
    const int keys = viewer_.showsHelp() ? hud_.margin() : 0;
    const auto at = [&](Edge edge) { return panels_.width(edge) > 0 ? static_cast<int>(panels_.width(edge)) : keys; };
    return {.left = at(Edge::Left), .right = at(Edge::Right), .beside = panels_.beside()};
  }

  void drawSheet() {
    if (drawnSheet_ != viewer_.sheetsSoFar()) {
      renderer_ = std::make_unique<SheetRenderer>(viewer_.simulation().sheet());
      window_->setTitle(titleOf(viewer_.scene()));
      drawnSheet_ = viewer_.sheetsSoFar();
    }
    ClothPicture picture{.options = viewer_.drawOptions()};
    panels_.paint(picture);
    const glm::ivec2 pixels{shown_.width, shown_.height};
    renderer_->draw(viewer_.positions(), viewer_.camera(), pixels, picture.options, viewer_.shownPush());
    if (picture.ghost.size() != viewer_.positions().size()) return;
    const bool dark = picture.options.background == Background::Dark;
    renderer_->draw(picture.ghost, viewer_.camera(), pixels,
                    {.pins = false,
                     .background = picture.options.background,
                     .mesh = dark ? rgb(0xf4f6f8) : rgb(0x20242a),
                     .over = true,
                     .opacity = picture.ghostOpacity});
  }

  /// Trouble while drawing is shown by the text that is drawn over it.
  void show() {
    shown_ = window_->framebuffer();
    stale_ = std::max(0, stale_ - 1);
    if (window_->closeRequested() || shown_.width <= 0 || shown_.height <= 0) return;
    try {
      drawSheet();
    } catch (const std::exception& error) {
      viewer_.freeze(error.what());
    }
    film();
    giveNotice();
    hud_.draw(viewer_, panels_);
    keepPicture();
    window_->swap();
  }

  void writeLog() {
    ++frame_;
    if (!log_) return;
    try {
      ViewLogLine line = viewer_.logLine();
      line.frame = frame_;
      line.wall = wallClock() - opened_;
      log_->write(line);
    } catch (const std::exception& error) {
      log_.reset();
      viewer_.warn(error.what());
      stale_ = kFramesToSettle;
    }
  }

  Viewer& viewer_;
  std::unique_ptr<Window> window_;
  std::unique_ptr<SheetRenderer> renderer_;
  int drawnSheet_;
  Hud hud_;
  Panels panels_;
  Hints hints_;
  Keeper keeper_{std::filesystem::current_path()};
  Picture pixels_;
  bool picture_ = false, film_ = false;  ///< asked for
  std::unique_ptr<ViewLog> log_;
  double opened_, spare_ = 0;
  std::int64_t frame_ = 0;
  int stale_ = kFramesToSettle;  ///< frames to show, because something happened
  Extent shown_;
};

int view(const ViewOptions& options) {
  const Scene scene = chosenScene(options.scene);
  if (options.log) checkWritable(*options.log);
  if (options.record) checkWritable(*options.record);
  Viewer viewer(scene, Settings{.threads = options.scene.threads.value_or(0)}, wallClock);
  bool kept = false;
  const auto keep = [&options, &kept](const EventLog& log) {
    kept = true;
    if (options.record) writeWholeFile(*options.record, formatEventLog(log));
  };
  viewer.onRunEnd(keep);
  // A run that was never started does not replace the one before the restart.
  const auto keepWhatRan = [&viewer, &keep] {
    if (const EventLog log = viewer.record(); log.ticks > 0) keep(log);
  };
  const InterruptWatch watch;
  try {
    View(options, scene, viewer).run();
  } catch (const NoDisplay& error) {
    std::cerr << "tyg view: " << error.what() << "; drawing off-screen instead" << std::endl;
    if (options.log || options.record)
      std::cerr << "tyg view: without a window nothing is logged or recorded" << std::endl;
    const auto [width, height] = parsePair(options.size);
    RenderRequest like;
    like.size = {width, height};
    like.threads = options.scene.threads.value_or(0);
    return renderInstead(scene, like);
  } catch (const InputError&) {
    keepWhatRan();
    throw;
  } catch (const std::runtime_error& error) {  // no such window, or a driver that refuses the shaders
    keepWhatRan();
    std::cerr << "tyg view: " << error.what() << "; tyg render draws without a window" << std::endl;
    return kSimulationFailed;
  }
  keepWhatRan();
  if (!kept) keep(viewer.record());
  return interrupted() ? kInterrupted : kDone;
}

std::string checkScale(const std::string& text) {
  std::string complaint = checkPositive(text, "1 is the ordinary size of text, 1.5 half as much again");
  if (!complaint.empty()) return complaint;
  const double scale = std::stod(text);
  return scale >= 0.25 && scale <= 8 ? "" : "found '" + text + "', allowed is a number from 0.25 to 8";
}

}  // namespace

void addViewCommand(CLI::App& app, Action& action) {
  auto* command =
      app.add_subcommand("view", "The window: space starts and pauses, a left click pokes, H shows the keys");
  auto options = std::make_shared<ViewOptions>();
  addSceneOptions(*command, options->scene, false);
  const auto size = [](const std::string& text) {
    return checkPair(text, kMostPixels, "width x height in pixels, such as 1280x720");
  };
  command->add_option("--window", options->window, "Library that opens the window [glfw]")
      ->check([](const std::string& text) {
        return checkOneOf(text, {"glfw", "glut"});
      })
      ->type_name("glfw|glut");
  command->add_option("--size", options->size, "Pixels of the window [1280x720]")->check(size)->type_name("WxH");
  command->add_option("--ui-scale", options->uiScale, "Size of the text, on top of the screen's own scale [1]")
      ->check(checkScale)
      ->type_name("X");
  command->add_option("--log", options->log, "Write one CSV line a frame here, for scripts that watch the window")
      ->type_name("FILE.csv");
  command
      ->add_option("--record", options->record,
                   "Write the run here, its scene, pushes and changes, for tyg run --replay")
      ->type_name("FILE");
  command->callback([&action, options] { action = [options] { return view(*options); }; });
}

}  // namespace tyg
