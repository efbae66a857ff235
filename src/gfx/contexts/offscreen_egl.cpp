// Off-screen drawing by EGL without a surface: needs neither a display nor a window system.
#ifndef _WIN32

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/core.h>
#include <glad/gl.h>

#include <array>
#include <stdexcept>

#include "gfx/contexts/offscreen_framebuffer.h"
#include "gfx/contexts/offscreen_kinds.h"

namespace tyg {
namespace {

void require(bool worked, const char* step) {
  if (!worked) {
    throw std::runtime_error(fmt::format("{} failed (EGL error {})", step, eglGetError()));
  }
}

EGLDisplay surfacelessDisplay() {
  const auto find = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  require(find != nullptr, "finding eglGetPlatformDisplayEXT");
  return find(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
}

class EglOffscreen final : public Offscreen {
 public:
  EglOffscreen(int width, int height) : Offscreen(width, height), display_(surfacelessDisplay()) {
    require(display_ != EGL_NO_DISPLAY, "opening a surfaceless display");
    require(eglInitialize(display_, nullptr, nullptr) == EGL_TRUE, "initialising EGL");
    try {
      makeContext();
      framebuffer_.make(width, height);
    } catch (...) {
      release();
      throw;
    }
  }
  ~EglOffscreen() override {
    framebuffer_.drop();
    release();
  }
  EglOffscreen(const EglOffscreen&) = delete;
  EglOffscreen& operator=(const EglOffscreen&) = delete;

  [[nodiscard]] OffscreenKind kind() const override { return OffscreenKind::Egl; }

 private:
  void makeContext() {
    const std::array<EGLint, 7> wanted{
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    require(eglBindAPI(EGL_OPENGL_API) == EGL_TRUE, "choosing OpenGL");
    context_ = eglCreateContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted.data());
    require(context_ != EGL_NO_CONTEXT, "making an OpenGL 3.3 core context");
    require(eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE, "making it current");
    loadOpenGl(eglGetProcAddress);
  }

  void release() {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context_ != EGL_NO_CONTEXT) {
      eglDestroyContext(display_, context_);
    }
    eglTerminate(display_);
  }

  EGLDisplay display_;
  EGLContext context_ = EGL_NO_CONTEXT;
  OffscreenFramebuffer framebuffer_;
};

}  // namespace

std::unique_ptr<Offscreen> makeEglOffscreen(int width, int height) {
  return std::make_unique<EglOffscreen>(width, height);
}

}  // namespace tyg

#endif
