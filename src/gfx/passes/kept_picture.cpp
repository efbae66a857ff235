// Copies from one framebuffer to the other and back.
#include "gfx/passes/kept_picture.h"

namespace tyg {
namespace {

/// From the framebuffer that is bound for reading into the one that is bound for drawing.
void copyColours(glm::ivec2 pixels) {
  glBlitFramebuffer(0, 0, pixels.x, pixels.y, 0, 0, pixels.x, pixels.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

}  // namespace

bool KeptPicture::possible() {
  GLint samples = 0;
  glGetIntegerv(GL_SAMPLES, &samples);
  return samples < 2;
}

bool KeptPicture::keep(glm::ivec2 pixels) {
  const FramebufferGuard guard;
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_.name());
  if (pixels != pixels_) {
    glBindRenderbuffer(GL_RENDERBUFFER, colours_.name());
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, pixels.x, pixels.y);
    glFramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colours_.name());
    pixels_ = pixels;
  }
  if (glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) return false;
  copyColours(pixels);
  return true;
}

void KeptPicture::show() const {
  const FramebufferGuard guard;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.name());
  copyColours(pixels_);
}

}  // namespace tyg
