// The picture that a context without a surface of its own draws into.
// Must not know: how the context was made.
#pragma once

#include <glad/gl.h>

#include <array>
#include <stdexcept>

namespace tyg {

/// The context must be current whenever it is used.
class OffscreenFramebuffer {
 public:
  /// Makes it and binds it; sizes in pixels. Throws std::runtime_error.
  void make(int width, int height) {
    glGenFramebuffers(1, &framebuffer_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glGenRenderbuffers(2, renderbuffers_.data());
    const auto attach = [&](GLuint renderbuffer, GLenum format, GLenum attachment) {
      glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
      glRenderbufferStorage(GL_RENDERBUFFER, format, width, height);
      glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, renderbuffer);
    };
    attach(renderbuffers_[0], GL_RGBA8, GL_COLOR_ATTACHMENT0);
    attach(renderbuffers_[1], GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL_ATTACHMENT);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
      throw std::runtime_error("it cannot draw into a picture of this size");
    }
  }
  void drop() {
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteRenderbuffers(2, renderbuffers_.data());
  }

 private:
  GLuint framebuffer_ = 0;
  std::array<GLuint, 2> renderbuffers_{};
};

}  // namespace tyg
