// What it takes to go from one scene to another in a running window.
// Must not know: windows, how a simulation is changed.
#pragma once

#include <cstdint>

#include "tyg/scene.h"

namespace tyg {

/// None: nothing differs. Live: a running simulation can go on with it. Restart: the same particles begin
/// anew. NewSheet: other particles, which also have to be drawn anew.
enum class SceneChange : std::uint8_t { None, Live, Restart, NewSheet };
SceneChange changeBetween(const Scene& from, const Scene& to);

}  // namespace tyg
