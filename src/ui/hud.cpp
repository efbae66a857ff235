// The layout of the text over the picture. Everything is drawn from a font size and the screen's size, so that it stays
// readable and uncut at any scale. The foot of the window is in hud_foot.cpp.
#include "ui/hud.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "tyg/methods.h"
#include "ui/cloth_painter.h"
#include "ui/failure_picture.h"
#include "util/visible_text.h"
#include "view/picking.h"

namespace tyg {

/// The short list of keys.
struct Hud::Column {
  float size = 0, left = 0, top = 0;
  KeyList::Widths widths;
  [[nodiscard]] float width() const { return widths.all * size; }
};

namespace {

constexpr float kLineRatio = 1.35F;
/// Sizes of the text from the window's upper edge to the left keys: the title is there.
constexpr float kAbove = 1 + 1.5F * kLineRatio;
constexpr float kLeastFit = 0.55F;
/// Lines of text that a window has room for at least: in a low one large text is smaller.
constexpr float kFewestLines = 20;
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
  switch (line.action()) {
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

/// For widths alone, which do not depend on colours.
TextWriter Hud::keysWriter() const { return {nullptr, fonts_.text, size_, Background::Dark}; }

/// `room`: how far to the right and how far down the keys may reach.
Hud::Column Hud::columnIn(const ImVec2& room) const {
  const std::vector<const HelpLine*> lines = firstLines(help_, help_.size());
  Column column{.size = size_, .left = size_, .top = size_ * kAbove, .widths = KeyList::widthsOf(keysWriter(), lines)};
  const float height = room.y - column.top, width = size_ + column.width();
  // A window too small for the keys gets smaller keys rather than cut ones, or keys over the cloth; a very low one
  // those that fit and can be read.
  const float fits = height / (kLineRatio * size_ * float(lines.size()));
  column.size *= std::min({1.0F, std::max(kLeastFit, fits), kKeysShare * room.x / width});
  return column;
}

int Hud::keysWidth(Extent window) const {
  if (window.width <= 0 || window.height <= 0) return 0;
  const ImVec2 room{static_cast<float>(window.width), static_cast<float>(window.height) - kFoot * size_};
  return static_cast<int>(columnIn(room).width() + 2 * size_);
}

bool Hud::pressKey(const WindowEvent& event, const Input* under) {
  if (event.kind != WindowEvent::Kind::Press || event.key != kLeftButton || under == nullptr) return false;
  keyDown_ = under->key;
  keyEvents_.push_back({.kind = WindowEvent::Kind::Press, .key = keyDown_});
  return true;
}

bool Hud::pressAllKeys(const WindowEvent& event, Viewer& viewer) {
  if (event.kind == WindowEvent::Kind::Release && event.key == kLeftButton && keyDown_ != 0) {
    keyEvents_.push_back({.kind = WindowEvent::Kind::Release, .key = std::exchange(keyDown_, KeyCode{0})});
  }
  if (!viewer.view().showsAllKeys() || event.kind != WindowEvent::Kind::Press) return false;
  if (!isMouse(event.key) && event.key != kEscapeKey) return false;
  const Input* under = event.key == kLeftButton ? allKeys_.at(positionOf(event)) : nullptr;
  viewer.perform(InputAction::ShowAllKeys);
  if (under != nullptr && under->action != InputAction::ShowAllKeys) pressKey(event, under);
  return true;
}

void Hud::draw(const Viewer& viewer, Panels& panels) {
  size_ = std::min(fonts_.size, std::max(1.0F, screenSize().y / kFewestLines));
  const Colours& colours = coloursOn(viewer.view().drawOptions().background);
  const TextWriter writer = writerFor(viewer);
  const std::string title = oneLine(viewer.run().simulation().scene().title);
  writer.shade({size_, size_}, {size_ + writer.extent(title).x, 2 * size_});
  writer.write({size_, size_}, colours.text, title);
  drawTools(viewer, size_ + writer.extent(title).x);
  const float free = drawFoot(viewer, panels);
  keys_.clear();
  if (!panels.isAt(Edge::Left)) drawKeys(viewer, free);
  drawWind(viewer, colours);
  drawArrow(viewer, colours);
  drawPicture(viewer, panels, free);
  if (!viewer.view().showsAllKeys()) return allKeys_.hide();
  allKeys_.draw(writer, help_, [&](const HelpLine& line) { return isOn(line, viewer); });
}

/// `free`: the height above which there is room.
void Hud::drawPicture(const Viewer& viewer, const Panels& panels, float free) {
  picture_ = {};
  if (viewer.run().state() != RunState::Frozen && !viewer.run().showsBreaking()) return;
  const float right = screenSize().x - panels.width(Edge::Right) - size_, left = float(viewer.view().insets().left);
  const ImVec2 from{left, kTop * size_ + panels.titles()}, to{right, free - size_};
  picture_ = drawFailurePicture(writerFor(viewer), from, to, viewer);
  if (picture_.x > 0) picture_.x += 2 * size_;
}

/// In the upper line, right of the title, which ends at `from`; and the line that is drawn to cut along.
void Hud::drawTools(const Viewer& viewer, float from) {
  tools_.draw(writerFor(viewer), {from + 1.5F * size_, screenSize().x - size_}, viewer);
  const ToolDrawing drawing = viewer.tools().drawing();
  if (drawing.cut) drawCutLine(writerFor(viewer), *drawing.cut);
  const Extent pixels = viewer.view().pixels();
  for (const int particle : viewer.run().shown().held()) {
    const float* p = &viewer.run().shown().positions()[3 * static_cast<std::size_t>(particle)];
    drawHold(writerFor(viewer),
             placeInWindow(viewer.view().camera(), {p[0], p[1], p[2]}, {pixels.width, pixels.height}));
  }
}

int Hud::windHeight(const Viewer& viewer) const {
  constexpr float kHeight = 3;  // sizes of the text
  return viewer.run().simulation().scene().winds.empty() ? 0 : static_cast<int>(kHeight * size_);
}

/// Its speed, to the right of its arrow.
void Hud::drawWind(const Viewer& viewer, const Colours& colours) const {
  const std::optional<ShownWind> wind = shownWind(viewer);
  if (!wind) return;
  const Vec3& v = wind->velocity;
  const std::string text = fmt::format("wind {:.1f} m/s", std::hypot(v.x, v.y, v.z));
  const ImVec2 screen = screenSize();
  const Insets& insets = viewer.view().insets();
  TextWriter writer = writerFor(viewer);
  const float left = wind->at.x * screen.x + 0.5F * wind->longest * screen.y + 0.3F * size_;
  const float room = screen.x - float(insets.right) - size_ - left;
  writer.size *= std::clamp(room / std::max(1.0F, writer.extent(text).x), 0.1F, 1.0F);
  const ImVec2 at{left, wind->at.y * screen.y - writer.size / 2}, extent = writer.extent(text);
  writer.shade(at, {at.x + extent.x, at.y + extent.y});
  writer.write(at, colours.dim, text);
}

/// As many lines as fit above `free`, which may be smaller there than elsewhere.
void Hud::drawKeys(const Viewer& viewer, float free) {
  const ImVec2 screen = screenSize();
  const Column column = columnIn({screen.x, std::min(free, screen.y - kFoot * size_)});
  TextWriter writer = writerFor(viewer);
  writer.size = column.size;
  const float height = kLineRatio * column.size, room = viewer.view().showsHelp() ? free - column.top : height;
  float y = column.top;
  for (const HelpLine* line : firstLines(help_, static_cast<std::size_t>(std::max(0.0F, room / height)))) {
    writer.shade({column.left, y}, {column.left + column.width(), y + height});
    keys_.draw(writer, {column.left, y}, column.widths, *line, isOn(*line, viewer));
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
  constexpr std::string_view kLabel = "the cloth is there: F fits it in view";
  const ImVec2 extent = extentOf(fonts_.text, size_, kLabel);
  const glm::vec2 middle = back - arrow->direction * (size_ + 0.5F * extent.x * std::abs(arrow->direction.x));
  const ImVec2 at{std::clamp(middle.x - 0.5F * extent.x, size_, std::max(size_, screen.x - extent.x - size_)),
                  std::clamp(middle.y - 0.5F * size_, size_, std::max(size_, screen.y - 2 * size_))};
  write(fonts_.text, size_, at, colours.accent, kLabel);
}

}  // namespace tyg
