// Two motions of one cloth in one picture, at one time.
// Must not know: why they are compared, options of the command line.
#pragma once

#include <string>

#include <glm/glm.hpp>

#include "gfx/picture.h"
#include "tyg/scene.h"

namespace tyg {

/// A scene and what the legend says of it.
struct Overlaid {
  const Scene& scene;
  std::string words;
};

/// Simulates both to `time` (s) and draws the first in wide pale lines, the second in narrow dark ones over it, from a
/// side where they differ and near enough to see that, on a light ground, with a legend and `title` above it. Throws
/// InputError where nothing can draw, and where a run fails.
Picture overlaid(const Overlaid& first, const Overlaid& second, double time, const std::string& title,
                 glm::ivec2 size = {1280, 720});

}  // namespace tyg
