// Draws a sheet with OpenGL 3.3 core: springs as anti-aliased lines shaded with distance, pins, particles, a push, the
// ground. Must not know: windows, how the context came about, the simulation (it is given positions).
#pragma once

#include <memory>
#include <optional>
#include <span>

#include <glm/glm.hpp>

#include "gfx/colour_ramp.h"
#include "tyg/sheet.h"
#include "view/camera.h"

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

/// What is drawn and how.
struct DrawOptions {
  bool structural = true, shear = false, bend = false;  ///< families of springs, as lines
  bool particles = false, pins = true;                  ///< as discs
  bool ground = true;
  Background background = Background::Dark;
  float lineWidth = 1.8F;         ///< pixels, > 0, where the mesh is coarse; thinner and fainter where it is dense
  std::optional<glm::vec3> mesh;  ///< colour of the structural lines, red green blue 0..1; none: the background's own
  bool over = false;              ///< keep what is in the framebuffer and draw the cloth into it (and no ground)
  float opacity = 1;              ///< of the spring lines, 0..1
  Colouring colouring{};
};

/// A push as shown: an arrow on a particle along a force (N).
struct ShownPush {
  int particle = 0;
  Vec3 force;
};

/// All of its OpenGL objects belong to the context that is current when it is made; draw and destroy it in that
/// context. Expects the OpenGL functions to be loaded (gladLoadGL). Leaves blending and depth testing on, the others as
/// it sets them; it relies on no state but the bound framebuffer.
class SheetRenderer {
 public:
  /// Throws std::runtime_error with the driver's log where a shader does not compile, and InputError where the driver
  /// cannot hold so large a sheet. `sheet` is copied.
  explicit SheetRenderer(const Sheet& sheet);
  ~SheetRenderer();
  SheetRenderer(const SheetRenderer&) = delete;
  SheetRenderer& operator=(const SheetRenderer&) = delete;

  /// Clears the bound framebuffer (unless options.over) and draws one frame. `xyz` holds 3 * sheet.count() numbers
  /// (anything else throws std::invalid_argument), uploaded once. `pixels` is the framebuffer's size; zero draws
  /// nothing. The depth shading follows camera.watched(). Allocates nothing.
  void draw(std::span<const float> xyz, const Camera& camera, glm::ivec2 pixels, const DrawOptions& options,
            const std::optional<ShownPush>& push = std::nullopt);

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace tyg
