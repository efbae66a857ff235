// The text over the picture: keys, status line, prompts, the arrow to a cloth out of sight. Drawn with ImGui, whose
// context exists as long as this lives. Must not know: window libraries, what an input does, how panels are drawn.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ui/all_keys.h"
#include "ui/fonts.h"
#include "ui/key_list.h"
#include "ui/overlay.h"
#include "ui/panels/panels.h"
#include "ui/tool_bar.h"
#include "viewer/viewer.h"

namespace tyg {

class Hud {
 public:
  explicit Hud(const TextFonts& fonts);

  /// True where the event was a press on one of the buttons, whose action was then performed.
  bool pressButton(const WindowEvent& event, Viewer& viewer) {
    return buttons_.handle(event, viewer) || tools_.handle(event, viewer) ||
           pressKey(event, keys_.at(positionOf(event)));
  }
  /// The same for what is said of a failure where it lies over panels: they do not feel presses on it.
  bool pressFailure(const WindowEvent& event, Viewer& viewer);
  /// The same for the long list of keys, while it is shown: any press outside it, and Esc, closes it. What a press on a
  /// key comes to is in takeKeys().
  bool pressAllKeys(const WindowEvent& event, Viewer& viewer);
  /// The keys that were pressed and let go of by the mouse since the last call, to be routed like those of a keyboard.
  [[nodiscard]] std::vector<WindowEvent> takeKeys() { return std::exchange(keyEvents_, {}); }
  /// True where the event was for the time line.
  bool dragTime(const WindowEvent& event, Viewer& viewer) { return timeLine_.handle(event, viewer); }
  /// Pixels that the short list of keys takes at the left of a window of this size.
  [[nodiscard]] int keysWidth(Extent window) const;
  /// Pixels that bars and what is said take at the upper and the lower edge.
  [[nodiscard]] int above() const { return static_cast<int>(kTop * size_ + picture_.y); }
  [[nodiscard]] int below(const Viewer& viewer) const;
  /// Pixels below the bars at the upper edge that the arrow of a wind takes, whether it blows just now or not; 0 where
  /// the scene has no wind.
  [[nodiscard]] int windHeight(const Viewer& viewer) const;
  /// Pixels that the picture of what fails first takes, to the left of panels at the right edge.
  [[nodiscard]] int beside() const { return static_cast<int>(picture_.x); }
  /// Between ImGui::NewFrame and ImGui::Render. Keys are left out at an edge that has panels, and the panels are told
  /// how far down they may reach.
  void draw(const Viewer& viewer, Panels& panels);
  /// A line to show while the cloth runs and there is nothing more important to say; empty: none.
  void hint(std::string_view text) { hint_ = text; }
  /// A line to show in any case: what is being filmed; empty: nothing is.
  void filming(std::string_view text) { filming_ = text; }

 private:
  /// Heights at the foot, in sizes of the text: a line, the time line, and both with the status below them; and of the
  /// bars at the upper edge.
  static constexpr float kLine = 1.5F, kTimeLine = 2, kFoot = 2 + kLine + 0.6F + kTimeLine, kTop = 2.4F;
  struct Column;
  struct Middle;
  [[nodiscard]] Middle middleBetween(const Panels& panels, float least, float keys, float bottom) const;
  [[nodiscard]] TextWriter writerIn(const Viewer& viewer, const Middle& middle) const;
  void makeWay(const Panels& panels, bool frozen);
  static void ground(const TextWriter& writer, ImVec2 from, ImVec2 to, const Middle& middle);
  static void sayInMiddle(const TextWriter& writer, ImU32 colour, std::string_view text, Middle& middle);
  bool pressKey(const WindowEvent& event, const Input* under);
  [[nodiscard]] TextWriter keysWriter() const;
  [[nodiscard]] Column columnIn(const ImVec2& room) const;
  void drawKeys(const Viewer& viewer, float free);
  [[nodiscard]] TextWriter writerFor(const Viewer& viewer) const;
  float drawFoot(const Viewer& viewer, Panels& panels);
  [[nodiscard]] float drawStatus(const Viewer& viewer) const;
  float drawTimeLine(const Viewer& viewer, float bottom);
  [[nodiscard]] std::string promptText(const Viewer& viewer) const;
  void drawPrompt(const Viewer& viewer, Middle& middle) const;
  void drawFailure(TextWriter writer, const Viewer& viewer, Middle& middle);
  void drawFailureOver(const Viewer& viewer, Middle& middle);
  void drawPicture(const Viewer& viewer, const Panels& panels, float free);
  void drawTools(const Viewer& viewer, float from);
  void drawWind(const Viewer& viewer, const Colours& colours) const;
  void drawArrow(const Viewer& viewer, const Colours& colours) const;

  TextFonts fonts_;
  float size_;  ///< of the text, in ImGui's units
  std::vector<HelpLine> help_;
  std::string hint_, filming_;
  KeyList keys_;
  AllKeys allKeys_;
  std::vector<WindowEvent> keyEvents_;
  KeyCode keyDown_ = 0;      ///< by the mouse
  float failure_ = 0;        ///< height of all that is at the foot with the last failure, ImGui's units; 0 before
  float said_ = 0;           ///< likewise with the lines that stand for a failure that gives way; 0: it does not
  ImVec2 picture_;           ///< what the picture of what fails first takes beside and above the cloth, ImGui's units
  int openedBefore_ = 0;     ///< Panels::timesOpened() before the failure
  bool givesWay_ = false;    ///< what is said of the failure gives way to a panel that was opened since
  bool overPanels_ = false;  ///< what is said of the failure is ...
  ImVec2 failureFrom_, failureTo_;  ///< ... and its corners
  TimeLine timeLine_;
  Buttons buttons_;
  ToolBar tools_;
};

}  // namespace tyg
