// The tables of a scene file that say what the cloth looks like: [look] and [[lamp]].
// Must not know: how anything is drawn.
#pragma once

#include <string>

#include "core/scene/scene_table.h"

namespace tyg {

/// Paths of pictures are read as relative to the scene file, and kept as paths that can be opened.
Look readLook(SceneTable table, const std::string& sceneFile);
Lamp readLamp(SceneTable table);

/// As TOML writes them: `lines`, `plain` and so on.
std::string_view nameOf(Show show);
std::string_view nameOf(Weave weave);

}  // namespace tyg
