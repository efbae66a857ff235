// The foot of the window: status, margin, the line of time, and what the person may do next.
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "ui/hud.h"
#include "ui/panels/style.h"

namespace tyg {
namespace {

constexpr float kLargeRatio = 1.5F;  // in sizes of the text
constexpr float kLeastMiddle = 30;   // to write in between the panels
constexpr float kAbove = 0.6F;       // between what is said and what is below

/// `1/8 speed`; nothing at full speed.
void describeSpeed(double speed, std::array<char, 32>& text) {
  text[0] = 0;
  if (speed < 1) std::snprintf(text.data(), text.size(), "  \u00b7  1/%.0f speed", 1 / speed);
}

std::vector<Buttons::Button> waysOut(const Viewer& viewer) {
  std::vector<Buttons::Button> buttons;
  const bool canRunOn = viewer.simulation().status() == Status::Unstable && !viewer.breaking();
  if (const auto& cure = viewer.cure()) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "a step of %.3g ms", 1e3 * cure->step);
    if (cure->step > 0) buttons.push_back({"V", text.data(), InputAction::SafeStep});
    if (cure->method != nullptr) buttons.push_back({"M", std::string(cure->method->name), InputAction::HoldingMethod});
    buttons.push_back({"J", "see it again, slowly", InputAction::Again});
    if (canRunOn) buttons.push_back({"Enter", "run on, let it break", InputAction::RunOn});
  }
  buttons.push_back({",", "a step back", InputAction::StepBack});
  buttons.push_back({"R", "restart", InputAction::Restart});
  return buttons;
}

}  // namespace

/// What is said in the middle stands between the panels, or over them where that is too narrow.
struct Hud::Middle {
  float from = 0, to = 0;     ///< across the window
  float left = 0, right = 0;  ///< between panels and keys
  bool free = false;          ///< of panels
  float top = 0;              ///< above what has been said so far
  float sides = 0;            ///< above what of it reaches into the sides
};

/// `keys`: the width that they take where there are no panels.
Hud::Middle Hud::middleBetween(const Panels& panels, float keys, float bottom) const {
  const float screen = ImGui::GetIO().DisplaySize.x;
  const auto side = [&](Edge edge) { return panels.width(edge) > 0 ? panels.width(edge) : keys; };
  const float left = side(Edge::Left), right = screen - side(Edge::Right);
  const bool free = right - left >= kLeastMiddle * size_;
  return {free ? left : 0, free ? right : screen, left, right, free, bottom, bottom};
}

/// Over the panels where there is no room between them.
Pen Hud::penIn(const Viewer& viewer, const Middle& middle) const {
  Pen pen = penFor(viewer);
  if (!middle.free) pen.list = ImGui::GetForegroundDrawList();
  return pen;
}

/// Over panels it is twice as dense: their words would show through.
void Hud::ground(const Pen& pen, ImVec2 from, ImVec2 to, const Middle& middle) {
  pen.shade(from, to);
  if (!middle.free) pen.shade(from, to);
}

void Hud::sayInMiddle(const Pen& pen, ImU32 colour, std::string_view text, Middle& middle) {
  const float wrap = middle.to - middle.from - 4 * pen.size;
  const ImVec2 extent = pen.extent(text, wrap);
  const ImVec2 at{0.5F * (middle.from + middle.to - extent.x), middle.top - kAbove * pen.size - extent.y};
  ground(pen, at, {at.x + extent.x, at.y + extent.y}, middle);
  pen.write(at, colour, text, wrap);
  middle.top = at.y - 0.3F * pen.size;
  if (at.x < middle.left || at.x + extent.x > middle.right) middle.sides = middle.top;
}

/// Returns the height down to which keys may be written: what is said in the middle does not cover them.
float Hud::drawFoot(const Viewer& viewer, Panels& panels) {
  const float status = drawStatus(viewer);
  panels.endAbove(status - 0.8F * kTimeLine * size_);  // whether it is there or not: no panel jumps at a pause
  const float bottom = drawTimeLine(viewer, status);
  const bool frozen = viewer.state() == RunState::Frozen;
  // The keys give way to a failure.
  Middle middle = middleBetween(panels, viewer.showsHelp() && !frozen ? float(margin()) : 0, bottom);
  const Pen pen = penIn(viewer, middle);
  if (!filming_.empty()) sayInMiddle(pen, coloursOn(pen.background).text, filming_, middle);
  if (frozen) {
    drawFailure(viewer, middle);
    if (!middle.free) panels.endAbove(middle.top - kAbove * size_);
  } else {
    buttons_.hide();
  }
  if (!frozen || !viewer.note().empty()) drawPrompt(viewer, middle);
  return frozen ? middle.top : middle.sides;
}

