// Parts of the picture's overlay that show the state of time and of the step: the margin bar, the time line, which can
// be dragged, and buttons. Drawn with ImGui's draw lists. Must not know: windows, what a button's action does.
#pragma once

#include <imgui.h>

#include <string>
#include <vector>

#include "viewer/input_table.h"
#include "viewer/margin.h"
#include "viewer/viewer.h"

namespace tyg {

/// Writes text, and grounds for it, in one font and size.
struct TextWriter {
  ImDrawList* list;
  ImFont* font;
  float size;  ///< of the text, in ImGui's units
  Background background;

  /// `wrap`, where it is above 0: the width at which lines are broken.
  [[nodiscard]] ImVec2 extent(std::string_view text, float wrap = 0) const;
  void write(ImVec2 at, ImU32 colour, std::string_view text, float wrap = 0) const;
  /// A rounded ground for text between these corners, so that it can be read over the cloth.
  void shade(ImVec2 from, ImVec2 to) const;

 private:
  [[nodiscard]] std::string linesOf(std::string_view text, float wrap) const;
};

/// In ImGui's units.
bool inside(ImVec2 at, ImVec2 from, ImVec2 to);
/// Events count in pixels of the framebuffer, ImGui in units of the window.
ImVec2 positionOf(const WindowEvent& event);

/// The step beside its limit, as a bar from 0 to 1.25 of the limit with a tick at the limit and hatching beyond it:
/// green, amber from 0.9 on, red and hatched from 1 on. Nothing is drawn where there is no limit.
void drawMarginBar(const TextWriter& writer, ImVec2 from, ImVec2 to, const Margin& margin);
/// That bar and what it says in words, `width` wide at most; returns the width used.
float drawMargin(TextWriter writer, ImVec2 at, float width, const Margin& margin);

/// The last ten seconds as a line with a handle.
class TimeLine {
 public:
  /// Between these corners. Draws nothing, and takes no events until it is drawn again, where there is nothing to go
  /// back to.
  void draw(const TextWriter& writer, ImVec2 from, ImVec2 to, const Viewer& viewer);
  void hide() { shown_ = false; }
  /// True where the event was for it: a press on the line, and until the release every movement.
  bool handle(const WindowEvent& event, Viewer& viewer);
  [[nodiscard]] bool dragged() const { return dragged_; }

 private:
  void turn(double x, Viewer& viewer) const;
  bool shown_ = false, dragged_ = false;
  ImVec2 from_, to_;
  Timeline time_;
};

/// A row of buttons, each named by its key and what it does.
class Buttons {
 public:
  struct Button {
    std::string key, text;
    InputAction action;
  };
  /// Height of the row within this width, where it may need more than one line.
  [[nodiscard]] static float height(const TextWriter& writer, const std::vector<Button>& buttons, float width);
  [[nodiscard]] static float width(const TextWriter& writer, const std::vector<Button>& buttons);  ///< in one line
  void draw(const TextWriter& writer, ImVec2 at, const std::vector<Button>& buttons, float width);
  void hide() { areas_.clear(); }
  /// True where the event was a press on a button, whose action was then performed.
  bool handle(const WindowEvent& event, Viewer& viewer);

 private:
  struct Area {
    ImVec2 from, to;
    InputAction action;
  };
  std::vector<Area> areas_;
};

}  // namespace tyg
