// ImGui in a window: its context, its two backends (the window library and OpenGL) and its fonts.
// Must not know: what is drawn with it.
#pragma once

#include "ui/fonts.h"
#include "ui/windows/window.h"

namespace tyg {

class ImGuiSession {
 public:
  /// Attaches to the window, whose context must be current, and which must live as long as this does. `uiScale` > 0
  /// scales all text, on top of the screen's own scale.
  ImGuiSession(Window& window, double uiScale);
  ~ImGuiSession();
  ImGuiSession(const ImGuiSession&) = delete;
  ImGuiSession& operator=(const ImGuiSession&) = delete;

  [[nodiscard]] const TextFonts& fonts() const { return fonts_; }
  [[nodiscard]] float scale() const { return scale_; }  ///< of all that is drawn; 1 on an ordinary screen
  /// What is drawn with ImGui between these two comes onto the picture at the end.
  void beginFrame();
  static void endFrame();

 private:
  Window& window_;
  float scale_;
  TextFonts fonts_;
};

/// True where ImGui needs the event for one of its widgets: a key for a field that is typed into, the wheel for a list.
/// Presses of the mouse are left to the panels, which know without a frame's delay where they are. A release is never
/// ImGui's alone: no key stays down for others because a panel got the other half.
bool imGuiTakes(const WindowEvent& event);

}  // namespace tyg