/// Returns the height above which the window is free.
float Hud::drawStatus(const Viewer& viewer) const {
  const Pace& pace = viewer.pace();
  StepText step;
  viewer.describeStep(step);
  std::array<char, 64> rates{"- frames/s  \u00b7  - % simulating"}, behind{};
  if (pace.framesPerSecond > 0) {
    std::snprintf(rates.data(), rates.size(), "%.0f frames/s  \u00b7  %.0f %% simulating", pace.framesPerSecond,
                  100 * pace.simulating);
  }
  if (viewer.behind()) std::snprintf(behind.data(), behind.size(), "  \u00b7  %.2g of real time", pace.realTime);
  std::array<char, 32> speed{};
  describeSpeed(viewer.speed(), speed);
  const std::string_view method = viewer.method().name;
  std::array<char, 256> text{};
  std::snprintf(text.data(), text.size(), "%.*s  \u00b7  %s  \u00b7  t %.3f s%s  \u00b7  %s%s",
                static_cast<int>(method.size()), method.data(), step.data(), viewer.time(), speed.data(), rates.data(),
                behind.data());
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  Pen pen = penFor(viewer);
  const float room = screen.x - 2 * size_, width = pen.extent(text.data()).x;
  const ImVec2 at{size_, screen.y - 2 * size_};
  drawMargin(pen, {at.x, at.y - kLine * size_}, room, viewer.margin());
  pen.size *= std::min(1.0F, room / std::max(width, 1.0F));
  pen.shade(at, {at.x + std::min(width, room), at.y + pen.size});
  pen.write(at, viewer.behind() ? coloursOn(pen.background).warning : coloursOn(pen.background).text, text.data());
  return at.y - kLine * size_ - 0.6F * size_;
}

/// Only where time stands: it is not in the way of a moving cloth.
float Hud::drawTimeLine(const Viewer& viewer, float bottom) {
  const bool stands = viewer.state() == RunState::Paused || viewer.state() == RunState::Frozen;
  if (!stands && !timeLine_.dragged()) {
    timeLine_.hide();
    return bottom;
  }
  const float width = ImGui::GetIO().DisplaySize.x;
  timeLine_.draw(penFor(viewer), {size_, bottom - 1.4F * size_}, {width - size_, bottom - 0.2F * size_}, viewer);
  return bottom - kTimeLine * size_;
}

void Hud::drawFailure(const Viewer& viewer, Middle& middle) {
  const Pen pen = penIn(viewer, middle);
  const float bottom = middle.top - kAbove * size_;
  const std::vector<Buttons::Button> buttons = waysOut(viewer);
  const float room = middle.to - middle.from - 4 * size_;
  const ImVec2 extent = pen.extent(viewer.message(), room);
  const float row = Buttons::height(pen, buttons, room);
  const float width = std::max(extent.x, std::min(room, Buttons::width(pen, buttons)));
  const ImVec2 at{0.5F * (middle.from + middle.to - width), bottom - row - 0.5F * size_ - extent.y};
  ground(pen, {at.x - 0.5F * size_, at.y - 0.4F * size_}, {at.x + width + 0.5F * size_, bottom}, middle);
  pen.write(at, coloursOn(pen.background).warning, viewer.message(), room);
  buttons_.draw(pen, {at.x, at.y + extent.y + 0.5F * size_}, buttons, room);
  middle.top = at.y - 0.4F * size_;
}

void Hud::drawPrompt(const Viewer& viewer, Middle& middle) const {
  std::array<char, 1024> text{};
  Pen pen = penIn(viewer, middle);
  ImU32 colour = coloursOn(pen.background).text;
  const auto say = [&text](const char* format, auto... values) {
    std::snprintf(text.data(), text.size(), format, values...);
  };
  const Timeline time = viewer.timeline();
  const bool noted = !viewer.note().empty(), warns = noted ? viewer.noteWarns() : viewer.breaking();
  if (noted) {
    say("%s", viewer.note().c_str());
  } else if (viewer.state() == RunState::Waiting) {
    say("%s", "space to start");
  } else if (viewer.state() == RunState::Paused && time.past) {
    say("%.2f s back  \u00b7  space goes on from here", time.newest - time.shown);
  } else if (viewer.state() == RunState::Paused) {
    say("%s", "paused  \u00b7  space goes on");
  } else if (viewer.asleep()) {
    say("%s", "asleep: nothing moves  \u00b7  a push wakes it");
  } else if (viewer.breaking()) {
    say("%s", "past its alarm: V takes a safe step, M a method that holds, R restarts");
  } else if (!notice_.empty()) {
    say("%s", notice_.c_str());
  } else {
    return;
  }
  if (warns) colour = coloursOn(pen.background).warning;
  const bool prompts = viewer.state() == RunState::Waiting || viewer.state() == RunState::Paused;
  if (!noted && prompts && middle.free) pen.font = large_, pen.size *= kLargeRatio;
  sayInMiddle(pen, colour, text.data(), middle);
}

}  // namespace tyg
