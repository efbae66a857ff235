// Every tool, one line each.
#include <array>

#include "viewer/push_tool.h"
#include "viewer/tool.h"

namespace tyg {

std::span<const ToolKind> toolTable() {
  static constexpr std::array kTools{
      ToolKind{"push", makePushTool},
  };
  return kTools;
}

}  // namespace tyg
