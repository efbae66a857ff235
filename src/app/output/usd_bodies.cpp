// A box has rounded edges, which the format's Cube has not: the cloth would sink into those. So it is a mesh.
#include "app/output/usd_bodies.h"

#include <algorithm>

#include <fmt/core.h>

#include "app/output/usd_text.h"
#include "view/body_shapes.h"

namespace tyg {
namespace {

std::string extentOf(const glm::vec3& low, const glm::vec3& high) {
  return "        float3[] extent = " + usdTuples(std::vector{low, high}) + "\n";
}

std::string sphere(const Body& body) {
  const glm::vec3 reach(static_cast<float>(body.radius));
  return fmt::format("        double radius = {}\n", body.radius) + extentOf(-reach, reach);
}

/// Along its own y; a matrix turns it, whose rows are where the axes go.
std::string capsule(const Body& body) {
  const glm::mat4 model = bodyModel(body);
  const glm::dvec3 axis(body.axis.x, body.axis.y, body.axis.z);
  const auto radius = static_cast<float>(body.radius);
  const glm::vec3 reach(radius, float(glm::length(axis)) / 2 + radius, radius);
  std::string rows;
  for (int k = 0; k < 3; ++k) rows += fmt::format("({}, {}, {}, 0), ", model[k].x, model[k].y, model[k].z);
  return fmt::format("        uniform token axis = \"Y\"\n        double height = {}\n        double radius = {}\n",
                     glm::length(axis), body.radius) +
         extentOf(-reach, reach) + "        matrix4d xformOp:transform = (" + rows + "(0, 0, 0, 1))\n";
}

std::string mesh(const BodyMesh& mesh) {
  std::vector<glm::vec3> points, normals;
  for (const SolidVertex& point : mesh.points) points.push_back(point.position), normals.push_back(point.normal);
  glm::vec3 low = points.front(), high = low;
  for (const glm::vec3& point : points) low = glm::min(low, point), high = glm::max(high, point);
  return "        uniform token subdivisionScheme = \"none\"\n" + usdFaces(mesh.faces) +
         "        point3f[] points = " + usdTuples(points) + "\n        normal3f[] normals = " + usdNormals(normals) +
         "\n" + extentOf(low, high);
}

const char* primType(Shape shape) {
  return shape == Shape::Ball ? "Sphere" : shape == Shape::Capsule ? "Capsule" : "Mesh";
}

Vec3 middleOf(const Body& body) {
  if (body.shape != Shape::Capsule) return body.at;
  return {body.at.x + body.axis.x / 2, body.at.y + body.axis.y / 2, body.at.z + body.axis.z / 2};
}

std::string tuple(const Vec3& v) { return fmt::format("({}, {}, {})", v.x, v.y, v.z); }

}  // namespace

UsdBodies::UsdBodies(const Scene& scene, const ExportedFrame& first) {
  for (std::size_t k = 0; k < first.bodies.size(); ++k) {
    const Body& body = first.bodies[k];
    std::string text = fmt::format("    def {} \"{}\"\n    {{\n", primType(body.shape), exportedName(scene, k));
    text += usdColour(bodyColour());
    if (body.shape == Shape::Ball) {
      text += sphere(body);
    } else if (body.shape == Shape::Capsule) {
      text += capsule(body);
    } else {
      text += mesh(bodyMesh(body, boxAround(first.xyz), first.bodies));
    }
    const bool turns = body.shape == Shape::Capsule;
    text += fmt::format("        uniform token[] xformOpOrder = [\"xformOp:translate\"{}]\n",
                        turns ? ", \"xformOp:transform\"" : "");
    prims_.push_back({text});
  }
}

void UsdBodies::add(const ExportedFrame& frame) {
  for (std::size_t k = 0; k < prims_.size(); ++k) prims_[k].places.push_back(middleOf(frame.bodies[k]));
}

std::string UsdBodies::text() const {
  std::string text;
  for (const Prim& prim : prims_) {
    text += "\n" + prim.begin;
    const bool isStill = std::ranges::count(prim.places, prim.places.front()) == std::ssize(prim.places);
    if (isStill) {
      text += "        double3 xformOp:translate = " + tuple(prim.places.front()) + "\n    }\n";
      continue;
    }
    text += "        double3 xformOp:translate.timeSamples = {\n";
    for (std::size_t frame = 0; frame < prim.places.size(); ++frame) {
      text += fmt::format("            {}: {},\n", frame, tuple(prim.places[frame]));
    }
    text += "        }\n    }\n";
  }
  return text;
}

}  // namespace tyg
