// Off-screen drawing on Windows, by a window that is never shown.
#ifdef _WIN32

#include "gfx/contexts/offscreen_framebuffer.h"
#include "gfx/contexts/offscreen_kinds.h"
#include "gfx/contexts/wgl_context.h"

namespace tyg {
namespace {

class WglOffscreen final : public Offscreen {
 public:
  WglOffscreen(int width, int height) : Offscreen(width, height), context_(3, 3) {
    loadOpenGl(WglContext::find);
    framebuffer_.make(width, height);
  }
  ~WglOffscreen() override { framebuffer_.drop(); }
  WglOffscreen(const WglOffscreen&) = delete;
  WglOffscreen& operator=(const WglOffscreen&) = delete;

  [[nodiscard]] OffscreenKind kind() const override { return OffscreenKind::Wgl; }

 private:
  WglContext context_;
  OffscreenFramebuffer framebuffer_;
};

}  // namespace

std::unique_ptr<Offscreen> makeWglOffscreen(int width, int height) {
  return std::make_unique<WglOffscreen>(width, height);
}

}  // namespace tyg

#endif
