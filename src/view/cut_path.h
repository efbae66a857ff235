// Which lines on a sheet's grid lie under a straight line on the screen.
// Must not know: OpenGL, windows, what a cut does to a cloth.
#pragma once

#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "tyg/scene.h"
#include "tyg/sheet.h"
#include "view/camera.h"

namespace tyg {

/// The cuts, in grid coordinates, that follow a line from one place in a window of `window` pixels to another: along
/// the cloth that the eye sees first there, one or several for each stretch of cloth under the line. Where the line
/// comes onto the cloth over its edge, or leaves it there, the cut begins or ends a little outside, so that the edge is
/// cut too. Springs without a cell beside them, as chains and frayed edges have, are cut where the line crosses them.
/// `xyz` holds 3 * sheet.count() numbers.
std::vector<CutLine> cutsAlong(const Camera& camera, glm::vec2 from, glm::vec2 to, glm::vec2 window, const Sheet& sheet,
                               std::span<const float> xyz);

}  // namespace tyg
