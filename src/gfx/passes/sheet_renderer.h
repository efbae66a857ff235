// Draws a sheet with OpenGL 3.3 core, pass by pass: surroundings, bodies, a surface, springs, particles and pins, a
// push, a wind. Must not know: windows, how the context came about, the simulation (it is given positions).
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "gfx/passes/programs.h"
#include "tyg/sheet.h"
#include "view/camera.h"
#include "view/draw_options.h"
#include "view/drawn_positions.h"

namespace tyg {

struct Canvas;
class Pass;

/// All of its OpenGL objects belong to the context that is current when it is made; draw and destroy it in that
/// context. Expects the OpenGL functions to be loaded (gladLoadGL). Leaves blending and depth testing on, the others as
/// it sets them; it relies on no state but the bound framebuffer.
class SheetRenderer {
 public:
  /// Throws std::runtime_error with the driver's log where a shader does not compile, and InputError where the driver
  /// cannot hold so large a sheet. `sheet` is copied.
  explicit SheetRenderer(const Sheet& sheet) : SheetRenderer(sheet, std::make_shared<Programs>()) {}
  /// With the programs of other renderers in the same context.
  SheetRenderer(const Sheet& sheet, std::shared_ptr<Programs> programs);
  ~SheetRenderer();
  SheetRenderer(const SheetRenderer&) = delete;
  SheetRenderer& operator=(const SheetRenderer&) = delete;

  /// From now on the sheet has these pins and springs; draws nothing. Does nothing where it has them already. Throws
  /// std::invalid_argument for a sheet of another size.
  void follow(const Sheet& sheet);
  /// Clears the bound framebuffer (unless options.over) and draws one frame. The positions are those of the sheet's
  /// particles (another number of them throws std::invalid_argument), uploaded once, or copied once from their buffer;
  /// of such ones no more are read than an arrow or a surface needs. `pixels` is the framebuffer's size; zero draws
  /// nothing. The depth shading follows camera.watched(). A push on a particle that the sheet does not have is not
  /// drawn. Allocates nothing, but for a surface, the lines of a family of springs, and a body, that is drawn for the
  /// first time, or for the first time with other springs.
  void draw(const DrawnPositions& positions, const Camera& camera, glm::ivec2 pixels, const DrawOptions& options,
            const std::optional<ShownPush>& push = std::nullopt);
  void draw(std::span<const float> xyz, const Camera& camera, glm::ivec2 pixels, const DrawOptions& options,
            const std::optional<ShownPush>& push = std::nullopt) {
    draw(DrawnPositions(xyz), camera, pixels, options, push);
  }

 private:
  std::shared_ptr<Programs> programs_;
  std::unique_ptr<Canvas> canvas_;
  std::vector<std::unique_ptr<Pass>> passes_;
};

}  // namespace tyg
