// A pass draws one kind of thing. A new kind is one class in a file of its own and one line in sheet_renderer.cpp.
// Must not know: the other passes, windows, the simulation.
#pragma once

#include <utility>

#include "gfx/passes/body_meshes.h"
#include "gfx/passes/cloth_mesh.h"
#include "gfx/passes/disc_drawing.h"
#include "gfx/passes/frame.h"
#include "gfx/passes/line_drawing.h"
#include "gfx/passes/positions.h"
#include "gfx/passes/programs.h"
#include "tyg/sheet.h"

namespace tyg {

/// What all passes of a renderer draw from and with. Outlives them.
struct Canvas {
  /// A sheet of up to Positions::mostPoints() particles. The programs outlive it.
  Canvas(Sheet of, Programs& with) : sheet(std::move(of)), programs(with) {}

  Sheet sheet;
  Programs& programs;
  Positions positions{sheet.count()};    ///< of the particles, uploaded once a frame before the first pass
  ClothMesh cloth{positions, programs};  ///< prepared once a frame before the first pass, where a surface is shown
  BodyMeshes bodies;                     ///< of the options, where these are not drawn over another picture
  LineDrawing lines{programs};
  DiscDrawing discs{programs};

  [[nodiscard]] bool showsSurface(const DrawOptions& options) const {
    return options.show != Show::Lines && !options.over && ClothSurface::possible(sheet);
  }
};

/// Its constructor takes the canvas (kept by reference) and makes what stays the same from frame to frame.
class Pass {
 public:
  Pass() = default;
  virtual ~Pass() = default;
  Pass(const Pass&) = delete;
  Pass& operator=(const Pass&) = delete;

  /// Before anything is drawn into the picture: for what it draws elsewhere, in the same state as draw() finds.
  virtual void prepare(const Frame& /*frame*/) {}
  /// Draws its kind of thing where the options want it. It finds blending, depth test and depth writing switched on,
  /// and leaves them so. Allocates nothing, but for what it makes when a thing is shown for the first time.
  virtual void draw(const Frame& frame) = 0;
  /// The canvas has the same sheet with other pins or springs.
  virtual void changeSheet() {}
};

}  // namespace tyg
