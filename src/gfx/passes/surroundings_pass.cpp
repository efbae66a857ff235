// One triangle that covers the picture; its shader meets the ground along each pixel's line of sight.
#include "gfx/passes/surroundings_pass.h"

#include <algorithm>
#include <cmath>

#include "view/round_step.h"
#include "view/sheet_lines.h"

namespace tyg {
namespace {

constexpr float kGroundExtent = 5;  // sheet sizes

glm::vec2 middleOnGround(const Sheet& sheet) {
  const Vec3 first = sheet.startPosition(0), last = sheet.startPosition(sheet.count() - 1);
  return {static_cast<float>(first.x + last.x) / 2, static_cast<float>(first.z + last.z) / 2};
}

/// A plane that one may take for the ground has a grid of its own.
bool hasFloor(std::span<const Body> bodies) {
  constexpr double kNearlyLevel = 0.99;
  return std::ranges::any_of(
      bodies, [](const Body& body) { return body.shape == Shape::Plane && body.normal.y > kNearlyLevel; });
}

}  // namespace

void SurroundingsPass::draw(const Frame& frame) {
  if (!frame.options.ground || frame.options.over) return;
  const Camera& camera = frame.camera;
  const float slope = std::tan(camera.fieldOfView() / 2);
  program_.use();
  program_.set("forward", camera.forward());
  program_.set("rightward", slope * frame.pixels.x / frame.pixels.y * camera.right());
  program_.set("upward", slope * camera.up());
  program_.set("sky", frame.palette.sky);
  program_.set("ground", frame.palette.ground);
  program_.set("grid", hasFloor(frame.options.bodies) ? frame.palette.ground : frame.palette.grid);
  program_.set("eye", camera.eye());
  program_.set("height", groundHeight(sheet_));
  program_.set("cell", static_cast<float>(roundStep(sheet_.size() / 4)));
  program_.set("middle", middleOnGround(sheet_));
  program_.set("extent", kGroundExtent * static_cast<float>(sheet_.size()));
  glBindVertexArray(nothing_.name());
  glDisable(GL_DEPTH_TEST);  // everything else is in front of it
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glEnable(GL_DEPTH_TEST);
}

}  // namespace tyg
