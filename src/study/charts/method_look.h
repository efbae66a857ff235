// How a method looks in every chart, on paper and in the window, whichever other methods are in it.
// Must not know: what draws it.
#pragma once

#include <cstddef>
#include <string_view>

namespace tyg {

enum class Mark { TriangleUp, Circle, Square, TriangleDown, Diamond, Pentagon };

struct MethodLook {
  std::size_t colour = 0;  ///< its place among the charts' colours
  Mark mark = Mark::Circle;
  bool dashed = false;  ///< its curve; where the colours begin anew
};
/// The look of a method by its name; of an unknown one that of none in the table.
MethodLook lookOfMethod(std::string_view name);

}  // namespace tyg
