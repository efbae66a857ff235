// Off-screen drawing by EGL without a surface: needs neither a display nor a window system.
#include <glad/gl.h>

#include <array>
#include <stdexcept>

#include "gfx/contexts/egl_context.h"
#include "gfx/contexts/offscreen_kinds.h"

namespace tyg {
namespace {

class EglOffscreen final : public Offscreen {
 public:
  EglOffscreen(int width, int height) : Offscreen(width, height), context_(EglDisplay::surfaceless(), 3, 3) {
    loadOpenGl(eglGetProcAddress);
    makeFramebuffer();
  }
  ~EglOffscreen() override {
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteRenderbuffers(2, renderbuffers_.data());
  }
  EglOffscreen(const EglOffscreen&) = delete;
  EglOffscreen& operator=(const EglOffscreen&) = delete;

  [[nodiscard]] OffscreenKind kind() const override { return OffscreenKind::Egl; }

 private:
  void makeFramebuffer() {
    glGenFramebuffers(1, &framebuffer_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glGenRenderbuffers(2, renderbuffers_.data());
    attach(renderbuffers_[0], GL_RGBA8, GL_COLOR_ATTACHMENT0);
    attach(renderbuffers_[1], GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL_ATTACHMENT);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
      throw std::runtime_error("it cannot draw into a picture of this size");
    }
  }

  void attach(GLuint renderbuffer, GLenum format, GLenum attachment) const {
    glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
    glRenderbufferStorage(GL_RENDERBUFFER, format, width(), height());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, renderbuffer);
  }

  EglContext context_;
  GLuint framebuffer_ = 0;
  std::array<GLuint, 2> renderbuffers_{};
};

}  // namespace

std::unique_ptr<Offscreen> makeEglOffscreen(int width, int height) {
  return std::make_unique<EglOffscreen>(width, height);
}

}  // namespace tyg
