// Colours and marks go through the table of methods with periods of seven and six: no two methods share both.
#include "study/charts/method_style.h"

#include <algorithm>

#include "tyg/methods.h"

namespace tyg {

MethodStyle styleOfMethod(std::string_view name) {
  constexpr std::size_t kColours = 7, kMarks = 6;
  const auto names = methodNames();
  const auto k = static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
  return {.colour = k % kColours, .mark = static_cast<Mark>(k % kMarks), .dashed = k >= kColours};
}

}  // namespace tyg
