// The text over the picture: keys, status line, prompts, the arrow to a cloth out of sight. Drawn with ImGui.
// Must not know: window libraries, what an input does.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "ui/overlay.h"
#include "ui/panels/panels.h"
#include "viewer/viewer.h"

struct ImDrawList;
struct ImFont;
struct ImVec2;

namespace tyg {

class Hud {
 public:
  /// Attaches to the window, whose context must be current. `uiScale` > 0 scales all text, on top of the screen's own.
  Hud(Window& window, double uiScale);
  ~Hud();
  Hud(const Hud&) = delete;
  Hud& operator=(const Hud&) = delete;

  /// True where the event belongs to a panel and the viewer must not see it. Releases always reach the viewer: no key
  /// stays down there because a panel got the other half.
  [[nodiscard]] bool takes(const WindowEvent& event) const;
  /// Buttons and the line of time use the event: true where the viewer must not see it.
  bool handle(const WindowEvent& event, Viewer& viewer);
  /// Pixels of the framebuffer that the keys take on each side.
  [[nodiscard]] int margin() const;
  /// The text and the panels, which take the place of the keys at their edge of the window.
  void draw(Viewer& viewer, Panels& panels);
  /// A line to show while the cloth runs and nothing weightier is to be said; empty: none.
  void notice(std::string_view text) { notice_ = text; }
  /// A line to show in any case: what is being filmed; empty: nothing is.
  void filming(std::string_view text) { filming_ = text; }
  [[nodiscard]] float textSize() const { return size_; }  ///< pixels

 private:
  /// Heights at the foot, in sizes of the text: a line, the line of time, and both with the status below them.
  static constexpr float kLine = 1.5F, kTimeLine = 2, kFoot = 2 + kLine + 0.6F + kTimeLine;
  struct Column;
  struct Middle;
  [[nodiscard]] Middle middleBetween(const Panels& panels, float keys, float bottom) const;
  [[nodiscard]] Pen penIn(const Viewer& viewer, const Middle& middle) const;
  static void ground(const Pen& pen, ImVec2 from, ImVec2 to, const Middle& middle);
  static void sayInMiddle(const Pen& pen, ImU32 colour, std::string_view text, Middle& middle);
  [[nodiscard]] Column measure(bool choices) const;
  [[nodiscard]] Column columnOf(bool choices, const ImVec2& screen) const;
  void drawKeys(const Viewer& viewer, const Colours& colours, bool choices, float free) const;
  [[nodiscard]] Pen penFor(const Viewer& viewer) const;
  float drawFoot(const Viewer& viewer, Panels& panels);
  [[nodiscard]] float drawStatus(const Viewer& viewer) const;
  float drawTimeLine(const Viewer& viewer, float bottom);
  void drawPrompt(const Viewer& viewer, Middle& middle) const;
  void drawFailure(const Viewer& viewer, Middle& middle);
  void drawArrow(const Viewer& viewer, const Colours& colours) const;

  Window& window_;
  ImFont* font_ = nullptr;
  ImFont* large_ = nullptr;
  float size_ = 18;  ///< of the text, in ImGui's units
  std::vector<HelpLine> help_;
  std::string notice_, filming_;
  TimeLine timeLine_;
  Buttons buttons_;
};

}  // namespace tyg
