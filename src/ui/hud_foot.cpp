// The foot of the window: status, margin of the step, the time line, and what the person may do next.
#include <fmt/core.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "ui/hud.h"
#include "ui/panels/style.h"

namespace tyg {
namespace {

constexpr float kLeastMiddle = 12;     // to write a line in between the panels, in sizes of the text ...
constexpr float kLeastFailure = 30;    // ... or what is said of a failure
constexpr float kLeastPanel = 7;       // lines that a panel is to have above that, if it was opened after the failure
constexpr float kAbove = 0.6F;         // between what is said and what is below
constexpr float kBeside = 4;           // left and right of it together
constexpr float kFailureShare = 0.3F;  // of the window's height, for what is said of a failure: else it is said smaller
constexpr float kSmallest = 0.65F;     // but not smaller than this share of the text

/// `1/8 speed`; nothing at full speed.
std::string speedText(double speed) { return speed < 1 ? fmt::format("  \u00b7  1/{:.0f} speed", 1 / speed) : ""; }

/// Of a way back in time.
std::string backText(double seconds) {
  constexpr double kShort = 0.1;
  return seconds < kShort ? fmt::format("{:.3g} ms", 1e3 * seconds) : fmt::format("{:.2f} s", seconds);
}

/// Which of the two is slow, where frames come late.
std::string_view slowText(Pace::Slow slow) {
  if (slow == Pace::Slow::Drawing) return "  \u00b7  drawing is slow";
  return slow == Pace::Slow::Simulating ? "  \u00b7  simulating is slow" : "";
}

Extent framebuffer() {
  const ImGuiIO& io = ImGui::GetIO();
  return {.width = static_cast<int>(io.DisplaySize.x * io.DisplayFramebufferScale.x),
          .height = static_cast<int>(io.DisplaySize.y * io.DisplayFramebufferScale.y)};
}

/// It was let run on, and a moment after the last good one is shown.
bool isBreaking(const RunControl& run) { return run.failure().runsOn() && run.failure().isPast(run.shown().tick()); }

std::vector<Buttons::Button> waysOut(const Viewer& viewer) {
  std::vector<Buttons::Button> buttons;
  if (const auto& cure = viewer.run().failure().cure()) {
    const std::string step = fmt::format("a step of {:.3g} ms", 1e3 * cure->step);
    if (cure->step > 0) buttons.push_back({"V", step, InputAction::SafeStep});
    if (cure->method != nullptr) buttons.push_back({"M", std::string(cure->method->name), InputAction::HoldingMethod});
    buttons.push_back({"J", "see it again, slowly", InputAction::Again});
    if (viewer.run().canRunOn()) buttons.push_back({"Enter", "run on, let it break", InputAction::RunOn});
  }
  buttons.push_back({",", "step back", InputAction::StepBack});
  buttons.push_back({"R", "restart", InputAction::Restart});
  return buttons;
}

}  // namespace

/// Where text in the middle of the window goes: between the panels, or over them where that is too narrow.
struct Hud::Middle {
  float from = 0, to = 0;  ///< across the window
  float keys = 0;          ///< to the right of the keys
  bool free = false;       ///< of panels
  float top = 0;           ///< above what has been said so far
  float sides = 0;         ///< above what of it reaches over the keys
};

/// `least`: the width that must be free for it, in sizes of the text; `keys`: that which they take at the left where
/// there are no panels.
Hud::Middle Hud::middleBetween(const Panels& panels, float least, float keys, float bottom) const {
  const float screen = ImGui::GetIO().DisplaySize.x;
  const float left = panels.width(Edge::Left), right = screen - panels.width(Edge::Right);
  const bool free = right - left >= least * size_;
  return {free ? left : 0, free ? right : screen, keys, free, bottom, bottom};
}

/// Over the panels where there is no room between them.
TextWriter Hud::writerIn(const Viewer& viewer, const Middle& middle) const {
  TextWriter writer = writerFor(viewer);
  if (!middle.free && !viewer.view().showsAllKeys()) writer.list = ImGui::GetForegroundDrawList();
  return writer;
}

/// Over panels it is twice as dense: their words would show through.
void Hud::ground(const TextWriter& writer, ImVec2 from, ImVec2 to, const Middle& middle) {
  writer.shade(from, to);
  if (!middle.free) writer.shade(from, to);
}

void Hud::sayInMiddle(const TextWriter& writer, ImU32 colour, std::string_view text, Middle& middle) {
  const float wrap = middle.to - middle.from - kBeside * writer.size;
  const ImVec2 extent = writer.extent(text, wrap);
  const ImVec2 at{0.5F * (middle.from + middle.to - extent.x), middle.top - kAbove * writer.size - extent.y};
  ground(writer, at, {at.x + extent.x, at.y + extent.y}, middle);
  writer.write(at, colour, text, wrap);
  middle.top = at.y - 0.3F * writer.size;
  if (at.x < middle.keys) middle.sides = middle.top;
}

int Hud::below(const Viewer& viewer) const {
  constexpr float kSaid = 2.2F;  // a line in the large font
  const bool frozen = viewer.run().state() == RunState::Frozen && !givesWay_;
  return static_cast<int>(frozen && failure_ > 0 ? failure_ : std::max(said_, (kFoot - kTimeLine + kSaid) * size_));
}

/// In a low window there is no room for both, and a panel that was asked for is to be seen.
void Hud::makeWay(const Panels& panels, bool frozen) {
  if (!frozen) openedBefore_ = panels.timesOpened();
  const float room = ImGui::GetIO().DisplaySize.y - failure_ - kTop * size_;
  const bool narrow = !middleBetween(panels, kLeastFailure, 0, 0).free;
  givesWay_ = frozen && narrow && panels.timesOpened() != openedBefore_ && room < kLeastPanel * size_;
}

/// Returns the height down to which keys may be written: what is said in the middle does not cover them.
float Hud::drawFoot(const Viewer& viewer, Panels& panels) {
  const float status = drawStatus(viewer);
  panels.endAbove(status - 0.8F * kTimeLine * size_);  // whether it is there or not: no panel jumps at a pause
  const float bottom = drawTimeLine(viewer, status);
  makeWay(panels, viewer.run().state() == RunState::Frozen);
  const bool frozen = viewer.run().state() == RunState::Frozen && !givesWay_;
  // The keys give way to a failure.
  const bool keys = viewer.view().showsHelp() && !frozen && !panels.isAt(Edge::Left);
  Middle middle =
      middleBetween(panels, frozen ? kLeastFailure : kLeastMiddle, keys ? float(keysWidth(framebuffer())) : 0, bottom);
  const TextWriter writer = writerIn(viewer, middle);
  if (!filming_.empty()) sayInMiddle(writer, coloursOn(writer.background).text, filming_, middle);
  overPanels_ = frozen && !middle.free && !viewer.view().showsAllKeys();
  if (!frozen) buttons_.hide();
  if (overPanels_) drawFailureOver(viewer, middle);
  if (frozen && !overPanels_) drawFailure(writer, viewer, middle);
  if (frozen && !middle.free) panels.endAbove(middle.top - kAbove * size_);
  if (!frozen || !viewer.notes().text().empty()) drawPrompt(viewer, middle);
  said_ = givesWay_ ? ImGui::GetIO().DisplaySize.y - middle.top : 0;
  return frozen ? middle.top : middle.sides;
}

/// Returns the height above which the window is free.
float Hud::drawStatus(const Viewer& viewer) const {
  const Pace& pace = viewer.pace();
  StepText step;
  viewer.scenes().describeStep(step);
  std::string text =
      fmt::format("{}  \u00b7  {}  \u00b7  t {:.3f} s{}  \u00b7  ", viewer.scenes().method().name, step.data(),
                  viewer.run().shown().time(), speedText(viewer.run().frameClock().speed()));
  if (pace.framesPerSecond > 0) {
    text += fmt::format("{:.0f} frames/s  \u00b7  {:.0f} % simulating", pace.framesPerSecond, 100 * pace.simulating);
  } else {
    text += "- frames/s  \u00b7  - % simulating";
  }
  if (viewer.behind()) text += fmt::format("  \u00b7  {:.2g} of real time", pace.realTime);
  if (viewer.run().state() == RunState::Running && !viewer.run().asleep()) text += slowText(pace.slow);
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  TextWriter writer = writerFor(viewer);
  const float room = screen.x - 2 * size_, width = writer.extent(text).x;
  const ImVec2 at{size_, screen.y - 2 * size_};
  drawMargin(writer, {at.x, at.y - kLine * size_}, room, viewer.run().margin());
  writer.size *= std::min(1.0F, room / std::max(width, 1.0F));
  writer.shade(at, {at.x + std::min(width, room), at.y + writer.size});
  writer.write(at, viewer.behind() ? coloursOn(writer.background).warning : coloursOn(writer.background).text, text);
  return at.y - kLine * size_ - 0.6F * size_;
}

/// Only while no time passes, so that it is not in the way of a moving cloth.
float Hud::drawTimeLine(const Viewer& viewer, float bottom) {
  const RunState state = viewer.run().state();
  const bool halted = state == RunState::Paused || state == RunState::Frozen;
  if (!halted && !timeLine_.dragged()) {
    timeLine_.hide();
    return bottom;
  }
  const float width = ImGui::GetIO().DisplaySize.x;
  timeLine_.draw(writerFor(viewer), {size_, bottom - 1.4F * size_}, {width - size_, bottom - 0.2F * size_}, viewer);
  return bottom - kTimeLine * size_;
}

/// In a window of ImGui's, so that no panel below it feels the mouse.
void Hud::drawFailureOver(const Viewer& viewer, Middle& middle) {
  ImGui::SetNextWindowPos(failureFrom_);
  ImGui::SetNextWindowSize({failureTo_.x - failureFrom_.x, failureTo_.y - failureFrom_.y});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  constexpr int kPlain = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                         ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoBackground;
  ImGui::Begin("##failure", nullptr, kPlain);
  ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
  TextWriter writer = writerFor(viewer);
  writer.list = ImGui::GetWindowDrawList();
  writer.list->PushClipRectFullScreen();
  drawFailure(writer, viewer, middle);
  writer.list->PopClipRect();
  ImGui::End();
  ImGui::PopStyleVar();
}

bool Hud::pressFailure(const WindowEvent& event, Viewer& viewer) {
  if (!overPanels_ || event.kind != WindowEvent::Kind::Press || !isMouse(event.key)) return false;
  return buttons_.handle(event, viewer) || inside(positionOf(event), failureFrom_, failureTo_);
}

void Hud::drawFailure(TextWriter writer, const Viewer& viewer, Middle& middle) {
  const float bottom = middle.top - kAbove * size_;
  const std::vector<Buttons::Button> buttons = waysOut(viewer);
  const float room = middle.to - middle.from - 4 * size_;
  ImVec2 extent;
  float row = 0;
  for (float share = 1; share >= kSmallest; share -= 0.05F) {  // the cloth is to be seen above
    writer.size = share * size_;
    extent = writer.extent(viewer.run().failure().message(), room);
    row = Buttons::height(writer, buttons, room);
    if (extent.y + row <= kFailureShare * ImGui::GetIO().DisplaySize.y) break;
  }
  const float width = std::max(extent.x, std::min(room, Buttons::width(writer, buttons)));
  const ImVec2 at{0.5F * (middle.from + middle.to - width), bottom - row - 0.5F * size_ - extent.y};
  failureFrom_ = {at.x - 0.5F * size_, at.y - 0.4F * size_}, failureTo_ = {at.x + width + 0.5F * size_, bottom};
  ground(writer, failureFrom_, failureTo_, middle);
  writer.write(at, coloursOn(writer.background).warning, viewer.run().failure().message(), room);
  buttons_.draw(writer, {at.x, at.y + extent.y + 0.5F * size_}, buttons, room);
  middle.top = at.y - 0.4F * size_;
  failure_ = ImGui::GetIO().DisplaySize.y - middle.top;
}

/// What there is to say while the cloth has not failed; empty: nothing.
std::string Hud::promptText(const Viewer& viewer) const {
  const RunControl& run = viewer.run();
  const Timeline time = run.timeline();
  if (!viewer.notes().text().empty()) return viewer.notes().text();
  if (run.state() == RunState::Waiting) return "space, or a click or a drag on the cloth, starts it";
  if (run.state() == RunState::Paused && time.past) {
    return backText(time.newest - time.shown) + " back  \u00b7  space goes on from here";
  }
  if (run.state() == RunState::Paused) return "paused  \u00b7  space goes on";
  if (run.asleep()) return "at rest  \u00b7  click the cloth to push it";
  if (givesWay_) return "unstable  \u00b7  Esc closes the panel and shows the ways out";
  if (isBreaking(run)) return "it is breaking, in slow motion  \u00b7  space pauses, R restarts";
  return hint_;
}

void Hud::drawPrompt(const Viewer& viewer, Middle& middle) const {
  const std::string text = promptText(viewer);
  if (text.empty()) return;
  TextWriter writer = writerIn(viewer, middle);
  const bool noted = !viewer.notes().text().empty();
  const bool warns = noted ? viewer.notes().warns() : givesWay_ || isBreaking(viewer.run());
  const Colours& colours = coloursOn(writer.background);
  const RunState state = viewer.run().state();
  const bool prompts = state == RunState::Waiting || state == RunState::Paused;
  TextWriter large = writer;
  large.font = fonts_.large, large.size *= kLargeRatio;
  const bool fits = large.extent(text).x <= middle.to - middle.from - kBeside * large.size;
  if (!noted && prompts && middle.free && fits) writer = large;
  sayInMiddle(writer, warns ? colours.warning : colours.text, text, middle);
}

}  // namespace tyg
