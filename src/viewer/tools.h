// The tools of a viewer, and the one that is chosen: what the left button does goes to that one.
// Must not know: any tool in particular, windows.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "viewer/tool.h"

namespace tyg {

class Tools {
 public:
  /// All that is given here must live as long as this does.
  Tools(RunControl& run, const ViewControl& view, Notes& notes);

  /// The left button, at this place of the cursor. Returns false, and does nothing, where that is not for the tool, or
  /// the cloth is frozen, on its way to a past time, or not to be seen.
  bool press(glm::vec2 cursor);
  /// A press that was not for the tool came up again at once and where it was.
  void clickBeside(glm::vec2 cursor);
  void move(glm::vec2 cursor) { chosen().move(scope(), cursor); }
  void release();
  /// The button no longer counts; see Tool::letGo.
  void letGo();
  /// True where a turn of the wheel was for the tool.
  bool scroll(float notches) { return chosen().scroll(scope(), notches); }
  /// The left button is this tool's from now on, and the tool before it lets go. Throws InputError, which names all
  /// tools, where there is none of this name.
  void choose(std::string_view name);
  /// By its slot in the table; does nothing beyond the last one.
  void choose(std::size_t slot);
  /// Once a frame, before its ticks.
  void frame();
  /// Before ticks; see Tool::follow. The least of what the tools allow.
  std::int64_t follow(Simulation& simulation, std::int64_t due);
  [[nodiscard]] bool actsAt(std::int64_t tick) const;
  void restart();
  /// The particles are those of another sheet.
  void forgetParticles() { record_.picked = -1; }
  /// > 0, clamped to 0.01..100.
  void setStrength(double factor);

  [[nodiscard]] const ToolRecord& record() const { return record_; }
  [[nodiscard]] std::size_t chosenSlot() const { return chosen_; }  ///< in the table
  [[nodiscard]] bool pressed() const { return pressed_; }           ///< the button is down for the chosen tool
  [[nodiscard]] double strength() const { return record_.strength; }
  /// Of the first tool in the table that draws something.
  [[nodiscard]] ToolDrawing drawing() const;

 private:
  [[nodiscard]] Tool& chosen() { return *tools_[chosen_]; }
  [[nodiscard]] ToolScope scope() { return {run_, view_, notes_, record_}; }
  [[nodiscard]] bool canAct() const;

  RunControl& run_;
  const ViewControl& view_;
  Notes& notes_;
  ToolRecord record_;
  std::vector<std::unique_ptr<Tool>> tools_;  ///< one for each line of the table
  std::size_t chosen_ = 0;
  bool pressed_ = false;
};

}  // namespace tyg
