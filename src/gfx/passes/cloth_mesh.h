// The surface of a sheet on the GPU, for every pass that draws it.
// Must not know: how it is lit, what colour it has.
#pragma once

#include <optional>

#include "gfx/gl_objects.h"
#include "gfx/passes/positions.h"
#include "gfx/passes/programs.h"
#include "view/cloth_surface.h"
#include "view/drawn_positions.h"

namespace tyg {

class ClothMesh {
 public:
  /// `particles` are filled before this is prepared. It keeps references to both.
  ClothMesh(const Positions& particles, Programs& programs) : particles_(particles), programs_(programs) {}

  /// Its sheet has other springs from now on.
  void changeSheet() { surface_.reset(); }
  /// Works out the surface of a sheet with cells whose particles are here. Normals of particles in a buffer are worked
  /// out on the GPU, unless springs have gone. Allocates nothing where it has done so for these springs.
  void prepare(const Sheet& sheet, const DrawnPositions& particles);
  /// With the program in use, whose vertex shader has the inputs of surface.vert.
  void draw(const GlProgram& program) const;

 private:
  void makeObjects();
  void computeNormals(const Sheet& sheet) const;

  const Positions& particles_;
  Programs& programs_;
  int columns_ = 0;
  std::optional<ClothSurface> surface_;
  struct Objects {
    GlVertexArray whole, beside, nothing;
    GlBuffer triangles, normals, pieces;
  };
  std::optional<Objects> objects_;  ///< made when a surface is first shown
};

}  // namespace tyg
