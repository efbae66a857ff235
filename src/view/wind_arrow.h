// The arrow that shows a wind: a solid shaft with a cone as head, in a corner of what is free of the picture.
// Must not know: OpenGL, what the wind does.
#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "view/draw_options.h"
#include "view/solid_vertex.h"

namespace tyg {

/// Triangles of an arrow of length 1 along x whose middle is the origin, three vertices each.
std::vector<SolidVertex> arrowSolid();

/// From the axes of arrowSolid() to the world's, in heights of the picture: it points along the wind, and its length
/// grows with the speed, wherever the cloth and the camera are.
glm::mat4 windArrowModel(const ShownWind& wind);
/// From the axes of the eye, in heights of the picture, to OpenGL's clip space. In parallel: seen in perspective, an
/// arrow beside the middle of the picture would seem to point another way than at the cloth. `aspect`: width / height.
glm::mat4 windArrowProjection(const ShownWind& wind, float aspect);

/// ShownWind::at of a picture without text.
glm::vec2 windArrowPlace();

}  // namespace tyg
