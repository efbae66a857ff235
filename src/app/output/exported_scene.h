// What an export says of a scene in every format: its cloth as one mesh, its bodies as meshes, names and colours.
// Must not know: formats of files, options of the command line.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "tyg/scene.h"
#include "tyg/sheet.h"
#include "view/box.h"
#include "view/lasting_mesh.h"
#include "view/solid_vertex.h"

namespace tyg {

/// A scene that is exported, before its first frame.
struct ExportedScene {
  const Scene& scene;
  const Sheet& last;  ///< with all that is lost until the last frame
  std::size_t frames;
  double fps;  ///< frames to a second
};

/// One moment of it.
struct ExportedFrame {
  std::size_t number;  ///< from 0
  double time;         ///< s
  const Sheet& sheet;  ///< as it is now
  std::span<const float> xyz;
  const LastingMesh& cloth;  ///< at this moment
  std::span<const Body> bodies;
};

/// An output that gets the scene and then its frames one after the other; all of it is there after keep(), whole.
class ExportSink {
 public:
  virtual ~ExportSink() = default;
  virtual void begin(const ExportedScene& scene, const ExportedFrame& first) = 0;
  virtual void add(const ExportedFrame& frame) = 0;  ///< Throws InputError where it cannot be written
  virtual void keep() = 0;                           ///< likewise
};

/// A mesh of a body in the axes of bodyModel() (view/body_shapes.h); faces go counterclockwise as seen from outside.
struct BodyMesh {
  std::vector<SolidVertex> points;
  std::vector<std::vector<std::uint32_t>> faces;
};
/// Of a plane a large square that is as wide as the cloth and the bodies need, which are here now.
BodyMesh bodyMesh(const Body& body, const Box& cloth, std::span<const Body> bodies);

/// `ball_1`: the body's name or shape in letters, digits and underlines, and its number, so that each has its own.
std::string exportedName(const Scene& scene, std::size_t body);
/// Red, green and blue, 0..1 each, as they look on a screen.
glm::vec3 clothColour(const Scene& scene);
glm::vec3 bodyColour();
/// Across the sheet and up, 0..1 each, where a picture on the cloth has this place.
glm::vec2 pictureAt(const Sheet& sheet, const glm::vec2& place);
/// The springs along a chain, as pairs of particles, that are there now; none of a sheet that has cells.
std::vector<SpringEnds> chainLinks(const Sheet& sheet);

}  // namespace tyg
