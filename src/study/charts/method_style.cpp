// Colours and marks go through the table of methods with periods of seven and six: no two methods share both.
#include "study/charts/method_style.h"

#include <algorithm>
#include <array>

#include "tyg/methods.h"

namespace tyg {
namespace {

// Of Okabe and Ito's two oranges the yellow one gives way to their yellow, darker on light. On dark ground all are a
// little lighter, or they would sink into it; black becomes white.
constexpr std::array<SeriesColour, kSeriesColours> kColours{{{0x0072b2, 0x328cd8},
                                                             {0xc84600, 0xe66414},
                                                             {0x009e73, 0x00aa7d},
                                                             {0xcc79a7, 0xde90bc},
                                                             {0xbea500, 0xf0e442},
                                                             {0x56b4e9, 0x7ecdfa},
                                                             {0x000000, 0xffffff}}};

}  // namespace

const SeriesColour& colourOfSeries(std::size_t k) { return kColours.at(k % kColours.size()); }

MethodStyle styleOfMethod(std::string_view name) {
  constexpr std::size_t kMarks = 6;
  const auto names = methodNames();
  const auto k = static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
  return {.colour = k % kColours.size(), .mark = static_cast<Mark>(k % kMarks), .dashed = k >= kColours.size()};
}

}  // namespace tyg
