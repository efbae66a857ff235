// Every tool, one line each.
#include <array>

#include "viewer/cut_tool.h"
#include "viewer/hand_tool.h"
#include "viewer/pin_tool.h"
#include "viewer/tool.h"

namespace tyg {

std::span<const ToolKind> toolTable() {
  static const std::array kTools{
      ToolKind{"hand", "push, grab",
               "A click pushes, and goes on while you hold the button; a drag grabs the cloth or a body, and the wheel "
               "moves what you hold farther away or nearer.",
               handIcon(), makeHandTool},
      ToolKind{"pin", "pin, free", "A click pins a particle where it is; a click on a pin frees it.", pinIcon(),
               makePinTool},
      ToolKind{"cut", "cut", "Drag a line across the cloth: it is cut along it when you let go.", cutIcon(),
               makeCutTool},
  };
  return kTools;
}

}  // namespace tyg
