// The surface of a sheet on the GPU, for every pass that draws it.
// Must not know: how it is lit, what colour it has.
#pragma once

#include <optional>
#include <span>

#include "gfx/gl_objects.h"
#include "view/cloth_surface.h"

namespace tyg {

class ClothMesh {
 public:
  /// `particles`: a buffer of x, y and z of every particle, m, which is filled before this is drawn.
  explicit ClothMesh(GLuint particles) : particles_(particles) {}

  /// Its sheet has other springs from now on.
  void changeSheet() { surface_.reset(); }
  /// Works out the surface of a sheet with cells whose particles are here, m, and uploads it. Allocates nothing where
  /// it has done so for these springs.
  void upload(const Sheet& sheet, std::span<const float> xyz);
  /// With the program in use, whose vertex shader has the inputs of surface.vert.
  void draw(const GlProgram& program) const;

 private:
  void makeObjects();

  GLuint particles_;
  int columns_ = 0;
  std::optional<ClothSurface> surface_;
  struct Objects {
    GlVertexArray whole, beside;
    GlBuffer triangles, normals, pieces;
  };
  std::optional<Objects> objects_;  ///< made when a surface is first shown
};

}  // namespace tyg
