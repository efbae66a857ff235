// The tools of the left button as a bar in the window: what each does, which one is chosen. Drawn with ImGui's draw
// lists. Must not know: windows, any tool in particular.
#pragma once

#include <vector>

#include "ui/overlay.h"

namespace tyg {

class ToolBar {
 public:
  /// In the upper line of the window, in its middle where that lies within these places across it (`x` the left one).
  /// Where there is no room for the words it shows icons alone, and where there is none for these, nothing.
  void draw(const TextWriter& writer, ImVec2 across, const Viewer& viewer);
  /// True where the event was a press on a tool, which is chosen then.
  bool handle(const WindowEvent& event, Viewer& viewer) const;

 private:
  struct Area {
    ImVec2 from, to;
  };
  std::vector<Area> areas_;  ///< one for each tool; none where nothing is drawn
};

/// A dashed line over the cloth.
/// A ring and a dot in it at this place (pixels of the framebuffer): what a hand holds.
void drawHold(const TextWriter& writer, glm::vec2 place);
void drawCutLine(const TextWriter& writer, const ScreenLine& line);

}  // namespace tyg
