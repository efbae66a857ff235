// Text in a picture that is in memory, without a window or OpenGL.
// Must not know: what it says.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "gfx/picture.h"

namespace tyg {

/// A line of a legend: a stroke of a colour (red, green, blue, 0..255) and what it means. Without a colour it is
/// text alone.
struct Caption {
  std::string text;
  bool stroke = false;
  std::array<std::uint8_t, 3> colour{};
};

/// Writes a legend into the picture's upper left corner, dark on a light ground, in letters whose size follows the
/// picture's. Lines that would leave the picture are cut off at its edge.
void writeLegend(Picture& picture, const std::vector<Caption>& lines);

}  // namespace tyg
