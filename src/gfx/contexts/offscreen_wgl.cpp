// Off-screen drawing on Windows, by a window that is never shown.
#ifdef _WIN32

#include "gfx/contexts/offscreen_framebuffer.h"
#include "gfx/contexts/offscreen_kinds.h"
#include "gfx/contexts/wgl_context.h"

namespace tyg {
namespace {

class WglOffscreen final : public Offscreen {
 public:
  WglOffscreen(int width, int height) : Offscreen(width, height) {
    loadOpenGl(WglContext::find);
    framebuffer_.make(width, height);
  }
  ~WglOffscreen() override { framebuffer_.drop(); }
  WglOffscreen(const WglOffscreen&) = delete;
  WglOffscreen& operator=(const WglOffscreen&) = delete;

  [[nodiscard]] OffscreenKind kind() const override { return OffscreenKind::Wgl; }
  [[nodiscard]] Find find() const override { return WglContext::find; }

 private:
  WglContext context_ = makeComputingElseDrawing([](int major, int minor) { return WglContext(major, minor); });
  OffscreenFramebuffer framebuffer_;
};

}  // namespace

std::unique_ptr<Offscreen> makeWglOffscreen(int width, int height) {
  return std::make_unique<WglOffscreen>(width, height);
}

/// Windows gives the card's driver anyway.
std::unique_ptr<Offscreen> makeOffscreenOnCard(int width, int height) { return makeOffscreen(width, height); }

}  // namespace tyg

#endif
