// See overlay.h. Everything is measured in sizes of the text.
#include "ui/overlay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "ui/panels/style.h"
#include "util/wrapped.h"

namespace tyg {
namespace {

constexpr double kBarEnd = 1.25;      // of the limit
constexpr double kLeastCost = 0.001;  // that is told as a number: a share of the time

ImU32 colourOf(MarginBand band, Background background) {
  if (band == MarginBand::Past) return coloursOn(background).past;
  return band == MarginBand::Close ? coloursOn(background).warning : coloursOn(background).good;
}

/// Slanted lines between two corners.
void hatch(const Pen& pen, ImVec2 from, ImVec2 to, ImU32 colour) {
  const float height = to.y - from.y, stride = 0.3F * pen.size;
  pen.list->PushClipRect(from, to, true);
  const int lines = int((to.x - from.x + height) / stride) + 1;
  for (int line = 0; line < lines; ++line) {
    const float x = from.x - height + float(line) * stride;
    pen.list->AddLine({x, to.y}, {x + height, from.y}, colour, std::max(1.0F, pen.size / 14));
  }
  pen.list->PopClipRect();
}

bool inside(ImVec2 at, ImVec2 from, ImVec2 to) {
  return at.x >= from.x && at.x < to.x && at.y >= from.y && at.y < to.y;
}

/// Events count in pixels of the framebuffer, ImGui in units of the window.
ImVec2 placeOf(const WindowEvent& event) {
  const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
  return {float(event.x) / std::max(scale.x, 0.01F), float(event.y) / std::max(scale.y, 0.01F)};
}

std::string_view writeSeconds(std::array<char, 48>& text, const char* format, double seconds) {
  std::snprintf(text.data(), text.size(), format, seconds);
  return text.data();
}

float buttonWidth(const Pen& pen, const Buttons::Button& button) {
  return pen.extent(button.key).x + pen.extent(button.text).x + 1.8F * pen.size;
}
constexpr float kButtonHeight = 1.7F, kButtonGap = 0.5F;  // in sizes of the text

}  // namespace

std::string Pen::linesOf(std::string_view text, float wrap) const {
  if (!(wrap > 0)) return std::string(text);
  return wrapped(text, wrap, [this](std::string_view part) { return extent(part).x; });
}

ImVec2 Pen::extent(std::string_view text, float wrap) const {
  const std::string lines = linesOf(text, wrap);
  return font->CalcTextSizeA(size, 1e6F, wrap, lines.data(), lines.data() + lines.size());
}

void Pen::write(ImVec2 at, ImU32 colour, std::string_view text, float wrap) const {
  const std::string lines = linesOf(text, wrap);
  list->AddText(font, size, at, colour, lines.data(), lines.data() + lines.size(), wrap);
}

void Pen::shade(ImVec2 from, ImVec2 to) const {
  const float pad = 0.4F * size;
  list->AddRectFilled({from.x - pad, from.y - 0.6F * pad}, {to.x + pad, to.y + 0.6F * pad}, coloursOn(background).shade,
                      0.4F * size);
}

void drawMarginBar(const Pen& pen, ImVec2 from, ImVec2 to, const Margin& margin) {
  const Colours& ink = coloursOn(pen.background);
  const MarginBand band = margin.band();
  if (band == MarginBand::None) return;
  const double share = std::min(margin.share(), kBarEnd);
  const auto at = [&](double part) { return from.x + float(part / kBarEnd) * (to.x - from.x); };
  const ImU32 colour = colourOf(band, pen.background);
  pen.list->AddRectFilled(from, to, ink.shade);
  pen.list->AddRectFilled(from, {at(share), to.y}, colour);
  if (band == MarginBand::Past) hatch(pen, from, {at(share), to.y}, ink.shade);
  hatch(pen, {at(1), from.y}, to, ink.dim);
  pen.list->AddRect(from, to, ink.dim);
  const float over = 0.18F * pen.size;
  pen.list->AddLine({at(1), from.y - over}, {at(1), to.y + over}, ink.text, std::max(2.0F, pen.size / 9));
}

float drawMargin(Pen pen, ImVec2 at, float width, const Margin& margin) {
  const Colours& ink = coloursOn(pen.background);
  MarginText text;
  describe(margin, text);
  std::array<char, 48> cost{};
  if (margin.cost >= kLeastCost) {
    std::snprintf(cost.data(), cost.size(), "  \u00b7  found in %.1f %% of the time", 100 * margin.cost);
  } else if (margin.cost > 0) {
    std::snprintf(cost.data(), cost.size(), "  \u00b7  found in under %.1f %% of the time", 100 * kLeastCost);
  }
  const bool bar = margin.band() != MarginBand::None;
  const float barWidth = bar ? std::min(9 * pen.size, 0.3F * width) : 0, gap = bar ? 0.6F * pen.size : 0;
  pen.size *= std::min(1.0F, (width - barWidth - gap) / std::max(1.0F, pen.extent(text.data()).x));
  const float words = pen.extent(text.data()).x, costs = pen.extent(cost.data()).x;
  const bool fits = barWidth + gap + words + costs <= width;
  const float used = barWidth + gap + words + (fits ? costs : 0);
  pen.shade(at, {at.x + used, at.y + pen.size});
  drawMarginBar(pen, {at.x, at.y + 0.2F * pen.size}, {at.x + barWidth, at.y + 0.95F * pen.size}, margin);
  const bool warned = margin.band() == MarginBand::Close || margin.band() == MarginBand::Past;
  pen.write({at.x + barWidth + gap, at.y}, warned ? colourOf(margin.band(), pen.background) : ink.dim, text.data());
  if (fits) pen.write({at.x + barWidth + gap + words, at.y}, ink.dim, cost.data());
  return used;
}

void TimeLine::draw(const Pen& pen, ImVec2 from, ImVec2 to, const Viewer& viewer) {
  time_ = viewer.timeline();
  shown_ = time_.newest > time_.first;
  if (!shown_) return;
  const Colours& ink = coloursOn(pen.background);
  std::array<char, 48> text{};
  const std::string_view first = writeSeconds(text, "%.2f s", time_.first);
  const float left = from.x + pen.extent(first).x + 0.6F * pen.size;
  pen.shade(from, to);
  pen.write({from.x, to.y - pen.size}, ink.dim, first);
  const std::string_view newest = writeSeconds(text, "%.2f s", time_.newest);
  const float right = to.x - pen.extent(newest).x - 0.6F * pen.size;
  pen.write({right + 0.6F * pen.size, to.y - pen.size}, ink.dim, newest);
  const float middle = to.y - 0.5F * pen.size, thick = 0.12F * pen.size;
  const double share = std::clamp((time_.shown - time_.first) / (time_.newest - time_.first), 0.0, 1.0);
  const float handle = left + float(share) * (right - left);
  pen.list->AddRectFilled({left, middle - thick}, {right, middle + thick}, ink.field);
  pen.list->AddRectFilled({left, middle - thick}, {handle, middle + thick}, ink.accent);
  if (viewer.state() == RunState::Frozen) {  // where it broke
    const float arm = 0.3F * pen.size, width = std::max(2.0F, pen.size / 8);
    pen.list->AddLine({right - arm, middle - arm}, {right + arm, middle + arm}, ink.past, width);
    pen.list->AddLine({right - arm, middle + arm}, {right + arm, middle - arm}, ink.past, width);
  }
  pen.list->AddCircleFilled({handle, middle}, 0.4F * pen.size, ink.accent, 24);
  from_ = {left, from.y}, to_ = {right, to.y};
}

bool TimeLine::handle(const WindowEvent& event, Viewer& viewer) {
  const ImVec2 at = placeOf(event);
  const bool left = event.key == kLeftButton;
  const float reach = 0.5F * (to_.y - from_.y);
  switch (event.kind) {
    case WindowEvent::Kind::Press:
      if (!left || !shown_ || !inside(at, {from_.x - reach, from_.y}, {to_.x + reach, to_.y})) return false;
      dragged_ = true;
      turn(at.x, viewer);
      return true;
    case WindowEvent::Kind::Move:
      if (dragged_) turn(at.x, viewer);
      return dragged_;
    case WindowEvent::Kind::Release:
      if (left) dragged_ = false;
      return false;  // no button stays down for the viewer
    case WindowEvent::Kind::FocusLost:
      dragged_ = false;
      return false;
    default:
      return false;
  }
}

void TimeLine::turn(double x, Viewer& viewer) const {
  const double share = std::clamp((x - from_.x) / std::max(1.0F, to_.x - from_.x), 0.0, 1.0);
  viewer.turnToTime(time_.first + share * (time_.newest - time_.first));
}

float Buttons::height(const Pen& pen, const std::vector<Button>& buttons, float width) {
  float x = 0, lines = buttons.empty() ? 0 : 1;
  for (const Button& button : buttons) {
    const float wide = buttonWidth(pen, button);
    if (x > 0 && x + wide > width) x = 0, ++lines;
    x += wide + kButtonGap * pen.size;
  }
  return lines * (kButtonHeight + kButtonGap) * pen.size;
}

float Buttons::width(const Pen& pen, const std::vector<Button>& buttons) {
  float sum = 0;
  for (const Button& button : buttons) sum += buttonWidth(pen, button) + kButtonGap * pen.size;
  return std::max(0.0F, sum - kButtonGap * pen.size);
}

void Buttons::draw(const Pen& pen, ImVec2 at, const std::vector<Button>& buttons, float width) {
  const Colours& ink = coloursOn(pen.background);
  places_.clear();
  ImVec2 next = at;
  for (const Button& button : buttons) {
    const float wide = buttonWidth(pen, button);
    if (next.x > at.x && next.x + wide > at.x + width) next = {at.x, next.y + (kButtonHeight + kButtonGap) * pen.size};
    const ImVec2 corner{next.x + wide, next.y + kButtonHeight * pen.size};
    const bool under = inside(ImGui::GetIO().MousePos, next, corner);
    pen.list->AddRectFilled(next, corner, under ? ink.field : ink.shade, 0.35F * pen.size);
    pen.list->AddRect(next, corner, ink.accent, 0.35F * pen.size);
    const float y = next.y + 0.5F * (kButtonHeight - 1) * pen.size, x = next.x + 0.6F * pen.size;
    pen.write({x, y}, ink.accent, button.key);
    pen.write({x + pen.extent(button.key).x + 0.6F * pen.size, y}, ink.text, button.text);
    places_.push_back({next, corner, button.action});
    next.x = corner.x + kButtonGap * pen.size;
  }
}

bool Buttons::handle(const WindowEvent& event, Viewer& viewer) {
  if (event.kind != WindowEvent::Kind::Press || event.key != kLeftButton) return false;
  const auto place =
      std::ranges::find_if(places_, [&](const Place& p) { return inside(placeOf(event), p.from, p.to); });
  if (place == places_.end()) return false;
  const InputAction action = place->action;
  places_.clear();
  viewer.perform(action);
  return true;
}

}  // namespace tyg
