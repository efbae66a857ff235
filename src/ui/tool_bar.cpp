// Each tool is an icon of lines, its key and its words; under the cursor a sentence says how it is used.
#include "ui/tool_bar.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "ui/panels/style.h"

namespace tyg {
namespace {

// In sizes of the text.
constexpr float kTop = 0.35F, kHeight = 1.6F, kIcon = 1.2F, kPad = 0.45F, kGap = 0.4F;

float widthOf(const TextWriter& writer, std::size_t slot, bool words) {
  const float key = writer.extent(toolKeyName(slot)).x + kPad * writer.size;
  const float text = words ? writer.extent(toolTable()[slot].does).x + kPad * writer.size : 0;
  return (kIcon + 2 * kPad) * writer.size + key + text;
}

float widthOfAll(const TextWriter& writer, bool words) {
  float sum = -kGap * writer.size;
  for (std::size_t slot = 0; slot < toolTable().size(); ++slot)
    sum += widthOf(writer, slot, words) + kGap * writer.size;
  return sum;
}

void drawIcon(const TextWriter& writer, std::span<const glm::vec2> icon, ImVec2 at, ImU32 colour) {
  const float size = kIcon * writer.size;
  const auto place = [&](glm::vec2 p) { return ImVec2(at.x + p.x * size, at.y + p.y * size); };
  for (const glm::vec2& point : icon) {
    if (point != kPenUp) {
      writer.list->PathLineTo(place(point));
    } else {
      writer.list->PathStroke(colour, 0, std::max(1.5F, writer.size / 11));
    }
  }
  writer.list->PathStroke(colour, 0, std::max(1.5F, writer.size / 11));
}

}  // namespace

void ToolBar::draw(const TextWriter& writer, ImVec2 across, const Viewer& viewer) {
  areas_.clear();
  const float room = across.y - across.x;
  const bool words = widthOfAll(writer, true) <= room;
  const float width = widthOfAll(writer, words);
  if (width > room) return;
  const Colours& ink = coloursOn(writer.background);
  const float middle = 0.5F * (ImGui::GetIO().DisplaySize.x - width);
  ImVec2 at{std::clamp(middle, across.x, across.y - width), kTop * writer.size};
  for (std::size_t slot = 0; slot < toolTable().size(); ++slot) {
    const ToolKind& kind = toolTable()[slot];
    const bool chosen = slot == viewer.tools().chosenSlot();
    const ImVec2 corner{at.x + widthOf(writer, slot, words), at.y + kHeight * writer.size};
    const bool under = inside(ImGui::GetIO().MousePos, at, corner);
    const float round = 0.35F * writer.size, y = at.y + 0.5F * (kHeight - 1) * writer.size;
    writer.list->AddRectFilled(at, corner, under || chosen ? ink.field : ink.shade, round);
    writer.list->AddRect(at, corner, chosen ? ink.accent : faded(ink.dim, 0.5F), round, 0, chosen ? 2.0F : 1.0F);
    float x = at.x + kPad * writer.size;
    drawIcon(writer, kind.icon, {x, at.y + 0.5F * (kHeight - kIcon) * writer.size}, chosen ? ink.accent : ink.text);
    x += (kIcon + kPad) * writer.size;
    writer.write({x, y}, ink.accent, toolKeyName(slot));
    x += writer.extent(toolKeyName(slot)).x + kPad * writer.size;
    if (words) writer.write({x, y}, chosen ? ink.accent : ink.text, kind.does);
    if (under) {
      const float wrap = std::min(30 * writer.size, ImGui::GetIO().DisplaySize.x - 2 * writer.size);
      const ImVec2 extent = writer.extent(kind.how, wrap);
      const float most = std::max(writer.size, ImGui::GetIO().DisplaySize.x - extent.x - writer.size);
      const ImVec2 below{std::min(at.x, most), corner.y + 0.6F * writer.size};
      TextWriter overPanels = writer;
      overPanels.list = ImGui::GetForegroundDrawList();
      overPanels.shade(below, {below.x + extent.x, below.y + extent.y});
      overPanels.write(below, ink.text, kind.how, wrap);
    }
    areas_.push_back({at, corner});
    at.x = corner.x + kGap * writer.size;
  }
}

bool ToolBar::handle(const WindowEvent& event, Viewer& viewer) const {
  if (event.kind != WindowEvent::Kind::Press || event.key != kLeftButton) return false;
  const auto pressed =
      std::ranges::find_if(areas_, [&](const Area& area) { return inside(positionOf(event), area.from, area.to); });
  if (pressed == areas_.end()) return false;
  viewer.tools().choose(static_cast<std::size_t>(pressed - areas_.begin()));
  return true;
}

namespace {

/// Pixels of the framebuffer in one of ImGui's units.
glm::vec2 perUnit() {
  const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
  return {std::max(scale.x, 0.01F), std::max(scale.y, 0.01F)};
}

}  // namespace

void drawHold(const TextWriter& writer, glm::vec2 place) {
  const glm::vec2 at = place / perUnit();
  constexpr float kFar = 1e5F;
  if (!(std::abs(at.x) + std::abs(at.y) < kFar)) return;
  const Colours& ink = coloursOn(writer.background);
  const ImVec2 middle{at.x, at.y};
  const float radius = 0.6F * writer.size, thick = std::max(2.0F, writer.size / 8);
  writer.list->AddCircle(middle, radius, ink.shade, 32, 2.2F * thick);
  writer.list->AddCircle(middle, radius, ink.text, 32, thick);
  writer.list->AddCircleFilled(middle, 0.22F * writer.size, ink.text, 16);
}

void drawCutLine(const TextWriter& writer, const ScreenLine& line) {
  const glm::vec2 unit = perUnit();
  const glm::vec2 from = line.from / unit, way = line.to / unit - from;
  const float length = glm::length(way);
  if (!(length > 0) || !std::isfinite(length)) return;
  constexpr float kMostDashes = 400;  // of a line that reaches far out of the window
  const float dash = std::max(0.5F * writer.size, length / kMostDashes);
  const Colours& ink = coloursOn(writer.background);
  const auto at = [&](float along) {
    const glm::vec2 p = from + std::min(along / length, 1.0F) * way;
    return ImVec2(p.x, p.y);
  };
  writer.list->AddLine(at(0), at(length), ink.shade, std::max(4.0F, writer.size / 4));
  for (float along = 0; along < length; along += 1.6F * dash) {
    writer.list->AddLine(at(along), at(along + dash), ink.warning, std::max(2.0F, writer.size / 8));
  }
}

}  // namespace tyg
