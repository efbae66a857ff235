// The scene texts that the build embeds, by file name.
#pragma once

#include "tyg/scene.h"

namespace tyg {
std::span<const BuiltinScene> embeddedScenes();
}  // namespace tyg
