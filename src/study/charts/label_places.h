// Where the names of curves can be written at their ends without hiding each other or the curves.
// Must not know: what is charted, how it is drawn.
#pragma once

#include <optional>
#include <vector>

namespace tyg {

/// A point of a picture: pixels from its top left corner.
struct Pixel {
  double x = 0, y = 0;
};

/// A rectangle of a picture.
struct PixelBox {
  double left = 0, right = 0, top = 0, bottom = 0;
  [[nodiscard]] bool meets(const PixelBox& other) const;
  /// Does the straight line between two points touch it?
  [[nodiscard]] bool meetsLine(const Pixel& a, const Pixel& b) const;
};

/// A name that is to be written beside a point.
struct WantedLabel {
  Pixel at;
  double width = 0, height = 0;
};

/// Where the thin line from a point to its label ends, on the label; none where the label is near enough without one.
std::optional<Pixel> leaderTo(const PixelBox& box, const Pixel& at);

/// One box for each wanted label, in their order: inside `bounds`, clear of all other boxes where there is room, of
/// `taken` ones, and as far as possible of the lines, of the others' leaders, and near its point.
std::vector<PixelBox> placeLabels(const std::vector<WantedLabel>& wanted, const std::vector<std::vector<Pixel>>& lines,
                                  const std::vector<PixelBox>& taken, const PixelBox& bounds);

}  // namespace tyg
