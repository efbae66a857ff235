// While the cloth moves a frame follows the next; else the loop sleeps until an event, and wakes now and then for the
// log and for an interrupt.
#include "ui/frame_loop.h"

#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <exception>
#include <filesystem>
#include <utility>

#include <fmt/core.h>
#include <imgui.h>

#include "core/scene/look_keys.h"
#include "gfx/picture.h"
#include "util/calibration_clock.h"
#include "util/interrupt.h"

namespace tyg {
namespace {

/// While nothing moves the loop wakes this often, s: for the log's ten lines a second, or, without a log, to notice an
/// interrupt.
constexpr double kIdleSeconds = 0.08, kAsleepSeconds = 0.25;
/// Frames shown after an event: panels find their size and position over a few of them.
constexpr int kFramesToSettle = 4;
/// Frames come no faster than this where the screen sets no rhythm, s.
constexpr double kShortestFrame = 1.0 / 250;

}  // namespace

FrameLoop::FrameLoop(OpeningWindow& opening, Viewer& viewer, WindowMemory& memory,
                     const std::optional<std::string>& log)
    : viewer_(viewer),
      memory_(memory),
      window_(opening.window()),
      imgui_(opening.imgui()),
      painter_(viewer, imgui_.scale()),
      hud_(imgui_.fonts()),
      panels_(imgui_.fonts().size, viewer),
      capture_(std::filesystem::current_path()),
      router_(windowRouter(panels_, hud_, capture_, viewer)),
      hints_(log ? std::nullopt : hintsFile()),
      log_(log ? std::make_unique<ViewLog>(*log) : nullptr),
      title_(windowTitle(viewer.scenes().scene())),
      image_(viewer.scenes().scene().look.image),
      opened_(wallClock()),
      stale_(kFramesToSettle) {
  recall();
  // Whoever asks for a position has the state brought from a card that computes in the window's context.
  window_.beforeContextEnds([this] { (void)viewer_.run().simulation().position(0); });
}

void FrameLoop::recall() {
  if (const auto ground = memory_.find("background")) {
    if (*ground != "light" && *ground != "dark") memory_.refuse("background");
    const bool isDark = viewer_.view().drawOptions().background == Background::Dark;
    if (*ground == "light" && isDark) viewer_.perform(InputAction::ChangeBackground);
  }
  if (const auto look = memory_.find("look"); look && !viewer_.view().chosenShow()) {
    constexpr std::array kAll{Show::Lines, Show::Surface, Show::Both};
    const auto* const found = std::ranges::find(kAll, *look, [](Show show) { return nameOf(show); });
    found == kAll.end() ? memory_.refuse("look") : viewer_.show(*found);
  }
  if (!memory_.trouble().empty()) viewer_.notes().warn(memory_.trouble());
  background_ = viewer_.view().drawOptions().background, look_ = viewer_.view().chosenShow();
}

/// What the command line asked for is not remembered, until the person changes it.
void FrameLoop::remember() {
  const Background background = viewer_.view().drawOptions().background;
  if (background != background_) memory_.keep("background", background == Background::Light ? "light" : "dark");
  if (const auto show = viewer_.view().chosenShow(); show && show != look_) {
    memory_.keep("look", std::string(nameOf(*show)));
  }
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  if (size.x >= 1 && size.y >= 1 && !fullScreen_) memory_.keep("size", fmt::format("{:.0f}x{:.0f}", size.x, size.y));
}

std::string FrameLoop::run() {
  while (!window_.closeRequested() && !viewer_.leaving() && !interrupted()) {
    const double began = wallClock();
    takeEvents();
    if (window_.closeRequested()) break;  // perhaps without a context from now on
    const Insets taken = insets();
    if (taken != viewer_.view().insets()) stale_ = kFramesToSettle;
    viewer_.resize(window_.framebuffer(), taken);
    const bool moving = !viewer_.idle() || panels_.busy() || capture_.busy();
    viewer_.frame();
    panels_.follow(viewer_);
    if (stale_ > 0 || moving || !viewer_.idle()) show();
    writeLog();
    spare_ = std::max(0.0, kShortestFrame - (wallClock() - began));
  }
  remember();
  return endMovie();
}

std::string FrameLoop::endMovie() {
  try {
    return capture_.end();
  } catch (const InputError& error) {
    return error.what();
  }
}

void FrameLoop::takeEvents() {
  if (window_.overlayBehind()) stale_ = std::max(stale_, 1);
  const bool hidden = shown_ == Extent{};
  const double rest = log_ ? kIdleSeconds : kAsleepSeconds;
  const double patience = viewer_.idle() || hidden ? rest : spare_;
  for (const WindowEvent& event : window_.events(stale_ > 0 || panels_.busy() || capture_.busy() ? spare_ : patience)) {
    stale_ = kFramesToSettle;
    const Input* input = event.kind == WindowEvent::Kind::Press ? findInput(event.key) : nullptr;
    if (input != nullptr && input->action == InputAction::FullScreen) {
      window_.toggleFullScreen();
      fullScreen_ = !fullScreen_;
    }
    (void)router_.route(event);
    for (const WindowEvent& key : hud_.takeKeys()) (void)router_.route(key);
  }
  if (window_.framebuffer() != shown_) stale_ = kFramesToSettle;
}

/// Where the left edge has panels, or their titles, they are there instead of the keys. In a wide window the right is
/// left free like the left with the keys, so that the cloth is in the middle.
Insets FrameLoop::insets() const {
  const Extent window = window_.framebuffer();
  const int keys = viewer_.view().showsHelp() && !panels_.isAt(Edge::Left) ? hud_.keysWidth(window) : 0;
  const auto left = static_cast<int>(panels_.width(Edge::Left)), right = static_cast<int>(panels_.width(Edge::Right));
  const bool wide = left == 0 && 2 * (keys + keys) <= window.width;
  return {.left = left > 0 ? left : keys,
          .right = std::max(right + hud_.beside(), wide && right == 0 ? keys : 0),
          .top = hud_.above() + static_cast<int>(panels_.titles()) + hud_.windHeight(viewer_),
          .bottom = hud_.below(viewer_),
          .wind = hud_.windHeight(viewer_),
          .beside = panels_.beside()};
}

void FrameLoop::show() {
  shown_ = window_.framebuffer();
  stale_ = std::max(0, stale_ - 1);
  if (window_.closeRequested() || shown_.width <= 0 || shown_.height <= 0) return;
  draw();
  window_.swap();
  // A card that computes in this context waits for what it has to draw first: that would count as time of the next
  // ticks.
  if (viewer_.run().shown().onDevice()) glFinish();
}

/// Trouble while the cloth is drawn is shown by the text that is drawn over it.
void FrameLoop::draw() {
  followTitle();
  followImage();
  try {
    painter_.draw(viewer_, panels_, shown_);
  } catch (const std::exception& error) {
    viewer_.run().freeze(error.what());
  }
  capture_.film(viewer_, shown_);
  updateHints();
  imgui_.beginFrame();
  hud_.draw(viewer_, panels_);
  panels_.draw(viewer_);
  ImGuiSession::endFrame();
  capture_.takePicture(viewer_, shown_);
}

void FrameLoop::followTitle() {
  std::string title = windowTitle(viewer_.scenes().scene());
  if (title == title_) return;
  window_.setTitle(title);
  title_ = std::move(title);
}

/// A picture that cannot be read is told; the cloth is drawn without it.
void FrameLoop::followImage() {
  const std::string& image = viewer_.scenes().scene().look.image;
  if (image == std::exchange(image_, image) || image.empty()) return;
  try {
    (void)readPicture(image);
  } catch (const InputError& error) {
    viewer_.notes().warn(std::string(error.what()) + "; the cloth is drawn without it");
  }
}

void FrameLoop::updateHints() {
  if (viewer_.tools().record().uses > 0) hints_.did(Hints::Topic::Push);
  if (viewer_.tools().chosenSlot() != 0) hints_.did(Hints::Topic::Tools);
  if (panels_.isOpen(InputAction::OpenChart)) hints_.did(Hints::Topic::Chart);
  if (panels_.isOpen(InputAction::OpenGhost)) hints_.did(Hints::Topic::Ghost);
  hud_.filming(capture_.filmingText());
  hud_.hint(viewer_.run().state() == RunState::Running ? hints_.show(wallClock()) : std::string_view());
}

void FrameLoop::writeLog() {
  ++frame_;
  if (!log_) return;
  try {
    ViewLogLine line = viewer_.logLine();
    line.frame = frame_;
    line.wall = wallClock() - opened_;
    log_->write(line);
  } catch (const std::exception& error) {
    log_.reset();
    viewer_.notes().warn(error.what());
    stale_ = kFramesToSettle;
  }
}

}  // namespace tyg
