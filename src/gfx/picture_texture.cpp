// Draws into a framebuffer with several samples per pixel, then averages them into the texture.
#include "gfx/picture_texture.h"

#include <algorithm>
#include <stdexcept>

#include "gfx/gl_objects.h"

namespace tyg {
namespace {

constexpr int kSamples = 4;

}  // namespace

struct PictureTexture::Impl {
  GlTexture texture;
  GlFramebuffer smooth, resolved;
  GlRenderbuffer colour, depth;

  Impl(int width, int height) {
    const FramebufferGuard guard;
    glBindTexture(GL_TEXTURE_2D, texture.name());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glBindFramebuffer(GL_FRAMEBUFFER, resolved.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.name(), 0);
    mustBeComplete();
    GLint most = 0;
    glGetIntegerv(GL_MAX_SAMPLES, &most);
    glBindFramebuffer(GL_FRAMEBUFFER, smooth.name());
    attach(colour.name(), GL_RGBA8, GL_COLOR_ATTACHMENT0, std::min(kSamples, most), width, height);
    attach(depth.name(), GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL_ATTACHMENT, std::min(kSamples, most), width, height);
    mustBeComplete();
  }

  static void attach(GLuint buffer, GLenum format, GLenum slot, int samples, int width, int height) {
    glBindRenderbuffer(GL_RENDERBUFFER, buffer);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, slot, GL_RENDERBUFFER, buffer);
  }
  static void mustBeComplete() {
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
      throw std::runtime_error("this display cannot draw small pictures");
    }
  }
};

bool PictureTexture::possible() { return glGenFramebuffers != nullptr && glGenTextures != nullptr; }

PictureTexture::PictureTexture(int width, int height)
    : width_(width), height_(height), impl_(std::make_unique<Impl>(width, height)) {}
PictureTexture::~PictureTexture() = default;

unsigned PictureTexture::name() const { return impl_->texture.name(); }

void PictureTexture::draw(const std::function<void()>& drawing) {
  const FramebufferGuard guard;
  glBindFramebuffer(GL_FRAMEBUFFER, impl_->smooth.name());
  drawing();
  glBindFramebuffer(GL_READ_FRAMEBUFFER, impl_->smooth.name());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, impl_->resolved.name());
  glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void PictureTexture::read(const std::function<void()>& reading) const {
  const FramebufferGuard guard;
  glBindFramebuffer(GL_FRAMEBUFFER, impl_->resolved.name());
  reading();
}

}  // namespace tyg
