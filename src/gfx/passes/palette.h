// The colours of a picture on dark and on light ground.
// Must not know: which pass draws what, OpenGL.
#pragma once

#include <glm/glm.hpp>

#include "view/colour_ramp.h"

namespace tyg {

/// Red, green, blue, 0..1 each. On dark ground those of Okabe and Ito (2008), which colour-blind people tell apart as
/// well; on light ground darker ones.
struct Palette {
  glm::vec3 background, sky, ground, grid;
  glm::vec3 structural, shear, bend, particle, pin, push, wind;
  glm::vec3 cloth;             ///< of a surface that has no colour of its own
  glm::vec3 onCloth;           ///< of structural lines on it
  glm::vec3 body;              ///< where the light falls straight on it
  glm::vec3 floor, floorGrid;  ///< of planes
  float shadow;                ///< share of the light of a floor that a shadow takes, 0..1
};
const Palette& paletteOf(Background background);

}  // namespace tyg
