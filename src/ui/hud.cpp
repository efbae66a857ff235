// The layout of the text over the picture. Everything is drawn from a font size and the screen's size, so that it stays
// readable and uncut at any scale. The foot of the window is in hud_foot.cpp.
#include "ui/hud.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "tyg/methods.h"
#include "ui/cloth_painter.h"
#include "util/visible_text.h"

namespace tyg {

/// One of the two blocks of keys: left, driving; right, choices.
struct Hud::Column {
  float size = 0, left = 0, top = 0;
  float keys = 0, width = 0;  ///< of the key names, of the whole block
  int lines = 0;
};

namespace {

constexpr float kLineRatio = 1.35F;
/// Sizes of the text from the window's upper edge to the left keys: the title is there.
constexpr float kAbove = 1 + 1.5F * kLineRatio;
constexpr float kLeastFit = 0.55F;
/// Of the window's width, for the keys on each side.
constexpr float kKeysShare = 0.26F;
ImVec2 extentOf(ImFont* font, float size, std::string_view text, float wrap = 0) {
  return font->CalcTextSizeA(size, 1e6F, wrap, text.data(), text.data() + text.size());
}

void write(ImFont* font, float size, ImVec2 at, ImU32 colour, std::string_view text, float wrap = 0) {
  ImGui::GetBackgroundDrawList()->AddText(font, size, at, colour, text.data(), text.data() + text.size(), wrap);
}

ImVec2 screenSize() { return ImGui::GetIO().DisplaySize; }

bool isOn(const HelpLine& line, const Viewer& viewer) {
  const DrawOptions& draw = viewer.view().drawOptions();
  const bool lines = draw.show != Show::Surface;
  switch (line.action) {
    case InputAction::ChooseMethod:
      return &methods()[line.method] == &viewer.scenes().method();
    case InputAction::ChangeShow:
      return draw.show != Show::Lines;
    case InputAction::ShowStructural:
      return lines && draw.structural;
    case InputAction::ShowShear:
      return lines && draw.shear;
    case InputAction::ShowBend:
      return lines && draw.bend;
    case InputAction::ShowParticles:
      return draw.particles;
    case InputAction::ShowPins:
      return draw.pins;
    case InputAction::ShowGround:
      return draw.ground;
    default:
      return false;
  }
}

}  // namespace

Hud::Hud(const TextFonts& fonts) : fonts_(fonts), size_(fonts.size), help_(helpLines(methodNames())) {}

TextWriter Hud::writerFor(const Viewer& viewer) const {
  return {ImGui::GetBackgroundDrawList(), fonts_.text, size_, viewer.view().drawOptions().background};
}

Hud::Column Hud::measure(bool choices) const {
  Column column{.size = size_};
  float help = 0;
  for (const HelpLine& line : help_) {
    if (isChoice(line.action) != choices) continue;
    column.keys = std::max(column.keys, extentOf(fonts_.text, size_, line.keys).x);
    help = std::max(help, extentOf(fonts_.text, size_, line.help).x);
    ++column.lines;
  }
  column.keys += size_;
  column.width = column.keys + help;
  return column;
}

/// `room`: how far to the right and how far down the keys of both sides may reach.
Hud::Column Hud::columnOf(bool choices, const ImVec2& room) const {
  Column column = measure(choices);
  const Column other = measure(!choices);
  const auto lines =
      static_cast<float>(std::max(column.lines, other.lines) + 1);  // one for the gap between the choices
  const float height = room.y - kAbove * size_;
  const float width = size_ + std::max(column.width, other.width);
  // A window too small for the keys gets smaller keys rather than cut ones, or keys over the cloth; a very low one
  // those that fit and can be read.
  const float fit =
      std::min({1.0F, std::max(kLeastFit, height / (kLineRatio * size_ * lines)), kKeysShare * room.x / width});
  column.size *= fit, column.keys *= fit, column.width *= fit;
  column.left = choices ? room.x - size_ - column.width : size_;
  column.top = choices ? size_ : size_ * kAbove;
  return column;
}

int Hud::keysWidth(Extent window) const {
  if (window.width <= 0 || window.height <= 0) return 0;
  const ImVec2 room{static_cast<float>(window.width), static_cast<float>(window.height) - kFoot * size_};
  return static_cast<int>(std::max(columnOf(false, room).width, columnOf(true, room).width) + 2 * size_);
}

void Hud::draw(const Viewer& viewer, Panels& panels) {
  const Colours& colours = coloursOn(viewer.view().drawOptions().background);
  const TextWriter writer = writerFor(viewer);
  const std::string title = oneLine(viewer.run().simulation().scene().title);
  writer.shade({size_, size_}, {size_ + writer.extent(title).x, 2 * size_});
  writer.write({size_, size_}, colours.text, title);
  drawTools(viewer, panels, size_ + writer.extent(title).x);
  const float free = drawFoot(viewer, panels);
  if (viewer.view().showsHelp()) {
    for (const bool choices : {false, true}) {
      if (panels.width(choices ? Edge::Right : Edge::Left) == 0) drawKeys(viewer, colours, choices, free);
    }
  } else if (panels.width(Edge::Left) == 0) {
    write(fonts_.text, size_, {size_, size_ * (1 + kLineRatio)}, colours.dim, "H shows the keys");
  }
  drawWind(viewer, colours);
  drawArrow(viewer, colours);
}

/// In the upper line, right of the title, which ends at `from`; and the line that is drawn to cut along.
void Hud::drawTools(const Viewer& viewer, const Panels& panels, float from) {
  const ImVec2 screen = screenSize();
  const bool keys = viewer.view().showsHelp() && panels.width(Edge::Right) == 0;
  const float right = keys ? columnOf(true, {screen.x, screen.y - kFoot * size_}).left : screen.x;
  tools_.draw(writerFor(viewer), {from + 1.5F * size_, right - 1.5F * size_}, viewer);
  const ToolDrawing drawing = viewer.tools().drawing();
  if (drawing.cut) drawCutLine(writerFor(viewer), *drawing.cut);
}

/// Its speed, below its arrow.
void Hud::drawWind(const Viewer& viewer, const Colours& colours) const {
  const std::optional<ShownWind> wind = shownWind(viewer);
  if (!wind) return;
  const Vec3& v = wind->velocity;
  const std::string text = fmt::format("wind {:.1f} m/s", std::hypot(v.x, v.y, v.z));
  const ImVec2 screen = screenSize(), extent = extentOf(fonts_.text, size_, text);
  constexpr float kBelow = 0.075F;  // heights of the window, from the arrow's middle: it is hardly longer
  write(fonts_.text, size_, {wind->at.x * screen.x - extent.x / 2, (wind->at.y + kBelow) * screen.y}, colours.dim,
        text);
}

/// As many lines as fit above `free`, which may be smaller there than elsewhere.
void Hud::drawKeys(const Viewer& viewer, const Colours& colours, bool choices, float free) const {
  const ImVec2 screen = screenSize();
  const Column column = columnOf(choices, {screen.x, std::min(free, screen.y - kFoot * size_)});
  const float gap = choices ? 0.6F * column.size : 0, height = kLineRatio * column.size;
  const float room = std::max(0.0F, (free - column.top - gap) / height);
  const std::vector<const HelpLine*> lines = linesThatFit(help_, choices, static_cast<std::size_t>(room));
  writerFor(viewer).shade({column.left, column.top},
                          {column.left + column.width, column.top + gap + height * float(lines.size())});
  float y = column.top;
  bool methodLines = choices;
  for (const HelpLine* each : lines) {
    const HelpLine& line = *each;
    if (methodLines && line.action != InputAction::ChooseMethod) {
      methodLines = false;
      y += gap;
    }
    const bool on = isOn(line, viewer);
    write(fonts_.text, column.size, {column.left, y}, on ? colours.accent : colours.text, line.keys);
    write(fonts_.text, column.size, {column.left + column.keys, y}, on ? colours.accent : colours.dim, line.help);
    y += height;
  }
}

void Hud::drawArrow(const Viewer& viewer, const Colours& colours) const {
  const ImVec2 screen = screenSize();
  const auto arrow = edgeArrow(viewer.view().camera(), viewer.run().shown().box(), {screen.x, screen.y}, 2 * size_);
  if (!arrow) return;
  const glm::vec2 back = arrow->tip - 1.6F * size_ * arrow->direction;
  const glm::vec2 side = 0.8F * size_ * glm::vec2(-arrow->direction.y, arrow->direction.x);
  const auto point = [](glm::vec2 p) { return ImVec2(p.x, p.y); };
  ImGui::GetBackgroundDrawList()->AddTriangleFilled(point(arrow->tip), point(back - side), point(back + side),
                                                    colours.accent);
  constexpr std::string_view kLabel = "the cloth is there: F finds it";
  const ImVec2 extent = extentOf(fonts_.text, size_, kLabel);
  const glm::vec2 middle = back - arrow->direction * (size_ + 0.5F * extent.x * std::abs(arrow->direction.x));
  const ImVec2 at{std::clamp(middle.x - 0.5F * extent.x, size_, std::max(size_, screen.x - extent.x - size_)),
                  std::clamp(middle.y - 0.5F * size_, size_, std::max(size_, screen.y - 2 * size_))};
  write(fonts_.text, size_, at, colours.accent, kLabel);
}

}  // namespace tyg
