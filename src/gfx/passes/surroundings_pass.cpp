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

SurroundingsPass::Look SurroundingsPass::lookOf(const Frame& frame) const {
  const Camera& camera = frame.camera;
  const float slope = std::tan(camera.fieldOfView() / 2);
  return {.eye = camera.eye(),
          .forward = camera.forward(),
          .rightward = slope * frame.pixels.x / frame.pixels.y * camera.right(),
          .upward = slope * camera.up(),
          .sky = frame.palette.sky,
          .ground = frame.palette.ground,
          .grid = hasFloor(frame.options.bodies) ? frame.palette.ground : frame.palette.grid,
          .height = groundHeight(sheet_),
          .cell = static_cast<float>(roundStep(sheet_.size() / 4)),
          .extent = kGroundExtent * static_cast<float>(sheet_.size()),
          .middle = middleOnGround(sheet_),
          .pixels = frame.pixels};
}

void SurroundingsPass::paint(const Look& look) const {
  program_.use();
  program_.set("forward", look.forward);
  program_.set("rightward", look.rightward);
  program_.set("upward", look.upward);
  program_.set("sky", look.sky);
  program_.set("ground", look.ground);
  program_.set("grid", look.grid);
  program_.set("eye", look.eye);
  program_.set("height", look.height);
  program_.set("cell", look.cell);
  program_.set("middle", look.middle);
  program_.set("extent", look.extent);
  glBindVertexArray(nothing_.name());
  glDisable(GL_DEPTH_TEST);  // everything else is in front of it
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glEnable(GL_DEPTH_TEST);
}

/// Most of the time the camera stands: what is the same in two frames in a row is kept for those that follow.
void SurroundingsPass::draw(const Frame& frame) {
  if (!frame.options.ground || frame.options.over) return;
  const Look look = lookOf(frame);
  if (kept_ == look && KeptPicture::possible()) return picture_.show();
  paint(look);
  const bool stands = painted_ == look && KeptPicture::possible();
  painted_ = look;
  if (stands && picture_.keep(frame.pixels)) kept_ = look;
}

}  // namespace tyg
