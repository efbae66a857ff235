// A copy between framebuffers of one kind is a copy of memory where there is no graphics card.
#include "gfx/passes/kept_picture.h"

namespace tyg {

bool KeptPicture::possible() {
  GLint samples = 0;
  glGetIntegerv(GL_SAMPLES, &samples);
  return samples < 2;
}

bool KeptPicture::begin(glm::ivec2 pixels) {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  if (pixels != pixels_) {
    glBindRenderbuffer(GL_RENDERBUFFER, colours_.name());
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, pixels.x, pixels.y);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colours_.name());
    pixels_ = pixels;
  }
  return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

void KeptPicture::copy() const {
  const FramebufferGuard guard;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.name());  // and what is bound stays what is drawn into
  glBlitFramebuffer(0, 0, pixels_.x, pixels_.y, 0, 0, pixels_.x, pixels_.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

}  // namespace tyg
