// A mesh for each body is uploaded once.
#include "gfx/passes/body_meshes.h"

#include <algorithm>

#include "view/body_shapes.h"

namespace tyg {
namespace {

constexpr int kPerQuarter = 16;  // a ball as high as the picture then has corners of less than a pixel

}  // namespace

void BodyMeshes::follow(std::span<const Body> bodies) {
  if (std::ranges::equal(bodies, solids_, sameSolid, {}, &Solid::body)) return;
  solids_.clear();
  for (const Body& body : bodies) {
    solids_.push_back({body, std::make_unique<const SolidMesh>(bodySolid(body, kPerQuarter))});
  }
}

}  // namespace tyg
