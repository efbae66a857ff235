// A scene as the text of a .toml file that reads back as the same scene.
// Must not know: where the text goes, what a simulation does with a scene.
#pragma once

#include <string>
#include <string_view>

#include "tyg/scene.h"

namespace tyg {

/// TOML that parseScene() turns into an equal scene (all but the name, which is the file's): numbers in the shortest
/// form that reads back as the same bits, units as comments, and what has the default of an empty world left out.
/// `comment`, where there is one, comes first, each of its lines after a `# `.
std::string sceneToToml(const Scene& scene, std::string_view comment = {});

}  // namespace tyg
