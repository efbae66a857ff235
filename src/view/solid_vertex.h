// A corner of a triangle of something solid.
// Must not know: OpenGL, what the triangles are of.
#pragma once

#include <glm/glm.hpp>

namespace tyg {

struct SolidVertex {
  glm::vec3 position;
  glm::vec3 normal;  ///< of length 1, out of the solid
};

}  // namespace tyg
