// Off-screen drawing by EGL without a surface: needs neither a display nor a window system.
#ifndef _WIN32

#include "gfx/contexts/egl_context.h"
#include "gfx/contexts/offscreen_framebuffer.h"
#include "gfx/contexts/offscreen_kinds.h"

namespace tyg {
namespace {

class EglOffscreen final : public Offscreen {
 public:
  EglOffscreen(int width, int height) : Offscreen(width, height), context_(EglDisplay::surfaceless(), 3, 3) {
    loadOpenGl(eglGetProcAddress);
    framebuffer_.make(width, height);
  }
  ~EglOffscreen() override { framebuffer_.drop(); }
  EglOffscreen(const EglOffscreen&) = delete;
  EglOffscreen& operator=(const EglOffscreen&) = delete;

  [[nodiscard]] OffscreenKind kind() const override { return OffscreenKind::Egl; }

 private:
  EglContext context_;
  OffscreenFramebuffer framebuffer_;
};

}  // namespace

std::unique_ptr<Offscreen> makeEglOffscreen(int width, int height) {
  return std::make_unique<EglOffscreen>(width, height);
}

}  // namespace tyg

#endif
