// One frame as every pass sees it: positions, camera, what is to be shown, and what all passes would compute from them.
// Must not know: which passes there are, who owns the OpenGL objects.
#pragma once

#include <algorithm>

#include <glm/glm.hpp>

#include "gfx/gl_objects.h"
#include "gfx/passes/palette.h"
#include "view/camera.h"
#include "view/draw_options.h"
#include "view/drawn_positions.h"
#include "view/lamp_light.h"

namespace tyg {

/// Valid while the frame is drawn: it refers to what the renderer was given.
struct Frame {
  const DrawnPositions& positions;  ///< of every particle of the sheet
  const Camera& camera;
  const DrawOptions& options;
  const ShownPush* push;  ///< null: no push; else on a particle of the sheet
  const Palette& palette;
  Lights lights;
  glm::vec2 pixels;  ///< size of the picture, above 0
  glm::mat4 view, projection;
  glm::vec2 depths;  ///< of the nearest and the farthest part of the cloth along the line of sight, m
  float focal;       ///< pixels per metre at a distance of one metre
};

/// Computes the matrices and the depths. `pixels` above 0.
Frame makeFrame(const DrawnPositions& positions, const Camera& camera, glm::ivec2 pixels, const DrawOptions& options,
                const ShownPush* push);

/// How the colour and the size of a line or a disc follow its distance from the eye.
struct Shading {
  glm::vec3 colour;
  float fade = 0;     ///< how far the farthest part of the cloth goes towards the background's colour, 0..1
  float spacing = 0;  ///< m between neighbours of one kind, which makes dense ones smaller; 0: always full size
};
/// The fade of what belongs to the mesh: less before bodies, from which all of it has to be told.
inline float meshFade(const DrawOptions& options) {
  return options.bodies.empty() ? options.fade : std::min(options.fade, 0.3F);
}

/// Uses the program and sets the uniforms that lines and discs have in common.
void useShaded(const GlProgram& program, const Frame& frame, const Shading& shading);

/// For a program in use whose shader includes light.glsl.
void setLights(const GlProgram& program, const Lights& lights);

}  // namespace tyg
