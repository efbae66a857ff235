// Off-screen drawing into plain memory by OSMesa, where its header was found. <GL/osmesa.h> brings its own OpenGL
// header, which cannot be included together with the loader's in newer versions of Mesa, so this file never includes
// the loader. The library is opened when it is first wanted: linked, its compiler (LLVM) would cost every start of the
// program tens of milliseconds.
#ifdef TYG_HAVE_OSMESA

#include <GL/osmesa.h>
#include <dlfcn.h>
#include <fmt/core.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "gfx/contexts/offscreen_kinds.h"

namespace tyg {
namespace {

/// The functions of the library, which once opened stays so: contexts and drivers hold on to it.
struct OsMesaLibrary {
  decltype(&OSMesaCreateContextAttribs) createContext = nullptr;
  decltype(&OSMesaMakeCurrent) makeCurrent = nullptr;
  decltype(&OSMesaDestroyContext) destroyContext = nullptr;
  decltype(&OSMesaGetProcAddress) find = nullptr;

  OsMesaLibrary() {
    void* library = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) throw std::runtime_error(std::string("its library does not load: ") + dlerror());
    load(library, "OSMesaCreateContextAttribs", createContext);
    load(library, "OSMesaMakeCurrent", makeCurrent);
    load(library, "OSMesaDestroyContext", destroyContext);
    load(library, "OSMesaGetProcAddress", find);
  }

 private:
  template <class Function>
  static void load(void* library, const char* name, Function& function) {
    function = reinterpret_cast<Function>(dlsym(library, name));
    if (function == nullptr) throw std::runtime_error(std::string("its library has no ") + name);
  }
};

const OsMesaLibrary& osMesa() {
  static const OsMesaLibrary library;
  return library;
}

/// A context that is current while it lives, and the memory that it draws into.
class OsMesaPixels {
 public:
  OsMesaPixels(int width, int height, int major, int minor)
      : pixels_(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
    const int wanted[] = {OSMESA_FORMAT,
                          OSMESA_RGBA,
                          OSMESA_DEPTH_BITS,
                          24,
                          OSMESA_PROFILE,
                          OSMESA_CORE_PROFILE,
                          OSMESA_CONTEXT_MAJOR_VERSION,
                          major,
                          OSMESA_CONTEXT_MINOR_VERSION,
                          minor,
                          0};
    context_ = osMesa().createContext(wanted, nullptr);
    if (context_ == nullptr) {
      throw std::runtime_error(fmt::format("it cannot make an OpenGL {}.{} core context", major, minor));
    }
    if (osMesa().makeCurrent(context_, pixels_.data(), GL_UNSIGNED_BYTE, width, height) == GL_TRUE) return;
    release();
    throw std::runtime_error("it cannot draw into a picture of this size");
  }
  ~OsMesaPixels() { release(); }
  OsMesaPixels(const OsMesaPixels&) = delete;
  OsMesaPixels& operator=(const OsMesaPixels&) = delete;

 private:
  // While it is current the context points into pixels_: it must go first, or a later EGL context crashes.
  void release() {
    osMesa().makeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
    osMesa().destroyContext(context_);
  }

  std::vector<unsigned char> pixels_;
  OSMesaContext context_ = nullptr;
};

class OsMesaOffscreen final : public Offscreen {
 public:
  OsMesaOffscreen(int width, int height)
      : Offscreen(width, height),
        context_(
            makeComputingElseDrawing([&](int major, int minor) { return OsMesaPixels(width, height, major, minor); })) {
    loadOpenGl(osMesa().find);
  }
  [[nodiscard]] OffscreenKind kind() const override { return OffscreenKind::OsMesa; }
  [[nodiscard]] Find find() const override { return osMesa().find; }

 private:
  OsMesaPixels context_;
};

class OsMesaComputeContext final : public ComputeContext {
 public:
  [[nodiscard]] Find find() const override { return osMesa().find; }

 private:
  OsMesaPixels context_{1, 1, kComputeMajor, kComputeMinor};
};

}  // namespace

std::unique_ptr<Offscreen> makeOsMesaOffscreen(int width, int height) {
  return std::make_unique<OsMesaOffscreen>(width, height);
}

std::unique_ptr<ComputeContext> makeOsMesaComputeContext() { return std::make_unique<OsMesaComputeContext>(); }

}  // namespace tyg

#endif
