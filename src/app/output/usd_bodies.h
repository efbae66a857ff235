// The bodies of a scene as prims of a USD file: spheres and capsules where the format has the shape itself, else
// meshes. Must not know: the cloth, files.
#pragma once

#include <string>
#include <vector>

#include "app/output/exported_scene.h"

namespace tyg {

class UsdBodies {
 public:
  UsdBodies(const Scene& scene, const ExportedFrame& first);

  void add(const ExportedFrame& frame);
  /// The prims; a body that moved between the frames has time samples.
  [[nodiscard]] std::string text() const;

 private:
  struct Prim {
    std::string begin;           ///< all but where it is
    std::vector<Vec3> places{};  ///< of its middle in every frame, m
  };
  std::vector<Prim> prims_;
};

}  // namespace tyg
