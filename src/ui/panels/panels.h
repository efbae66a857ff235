// The panels that are open: opens and closes them by key, x and Esc, and places them along the window's edges, where
// they cover the keys and not the cloth. Must not know: what any panel shows, window libraries.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ui/panels/panel.h"
#include "ui/windows/window.h"
#include "viewer/edits.h"

namespace tyg {

class Panels {
 public:
  /// `size`: of the text, pixels. An ImGui context exists as long as this lives.
  Panels(float size, const Viewer& viewer) : size_(size), edits_(viewer), slots_(panelTable().size()) {}

  /// What the person did, but for keys that go to a text field. A press of the mouse on a panel is ImGui's; a panel's
  /// key opens or closes it, Esc closes the one opened last, Ctrl+Z undoes the last change of the scene, Ctrl+Y and
  /// Ctrl+Shift+Z do it again, Ctrl+C copies what the panels and the window's foot say. True where that was all; false
  /// where the event is for the viewer.
  bool handle(const WindowEvent& event, Viewer& viewer);
  void toggle(InputAction action);
  [[nodiscard]] bool isOpen(InputAction action) const;

  /// Once a frame, after the cloth has moved. Opens the panel that the viewer asks for.
  void follow(Viewer& viewer);
  /// What the open panels show on the cloth, the one opened last on top.
  void paint(ClothPicture& picture);
  /// Panels end above this height, pixels from the top of the window.
  void endAbove(float y) { floor_ = y; }
  /// All open panels, between ImGui::NewFrame and ImGui::Render. Where an edge is too low for all panels at it,
  /// those opened longest ago are folded to their titles; a click on a title makes it the one opened last. Where the
  /// window is too narrow for panels at both edges, those at the edge without the one opened last are folded.
  void draw(Viewer& viewer);

  /// Pixels that panels at this edge take of the window's width; 0 where there are none, or titles alone.
  [[nodiscard]] float width(Edge edge) const;
  /// How often a panel has been opened or unfolded so far.
  [[nodiscard]] int timesOpened() const { return timesOpened_; }
  /// Pixels below the bars at the upper edge that titles take where there are titles alone.
  [[nodiscard]] float titles() const;
  /// There is a panel, or the title of one.
  [[nodiscard]] bool isAt(Edge edge) const;
  /// Insets::beside.
  [[nodiscard]] float beside() const;
  [[nodiscard]] bool busy() const;

 private:
  struct Slot {
    std::unique_ptr<Panel> panel;  ///< null until it is first opened
    bool open = false;
    bool dragged = false;                                 ///< is where somebody put it
    bool folded = false;                                  ///< only its title is shown
    float top = 0, maxHeight = 0;                         ///< where it may be, and how high it may be there
    float x = 0, y = 0;                                   ///< where it was placed, ImGui's units
    float title = 0, natural = 0;                         ///< heights of its title and of all it has to show; 0 before
    float shownX = 0, shownY = 0, width = 0, height = 0;  ///< as last drawn; 0 before
  };
  [[nodiscard]] bool covers(double x, double y) const;
  [[nodiscard]] static bool isPopupOpen();
  [[nodiscard]] bool takesMouse(const WindowEvent& event) const;
  void setOpen(std::size_t which, bool open);
  void show(std::size_t which);
  void closeLast();
  void handleControl(const WindowEvent& event, Viewer& viewer);
  void arrange(Edge edge);
  void watchMouse();
  void drawOne(std::size_t which, Viewer& viewer, std::string* copy);
  void placeNext(std::size_t which);
  void measure(std::size_t which);
  [[nodiscard]] bool isAtEdge(std::size_t which, Edge edge) const;
  [[nodiscard]] float widest(Edge edge) const;
  [[nodiscard]] bool yields(Edge edge) const;
  [[nodiscard]] float largestText() const;
  [[nodiscard]] float textSize(const PanelKind& kind) const;
  [[nodiscard]] float widthOf(const PanelKind& kind) const;
  [[nodiscard]] float widthOf(std::size_t which) const;

  bool copyAsked_ = false;
  int timesOpened_ = 0;
  float size_;
  float floor_ = 1e6F;
  double rested_ = -1e6;                              ///< s, ImGui's time at which the mouse last moved
  Colouring::By colouredBy_ = Colouring::By::Family;  ///< since the last paint()
  Edits edits_;
  std::vector<Slot> slots_;         ///< one for each line of the table
  std::vector<std::size_t> order_;  ///< of those open, last opened last
};

}  // namespace tyg
