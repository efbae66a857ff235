// The colours of series, and the colour and the mark of a method: one table for charts on paper and in the window.
// Must not know: what draws with them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace tyg {

/// The same colour on two grounds, 0xRRGGBB.
struct SeriesColour {
  std::uint32_t onLight, onDark;
};
inline constexpr std::size_t kSeriesColours = 7;
/// Of the k-th of several things; starts again after kSeriesColours. After Okabe and Ito (2008), so that colour-blind
/// people can tell them apart.
const SeriesColour& colourOfSeries(std::size_t k);

enum class Mark { TriangleUp, Circle, Square, TriangleDown, Diamond, Pentagon };

struct MethodStyle {
  std::size_t colour = 0;  ///< as colourOfSeries() counts
  Mark mark = Mark::Circle;
  bool dashed = false;  ///< is its curve dashed? Where the colours begin again
};
/// By the method's name, the same wherever it is shown. No two methods share both colour and mark; an unknown name gets
/// a style that no method in the table has.
MethodStyle styleOfMethod(std::string_view name);

}  // namespace tyg
