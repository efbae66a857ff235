// Everything is measured in sizes of the text, so that it keeps its shape at any scale of the window.
#include "ui/overlay.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "ui/panels/style.h"
#include "util/wrapped.h"

namespace tyg {
namespace {

constexpr double kBarEnd = 1.25;  // of the limit

ImU32 colourOf(MarginBand band, Background background) {
  if (band == MarginBand::Past) return coloursOn(background).past;
  return band == MarginBand::Close ? coloursOn(background).warning : coloursOn(background).good;
}

/// Slanted lines between two corners.
void hatch(const TextWriter& writer, ImVec2 from, ImVec2 to, ImU32 colour) {
  const float height = to.y - from.y, stride = 0.3F * writer.size;
  writer.list->PushClipRect(from, to, true);
  const int lines = int((to.x - from.x + height) / stride) + 1;
  for (int line = 0; line < lines; ++line) {
    const float x = from.x - height + float(line) * stride;
    writer.list->AddLine({x, to.y}, {x + height, from.y}, colour, std::max(1.0F, writer.size / 14));
  }
  writer.list->PopClipRect();
}

float buttonWidth(const TextWriter& writer, const Buttons::Button& button) {
  return writer.extent(button.key).x + writer.extent(button.text).x + 1.8F * writer.size;
}
constexpr float kButtonHeight = 1.7F, kButtonGap = 0.5F;  // in sizes of the text

}  // namespace

bool inside(ImVec2 at, ImVec2 from, ImVec2 to) {
  return at.x >= from.x && at.x < to.x && at.y >= from.y && at.y < to.y;
}

ImVec2 positionOf(const WindowEvent& event) {
  const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
  return {float(event.x) / std::max(scale.x, 0.01F), float(event.y) / std::max(scale.y, 0.01F)};
}

std::string TextWriter::linesOf(std::string_view text, float wrap) const {
  if (!(wrap > 0)) return std::string(text);
  return wrapped(text, wrap, [this](std::string_view part) { return extent(part).x; });
}

ImVec2 TextWriter::extent(std::string_view text, float wrap) const {
  const std::string lines = linesOf(text, wrap);
  return font->CalcTextSizeA(size, 1e6F, wrap, lines.data(), lines.data() + lines.size());
}

void TextWriter::write(ImVec2 at, ImU32 colour, std::string_view text, float wrap) const {
  const std::string lines = linesOf(text, wrap);
  list->AddText(font, size, at, colour, lines.data(), lines.data() + lines.size(), wrap);
}

void TextWriter::shade(ImVec2 from, ImVec2 to) const {
  const float pad = 0.4F * size;
  list->AddRectFilled({from.x - pad, from.y - 0.6F * pad}, {to.x + pad, to.y + 0.6F * pad}, coloursOn(background).shade,
                      0.4F * size);
}

void drawMarginBar(const TextWriter& writer, ImVec2 from, ImVec2 to, const Margin& margin) {
  const Colours& ink = coloursOn(writer.background);
  const MarginBand band = margin.band();
  if (band == MarginBand::None) return;
  const double share = std::min(margin.share(), kBarEnd);
  const auto at = [&](double part) { return from.x + float(part / kBarEnd) * (to.x - from.x); };
  const ImU32 colour = colourOf(band, writer.background);
  writer.list->AddRectFilled(from, to, ink.shade);
  writer.list->AddRectFilled(from, {at(share), to.y}, colour);
  if (band == MarginBand::Past) hatch(writer, from, {at(share), to.y}, ink.shade);
  hatch(writer, {at(1), from.y}, to, ink.dim);
  writer.list->AddRect(from, to, ink.dim);
  const float over = 0.18F * writer.size;
  writer.list->AddLine({at(1), from.y - over}, {at(1), to.y + over}, ink.text, std::max(2.0F, writer.size / 9));
}

float drawMargin(TextWriter writer, ImVec2 at, float width, const Margin& margin) {
  const Colours& ink = coloursOn(writer.background);
  MarginText text;
  describe(margin, text);
  const bool bar = margin.band() != MarginBand::None;
  const float barWidth = bar ? std::min(9 * writer.size, 0.3F * width) : 0, gap = bar ? 0.6F * writer.size : 0;
  writer.size *= std::min(1.0F, (width - barWidth - gap) / std::max(1.0F, writer.extent(text.data()).x));
  const float used = barWidth + gap + writer.extent(text.data()).x;
  writer.shade(at, {at.x + used, at.y + writer.size});
  drawMarginBar(writer, {at.x, at.y + 0.2F * writer.size}, {at.x + barWidth, at.y + 0.95F * writer.size}, margin);
  const bool warned = margin.band() == MarginBand::Close || margin.band() == MarginBand::Past;
  writer.write({at.x + barWidth + gap, at.y}, warned ? colourOf(margin.band(), writer.background) : ink.dim,
               text.data());
  return used;
}

void TimeLine::draw(const TextWriter& writer, ImVec2 from, ImVec2 to, const Viewer& viewer) {
  time_ = viewer.run().timeline();
  shown_ = time_.newest > time_.first;
  if (!shown_) return;
  const Colours& ink = coloursOn(writer.background);
  const std::string first = fmt::format("{:.2f} s", time_.first), newest = fmt::format("{:.2f} s", time_.newest);
  const float left = from.x + writer.extent(first).x + 0.6F * writer.size;
  writer.shade(from, to);
  writer.write({from.x, to.y - writer.size}, ink.dim, first);
  const float right = to.x - writer.extent(newest).x - 0.6F * writer.size;
  writer.write({right + 0.6F * writer.size, to.y - writer.size}, ink.dim, newest);
  const float middle = to.y - 0.5F * writer.size, thick = 0.12F * writer.size;
  const double share = std::clamp((time_.shown - time_.first) / (time_.newest - time_.first), 0.0, 1.0);
  const float handle = left + float(share) * (right - left);
  writer.list->AddRectFilled({left, middle - thick}, {right, middle + thick}, ink.field);
  writer.list->AddRectFilled({left, middle - thick}, {handle, middle + thick}, ink.accent);
  if (viewer.run().state() == RunState::Frozen) {  // where it broke
    const float arm = 0.3F * writer.size, width = std::max(2.0F, writer.size / 8);
    writer.list->AddLine({right - arm, middle - arm}, {right + arm, middle + arm}, ink.past, width);
    writer.list->AddLine({right - arm, middle + arm}, {right + arm, middle - arm}, ink.past, width);
  }
  writer.list->AddCircleFilled({handle, middle}, 0.4F * writer.size, ink.accent, 24);
  from_ = {left, from.y}, to_ = {right, to.y};
}

bool TimeLine::handle(const WindowEvent& event, Viewer& viewer) {
  const ImVec2 at = positionOf(event);
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
  viewer.run().turnToTime(time_.first + share * (time_.newest - time_.first));
}

float Buttons::height(const TextWriter& writer, const std::vector<Button>& buttons, float width) {
  float x = 0, lines = buttons.empty() ? 0 : 1;
  for (const Button& button : buttons) {
    const float wide = buttonWidth(writer, button);
    if (x > 0 && x + wide > width) x = 0, ++lines;
    x += wide + kButtonGap * writer.size;
  }
  return lines * (kButtonHeight + kButtonGap) * writer.size;
}

float Buttons::width(const TextWriter& writer, const std::vector<Button>& buttons) {
  float sum = 0;
  for (const Button& button : buttons) sum += buttonWidth(writer, button) + kButtonGap * writer.size;
  return std::max(0.0F, sum - kButtonGap * writer.size);
}

void Buttons::draw(const TextWriter& writer, ImVec2 at, const std::vector<Button>& buttons, float width) {
  const Colours& ink = coloursOn(writer.background);
  areas_.clear();
  ImVec2 next = at;
  for (const Button& button : buttons) {
    const float wide = buttonWidth(writer, button);
    if (next.x > at.x && next.x + wide > at.x + width)
      next = {at.x, next.y + (kButtonHeight + kButtonGap) * writer.size};
    const ImVec2 corner{next.x + wide, next.y + kButtonHeight * writer.size};
    const bool under = inside(ImGui::GetIO().MousePos, next, corner);
    writer.list->AddRectFilled(next, corner, under ? ink.field : ink.shade, 0.35F * writer.size);
    writer.list->AddRect(next, corner, ink.accent, 0.35F * writer.size);
    const float y = next.y + 0.5F * (kButtonHeight - 1) * writer.size, x = next.x + 0.6F * writer.size;
    writer.write({x, y}, ink.accent, button.key);
    writer.write({x + writer.extent(button.key).x + 0.6F * writer.size, y}, ink.text, button.text);
    areas_.push_back({next, corner, button.action});
    next.x = corner.x + kButtonGap * writer.size;
  }
}

bool Buttons::handle(const WindowEvent& event, Viewer& viewer) {
  if (event.kind != WindowEvent::Kind::Press || event.key != kLeftButton) return false;
  const auto pressed =
      std::ranges::find_if(areas_, [&](const Area& area) { return inside(positionOf(event), area.from, area.to); });
  if (pressed == areas_.end()) return false;
  const InputAction action = pressed->action;
  areas_.clear();
  viewer.perform(action);
  return true;
}

}  // namespace tyg
