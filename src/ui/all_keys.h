// The long list: every key and what it does, in as many columns as make its text largest, over everything else.
// Must not know: what a key does.
#pragma once

#include <functional>

#include "ui/key_list.h"

namespace tyg {

class AllKeys {
 public:
  /// Between ImGui::NewFrame and ImGui::Render. `writer`: of text of the window's size; `isOn`: what a line switches.
  void draw(TextWriter writer, std::span<const HelpLine> lines, const std::function<bool(const HelpLine&)>& isOn);
  /// Not drawn in this frame.
  void hide() { shown_ = false, list_.clear(); }
  [[nodiscard]] const Input* at(ImVec2 place) const { return list_.at(place); }

 private:
  KeyList list_;
  bool shown_ = false;  ///< in the frame before
};

}  // namespace tyg
