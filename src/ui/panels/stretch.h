// The stretch panel: how far the springs are from their rest lengths, as colours on the cloth and as numbers.
// Must not know: how strains are computed, OpenGL.
#pragma once

#include <memory>

#include "ui/panels/panel.h"

namespace tyg {

std::unique_ptr<Panel> makeStretchPanel();

}  // namespace tyg
