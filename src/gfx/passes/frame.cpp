// The depth shading spans the box that the camera watches, so that it follows the cloth and not single particles.
#include "gfx/passes/frame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "view/body_shapes.h"

namespace tyg {
namespace {

constexpr float kShallowest = 0.5F;  // cloth sizes: a range of depths below this is not stretched to full contrast

/// Distances along the line of sight of the nearest and the farthest part of the box around the cloth.
glm::vec2 depthsOf(const Camera& camera) {
  float low = std::numeric_limits<float>::max(), high = -low;
  for (const glm::vec3& corner : camera.watched().corners()) {
    const float depth = glm::dot(corner - camera.eye(), camera.forward());
    low = std::min(low, depth), high = std::max(high, depth);
  }
  const float missing = std::max(kShallowest * camera.watched().size() - (high - low), 0.0F);
  return {low, high + missing};
}

}  // namespace

Frame makeFrame(const DrawnPositions& positions, const Camera& camera, glm::ivec2 pixels, const DrawOptions& options,
                const ShownPush* push) {
  const glm::vec2 size(pixels);
  return {.positions = positions,
          .camera = camera,
          .options = options,
          .push = push,
          .palette = paletteOf(options.background),
          .lights = lightsOf(options.lamps),
          .pixels = size,
          .view = camera.view(),
          .projection = camera.projection(size.x / size.y, nearestWith(camera, options.bodies)),
          .depths = depthsOf(camera),
          .focal = size.y / (2 * std::tan(camera.fieldOfView() / 2))};
}

void useShaded(const GlProgram& program, const Frame& frame, const Shading& shading) {
  program.use();
  program.set("view", frame.view);
  program.set("projection", frame.projection);
  program.set("focal", frame.focal);
  program.set("middle", frame.camera.distance());
  program.set("depths", frame.depths);
  program.set("background", frame.palette.background);
  program.set("colour", shading.colour);
  program.set("fade", shading.fade);
  program.set("spacing", shading.spacing);
}

void setLights(const GlProgram& program, const Lights& lights) {
  std::array<glm::vec4, kMostLamps> from{};
  std::array<glm::vec3, kMostLamps> colours{};
  for (std::size_t k = 0; k < from.size(); ++k) {
    from.at(k) = lights.lights.at(k).from, colours.at(k) = lights.lights.at(k).colour;
  }
  program.set("lamps", lights.count);
  program.set("lampFrom", std::span<const glm::vec4>(from));
  program.set("lampColour", std::span<const glm::vec3>(colours));
}

}  // namespace tyg
