// First everything that throws a shadow is drawn, from the lamp on to the floor, into a small mask; then the part of
// the floor that the mask covers is drawn once, darkened by it.
#include "gfx/passes/shadow_pass.h"

#include <stdexcept>

#include "view/body_shapes.h"
#include "view/sheet_lines.h"

namespace tyg {
namespace {

constexpr int kMask = 320;  // pixels a side

}  // namespace

ShadowPass::Objects::Objects() {
  const FramebufferGuard guard;
  glBindTexture(GL_TEXTURE_2D, mask.name());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, kMask, kMask, 0, GL_RED, GL_UNSIGNED_BYTE, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);  // whose colour is 0
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, mask.name(), 0);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw std::runtime_error("this display cannot draw shadows");
  }
}

void ShadowPass::prepare(const Frame& frame) {
  shadow_.reset();
  const DrawOptions& options = frame.options;
  const Light& lamp = frame.lights.lights.front();
  if (!canvas_.showsSurface(options) || lamp.colour == glm::vec3(0)) return;
  const auto ground = options.ground ? std::optional(groundHeight(canvas_.sheet)) : std::nullopt;
  const auto floor = floorOf(options.bodies, ground);
  if (!floor || !(glm::dot(frame.camera.eye() - floor->at, floor->normal) > 0)) return;
  shadow_ = shadowOn(*floor, lamp, frame.camera.watched(), options.bodies);
  if (shadow_) drawMask(frame, *floor);
}

void ShadowPass::drawMask(const Frame& frame, const Floor& floor) {
  if (!objects_) objects_.emplace();
  const FramebufferGuard guard;
  glBindFramebuffer(GL_FRAMEBUFFER, objects_->framebuffer.name());
  glViewport(0, 0, kMask, kMask);
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  const GlProgram& program = canvas_.programs.get("shadow_mask");
  program.use();
  program.set("shadow", shadow_->projection);
  program.set("floorPlane", glm::vec4(floor.normal, -glm::dot(floor.normal, floor.at)));
  program.set("model", glm::mat4(1));
  canvas_.cloth.draw(program);
  for (std::size_t k = 0; k < frame.options.bodies.size(); ++k) {
    if (frame.options.bodies[k].shape == Shape::Plane) continue;
    program.set("model", bodyModel(frame.options.bodies[k]));
    canvas_.bodies.draw(k);
  }
  glViewport(0, 0, static_cast<GLsizei>(frame.pixels.x), static_cast<GLsizei>(frame.pixels.y));
}

void ShadowPass::draw(const Frame& frame) {
  if (!shadow_) return;
  const GlProgram& program = canvas_.programs.get("shadow");
  program.use();
  program.set("view", frame.view);
  program.set("projection", frame.projection);
  program.set("middle", shadow_->middle);
  program.set("across", shadow_->across);
  program.set("along", shadow_->along);
  program.set("strength", frame.palette.shadow);
  program.set("mask", 0);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, objects_->mask.name());
  glBindVertexArray(objects_->nothing.name());
  glDepthMask(GL_FALSE);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glDepthMask(GL_TRUE);
}

}  // namespace tyg
