// What a panel is: one study or set of controls, drawn inside a window of its own over the cloth.
// Adding one is a file, a line in panel_table.cpp and a line in input_table.cpp for its key.
// Must not know: any panel in particular, where panels are placed.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "ui/panels/style.h"
#include "viewer/input_table.h"

namespace tyg {

class Edits;
class Viewer;
struct Method;
struct Sheet;
struct WindowEvent;

/// What a panel is drawn with.
struct PanelScope {
  Viewer& viewer;
  Edits& edits;
  const Colours& colours;
  Background background;
  float size;                ///< of the text, pixels
  bool tips;                 ///< tooltips show: the mouse has just come to rest, and nothing is held or typed
  Colouring::By colouredBy;  ///< what the colours on the cloth are by, of whichever panel
};

/// What a method is, in a line or two.
std::string aboutMethod(const Method& method);
/// Tells what the item drawn last is for, where tooltips show.
void tip(const PanelScope& scope, const std::string& text);

/// How the cloth is drawn in a frame, for panels that show something on it.
struct ClothPicture {
  DrawOptions options;
  std::span<const float> ghost{};     ///< x, y, z of a second cloth of the same sheet, m; any other count: none
  const Sheet* ghostSheet = nullptr;  ///< with its springs
  float ghostOpacity = 1;             ///< 0..1
  glm::vec3 ghostShift{0};            ///< m, from the cloth's place to the ghost's, where it is shown beside the cloth
};

/// A panel lives from its first opening to the end of the program, and keeps its state while closed.
class Panel {
 public:
  Panel() = default;
  virtual ~Panel() = default;
  Panel(const Panel&) = delete;
  Panel& operator=(const Panel&) = delete;

  /// Its widgets, once a frame while it is open, between ImGui's Begin and End. Throws nothing: what goes
  /// wrong is said by Notes::warn.
  virtual void draw(const PanelScope& scope) = 0;
  /// A press of the mouse outside of all panels while it is open: true where it was meant for this one.
  virtual bool handle(const WindowEvent& /*event*/, Viewer& /*viewer*/) { return false; }
  /// Once a frame while it is open, after the cloth has moved and before anything is drawn.
  virtual void follow(Viewer& /*viewer*/) {}
  /// Before each picture while it is open.
  virtual void paint(ClothPicture& /*picture*/) {}
  /// m to the left of the cloth, as the camera sees it, at which it shows a second one, while it is open; 0: none.
  [[nodiscard]] virtual float beside() const { return 0; }
  /// It was closed: what runs in the background stops.
  virtual void close() {}
  /// True while it has something new to show by itself; the window then keeps drawing even where the cloth rests.
  [[nodiscard]] virtual bool busy() const { return false; }
};

enum class Edge { Left, Right };  ///< of the window, where a panel is until somebody drags it away

/// A line of the table of panels.
struct PanelKind {
  InputAction action;      ///< of the key that opens and closes it
  std::string_view title;  ///< a word or two
  Edge edge;
  float width;   ///< in text sizes
  float height;  ///< in text sizes; 0: as high as its contents
  std::unique_ptr<Panel> (*make)();
};
/// Every panel, in the order in which they are placed below each other.
std::span<const PanelKind> panelTable();

}  // namespace tyg
