// What of a cloth is drawn and how: lines or a surface, its look, discs, ground, colours, a push, a wind, bodies.
// Must not know: OpenGL, windows, the simulation.
#pragma once

#include <optional>
#include <span>

#include <glm/glm.hpp>

#include "tyg/scene.h"
#include "view/colour_ramp.h"

namespace tyg {

/// Colours of the spring lines by a number instead of by family.
struct Colouring {
  enum class By { Family, Particle, Strain };
  By by = By::Family;
  Ramp ramp = Ramp::Growing;
  float low = 0, high = 1;  ///< the numbers at both ends of the ramp; beyond them its ends go on
  std::span<const float>
      values{};  ///< Particle: one number for each, valid while it is drawn; any other count: by family
};

/// A wind as shown: an arrow along it.
struct ShownWind {
  Vec3 velocity;            ///< m/s
  glm::vec2 at{0.1F, .2F};  ///< the arrow's middle in the picture: shares of its width and height, from the upper left
  float longest = 0.19F;    ///< heights of the picture, the arrow in the fastest wind
};

/// What is drawn and how.
struct DrawOptions {
  Show show = Show::Lines;        ///< of the cloth; a chain has no surface and is always drawn as lines
  const Look* look = nullptr;     ///< of the surface, valid while it is drawn; null: the usual one
  std::span<const Lamp> lamps{};  ///< on surfaces and bodies, valid while they are drawn; none: the usual one
  bool structural = true, shear = false, bend = false;  ///< families of springs, as lines
  bool particles = false, pins = true;                  ///< as discs
  bool ground = true;
  Background background = Background::Dark;
  float lineWidth = 1.8F;           ///< pixels, > 0, where the mesh is coarse; thinner and fainter where it is dense
  float scale = 1;                  ///< pixels to a pixel of all widths of lines and discs: more on dense screens
  std::optional<glm::vec3> mesh{};  ///< colour of the structural lines, red green blue 0..1; none: the background's own
  bool over = false;   ///< keep what is in the framebuffer and draw the cloth into it (and no ground, wind or bodies)
  float opacity = 1;   ///< of the spring lines, 0..1
  float fade = 0.62F;  ///< how far the farthest part of the cloth goes towards the background's colour, 0..1
  Colouring colouring{};
  std::optional<ShownWind> wind{};
  std::span<const Body> bodies{};  ///< where they are now (see placeBodies), valid while they are drawn
};

/// Makes the options follow the look of a scene, which must live while they are used.
inline void followLook(const Scene& scene, DrawOptions& options) {
  options.look = &scene.look;
  options.lamps = scene.lamps;
}

/// A push as shown: an arrow on a particle along a force (N).
struct ShownPush {
  int particle = 0;
  Vec3 force;
};

}  // namespace tyg
