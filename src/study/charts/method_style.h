// The colour and the mark of a method, the same in every chart, on paper and in the window.
// Must not know: what draws it.
#pragma once

#include <cstddef>
#include <string_view>

namespace tyg {

enum class Mark { TriangleUp, Circle, Square, TriangleDown, Diamond, Pentagon };

struct MethodStyle {
  std::size_t colour = 0;  ///< its index among the charts' colours
  Mark mark = Mark::Circle;
  bool dashed = false;  ///< is its curve dashed? Where the colours begin again
};
/// By the method's name; an unknown name gets a style that no method in the table has.
MethodStyle styleOfMethod(std::string_view name);

}  // namespace tyg
