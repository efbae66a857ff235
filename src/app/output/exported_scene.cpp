// Bodies are the shapes that Tyg itself draws.
#include "app/output/exported_scene.h"

#include <map>
#include <tuple>

#include "core/scene/bodies.h"
#include "gfx/passes/palette.h"
#include "view/body_shapes.h"

namespace tyg {
namespace {

bool isLetterOrDigit(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); }

BodyMesh planeMesh(const Body& plane, const Box& cloth, std::span<const Body> bodies) {
  constexpr float kWider = 2;  // than what Tyg shows, which follows the cloth
  const PlanePatch patch = patchOf(plane, cloth, bodies);
  const glm::vec3 middle = patch.middle - glm::vec3(plane.at.x, plane.at.y, plane.at.z);
  const glm::vec3 across = kWider * patch.radius * patch.across, along = kWider * patch.radius * patch.along;
  const glm::vec3 normal = glm::cross(patch.across, patch.along);
  return {{{middle - across - along, normal},
           {middle + across - along, normal},
           {middle + across + along, normal},
           {middle - across + along, normal}},
          {{0, 1, 2, 3}}};
}

}  // namespace

BodyMesh bodyMesh(const Body& body, const Box& cloth, std::span<const Body> bodies) {
  constexpr int kPerQuarter = 12;
  if (body.shape == Shape::Plane) return planeMesh(body, cloth, bodies);
  BodyMesh mesh;
  std::map<std::tuple<float, float, float, float, float, float>, std::uint32_t> known;
  for (const SolidVertex& vertex : bodySolid(body, kPerQuarter)) {
    const glm::vec3 &p = vertex.position, &n = vertex.normal;
    const auto [entry, isNew] = known.try_emplace({p.x, p.y, p.z, n.x, n.y, n.z}, std::uint32_t(mesh.points.size()));
    if (isNew) mesh.points.push_back(vertex);
    if (mesh.faces.empty() || mesh.faces.back().size() == 3) mesh.faces.emplace_back();
    mesh.faces.back().push_back(entry->second);
  }
  return mesh;
}

std::string exportedName(const Scene& scene, std::size_t body) {
  const Body& named = scene.bodies[body];
  std::string name = named.name.empty() ? std::string(nameOf(named.shape)) : named.name;
  for (char& c : name) {
    if (!isLetterOrDigit(c)) c = '_';
  }
  if (name.front() >= '0' && name.front() <= '9') name.insert(0, "_");
  return name + "_" + std::to_string(body + 1);
}

glm::vec3 clothColour(const Scene& scene) {
  if (!scene.look.colour) return paletteOf(Background::Light).cloth;
  return {scene.look.colour->x, scene.look.colour->y, scene.look.colour->z};
}

glm::vec3 bodyColour() { return paletteOf(Background::Light).body; }

glm::vec2 pictureAt(const Sheet& sheet, const glm::vec2& place) {
  return {place.x / float(sheet.columns - 1), 1 - place.y / float(sheet.rows - 1)};
}

std::vector<SpringEnds> chainLinks(const Sheet& sheet) {
  if (sheet.columns > 1 && sheet.rows > 1) return {};
  return springsOf(sheet, Family::Structural);
}

}  // namespace tyg
