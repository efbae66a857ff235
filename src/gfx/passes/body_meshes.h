// The meshes of bodies on the GPU, for every pass that draws them.
// Must not know: how they are shaded, where they are.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "gfx/passes/solid_mesh.h"
#include "tyg/scene.h"

namespace tyg {

class BodyMeshes {
 public:
  /// The bodies are these from now on; makes meshes anew where one has another shape than before.
  void follow(std::span<const Body> bodies);
  /// In the axes of bodySolid(), with the program in use; nothing of a plane.
  void draw(std::size_t body) const { solids_[body].mesh->draw(); }

 private:
  struct Solid {
    Body body;
    std::unique_ptr<const SolidMesh> mesh;
  };
  std::vector<Solid> solids_;
};

}  // namespace tyg
