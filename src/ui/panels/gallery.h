// The gallery: every built-in scene as a picture, its title and what it shows; a click opens it.
// Must not know: how pictures are made, how a scene is opened (Viewer::use).
#pragma once

#include <memory>

#include "ui/panels/panel.h"

namespace tyg {

std::unique_ptr<Panel> makeGalleryPanel();

}  // namespace tyg
