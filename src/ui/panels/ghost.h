// The ghost panel: the true motion, or another method's, drawn with the live cloth, and how far apart the two are.
// Must not know: how the ghost follows, OpenGL.
#pragma once

#include <memory>

#include "ui/panels/panel.h"

namespace tyg {

std::unique_ptr<Panel> makeGhostPanel();

}  // namespace tyg
