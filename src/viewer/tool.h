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
  int uses = 0;         ///< presses so far that did something
  double strength = 1;  ///< how strongly tools act, as a multiple of the usual
};

/// What a tool works with.
struct ToolScope {
  RunControl& run;
  const ViewControl& view;
  Notes& notes;
  ToolRecord& record;
};

/// What shows on the cloth that a tool acts. Empty: nothing.
struct ToolDrawing {
  std::optional<ShownPush> arrow;
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
  virtual void press(const ToolScope& scope, glm::vec2 cursor) = 0;
  /// The cursor moved, whether or not the button is down.
  virtual void move(const ToolScope& /*scope*/, glm::vec2 /*cursor*/) {}
  /// The button came up, or the window lost the focus, or another tool was chosen.
  virtual void release() = 0;
  /// Before ticks: acts on the simulation where the button is still down. Returns how many ticks may pass at most, 1 at
  /// least, before it must act again.
  virtual std::int64_t follow(Simulation& simulation) = 0;
  /// Whether it still acts on the cloth at this tick.
  [[nodiscard]] virtual bool actsAt(std::int64_t tick) const = 0;
  /// A new run waits for its start: what acted on the run before is over.
  virtual void restart() = 0;
  [[nodiscard]] virtual ToolDrawing drawing(const RunControl& run) const = 0;
};

/// A line of the table of tools.
struct ToolKind {
  std::string_view name;  ///< one word
  std::unique_ptr<Tool> (*make)();
};
/// Every tool; the first one is chosen at the start.
std::span<const ToolKind> toolTable();

}  // namespace tyg
