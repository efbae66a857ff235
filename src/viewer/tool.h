// What a tool is: something that the left mouse button does to the cloth. Adding one is a file and a line in
// tool_table.cpp. Must not know: any tool in particular, which key or button uses it, how a drawing is drawn.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "viewer/notes.h"
#include "viewer/run_control.h"
#include "viewer/view_control.h"

namespace tyg {

/// What all tools share, and what stays when another one is chosen.
struct ToolRecord {
  int picked = -1;      ///< the particle that was taken last; -1: none of this sheet yet
  int pushes = 0;       ///< so far
  int uses = 0;         ///< what was done so far: pushes, grabs, pins, cuts
  double strength = 1;  ///< how strongly tools act, as a multiple of the usual
};

/// What a tool works with.
struct ToolScope {
  RunControl& run;
  const ViewControl& view;
  Notes& notes;
  ToolRecord& record;
};

/// A straight line over the picture, in pixels of the framebuffer from its top left.
struct ScreenLine {
  glm::vec2 from{0}, to{0};
};

/// What shows on the cloth that a tool acts. Empty: nothing.
struct ToolDrawing {
  std::optional<ShownPush> arrow;
  std::optional<ScreenLine> cut;  ///< will be cut along
  [[nodiscard]] bool empty() const { return !arrow && !cut; }
};

/// A tool lives as long as the viewer. Only the chosen one is given the cursor and the button. What one of them left
/// acting (a push is not over when the button comes up) goes on when another is chosen, so every tool follows the
/// ticks and may draw. Positions of the cursor are in pixels of the framebuffer from its top left.
class Tool {
 public:
  Tool() = default;
  virtual ~Tool() = default;
  Tool(const Tool&) = delete;
  Tool& operator=(const Tool&) = delete;

  /// The button went down over a cloth that can be acted on: it is neither frozen nor on its way to a past time.
  /// Returns false where that was not for the tool, as beside the cloth: it then hears nothing more of this press.
  virtual bool press(const ToolScope& scope, glm::vec2 cursor) = 0;
  /// A press that was not for it came up again at once and where it was.
  virtual void clickBeside(const ToolScope& /*scope*/, glm::vec2 /*cursor*/) {}
  /// The cursor moved, whether or not the button is down.
  virtual void move(const ToolScope& /*scope*/, glm::vec2 /*cursor*/) {}
  /// The button came up where the cursor was last.
  virtual void release(const ToolScope& scope) = 0;
  /// The button no longer counts, wherever it is: the window lost the focus, or another tool was chosen.
  virtual void letGo(const ToolScope& scope) { release(scope); }
  /// The wheel was turned by so many notches, positive away from the person. True where that was for this tool.
  virtual bool scroll(const ToolScope& /*scope*/, float /*notches*/) { return false; }
  /// Once a frame, before its ticks, whether or not time passes.
  virtual void frame(const ToolScope& /*scope*/) {}
  /// Before ticks, of which `due` are left in this frame: acts on the simulation where the button is still down.
  /// Returns how many ticks may pass at most, 1 at least, before it must act again.
  virtual std::int64_t follow(Simulation& simulation, std::int64_t due) = 0;
  /// Whether it still acts on the cloth at this tick.
  [[nodiscard]] virtual bool actsAt(std::int64_t tick) const = 0;
  /// A new run waits for its start: what acted on the run before is over.
  virtual void restart() = 0;
  [[nodiscard]] virtual ToolDrawing drawing(const RunControl& run) const = 0;
};

/// Lifts the pen in the drawing of an icon.
inline constexpr glm::vec2 kPenUp{-1, -1};

/// A line of the table of tools.
struct ToolKind {
  std::string_view name;            ///< one word
  std::string_view does;            ///< what it does, in a word or two
  std::string_view how;             ///< a sentence: how it is used
  std::span<const glm::vec2> icon;  ///< its lines, from point to point in a square from 0 to 1, y down
  std::unique_ptr<Tool> (*make)();
};
/// Every tool; the first one is chosen at the start.
std::span<const ToolKind> toolTable();

}  // namespace tyg
