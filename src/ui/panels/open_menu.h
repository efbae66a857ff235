// The menu of the control panel that opens a file: a path that is typed or pasted, or one of the current folder.
// Must not know: what a file holds, other widgets of the panel.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "ui/panels/panel.h"

namespace tyg {

class OpenMenu {
 public:
  /// The button, and the menu below it while that is open. True where a file was opened.
  bool draw(const PanelScope& scope);

 private:
  enum class Done { Nothing, Closed, Opened };
  Done drawMenu(const PanelScope& scope);

  std::array<char, 4096> path_{};   ///< as typed
  bool focus_ = false;              ///< the field for it gets what is typed
  std::vector<std::string> files_;  ///< of the current folder, as they were when the menu was opened
};

}  // namespace tyg
