// Off-screen drawing into plain memory by OSMesa, where it was found. <GL/osmesa.h> brings its own OpenGL header, which
// newer Mesa does not let stand beside the loader's, so this file never includes the loader.
#ifdef TYG_HAVE_OSMESA

#include <GL/osmesa.h>

#include <stdexcept>
#include <vector>

#include "gfx/offscreen_kinds.h"

namespace tyg {
namespace {

class OsMesaOffscreen final : public Offscreen {
 public:
  OsMesaOffscreen(int width, int height)
      : Offscreen(width, height), pixels_(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
    const int wanted[] = {OSMESA_FORMAT,
                          OSMESA_RGBA,
                          OSMESA_DEPTH_BITS,
                          24,
                          OSMESA_PROFILE,
                          OSMESA_CORE_PROFILE,
                          OSMESA_CONTEXT_MAJOR_VERSION,
                          3,
                          OSMESA_CONTEXT_MINOR_VERSION,
                          3,
                          0};
    context_ = OSMesaCreateContextAttribs(wanted, nullptr);
    if (context_ == nullptr) {
      throw std::runtime_error("it cannot make an OpenGL 3.3 core context");
    }
    try {
      if (OSMesaMakeCurrent(context_, pixels_.data(), GL_UNSIGNED_BYTE, width, height) == GL_FALSE) {
        throw std::runtime_error("it cannot draw into a picture of this size");
      }
      loadOpenGl(OSMesaGetProcAddress);
    } catch (...) {
      release();
      throw;
    }
  }
  ~OsMesaOffscreen() override { release(); }
  OsMesaOffscreen(const OsMesaOffscreen&) = delete;
  OsMesaOffscreen& operator=(const OsMesaOffscreen&) = delete;

  [[nodiscard]] OffscreenKind kind() const override { return OffscreenKind::OsMesa; }

 private:
  // While it is current the context points into pixels_: it must go first, or a later EGL context crashes.
  void release() {
    OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
    OSMesaDestroyContext(context_);
  }

  std::vector<unsigned char> pixels_;
  OSMesaContext context_ = nullptr;
};

}  // namespace

std::unique_ptr<Offscreen> makeOsMesaOffscreen(int width, int height) {
  return std::make_unique<OsMesaOffscreen>(width, height);
}

}  // namespace tyg

#endif
