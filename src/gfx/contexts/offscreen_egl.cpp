// Off-screen drawing by EGL without a surface: needs neither a display nor a window system.
#ifndef _WIN32

#include <stdexcept>

#include "gfx/contexts/egl_context.h"
#include "gfx/contexts/offscreen_framebuffer.h"
#include "gfx/contexts/offscreen_kinds.h"

namespace tyg {
namespace {

class EglOffscreen final : public Offscreen {
 public:
  EglOffscreen(const std::shared_ptr<EglDisplay>& display, int width, int height)
      : Offscreen(width, height),
        context_(makeComputingElseDrawing([&](int major, int minor) { return EglContext(display, major, minor); })) {
    loadOpenGl(eglGetProcAddress);
    framebuffer_.make(width, height);
  }
  ~EglOffscreen() override { framebuffer_.drop(); }
  EglOffscreen(const EglOffscreen&) = delete;
  EglOffscreen& operator=(const EglOffscreen&) = delete;

  [[nodiscard]] OffscreenKind kind() const override { return OffscreenKind::Egl; }
  [[nodiscard]] Find find() const override { return eglGetProcAddress; }

 private:
  EglContext context_;
  OffscreenFramebuffer framebuffer_;
};

}  // namespace

std::unique_ptr<Offscreen> makeEglOffscreen(int width, int height) {
  return std::make_unique<EglOffscreen>(EglDisplay::surfaceless(), width, height);
}

std::unique_ptr<Offscreen> makeOffscreenOnCard(int width, int height) {
  for (const std::shared_ptr<EglDisplay>& card : EglDisplay::ofCards()) {
    try {
      return std::make_unique<EglOffscreen>(card, width, height);
    } catch (const std::runtime_error&) {
      continue;  // a driver that only computes, say
    }
  }
  return makeOffscreen(width, height);
}

}  // namespace tyg

#endif
