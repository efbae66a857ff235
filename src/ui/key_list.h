// The keys as buttons: lines of keys and what they do, each of which can be clicked.
// Must not know: which lines there are, what a key does.
#pragma once

#include <vector>

#include "ui/overlay.h"
#include "viewer/input_table.h"

namespace tyg {

class KeyList {
 public:
  /// Widths of a block of lines, in sizes of its text.
  struct Widths {
    float keys = 0, all = 0;
  };
  /// `writer`: whose size is any.
  [[nodiscard]] static Widths widthsOf(const TextWriter& writer, std::span<const HelpLine* const> lines);

  void clear() { areas_.clear(); }
  /// A line at this place, with what its keys do at a distance of `widths.keys` from it. `on`: what it switches is on.
  void draw(const TextWriter& writer, ImVec2 at, const Widths& widths, const HelpLine& line, bool on);
  /// Whose key is at this place; null where there is none that can be pressed.
  [[nodiscard]] const Input* at(ImVec2 place) const;

 private:
  struct Area {
    ImVec2 from, to;
    const Input* input;
  };
  std::vector<Area> areas_;
};

}  // namespace tyg
