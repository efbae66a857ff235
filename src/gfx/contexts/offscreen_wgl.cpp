// Off-screen drawing on Windows, which gives a context only to a window: this one is never shown.
#ifdef _WIN32

#include <windows.h>
// windows.h first: the loader's header minds what it has defined.
#include <glad/gl.h>

#include <array>
#include <stdexcept>
#include <string>

#include "gfx/contexts/offscreen_framebuffer.h"
#include "gfx/contexts/offscreen_kinds.h"

namespace tyg {
namespace {

// WGL_ARB_create_context and WGL_ARB_create_context_profile.
constexpr int kMajorVersion = 0x2091, kMinorVersion = 0x2092, kProfile = 0x9126, kCoreProfile = 1;
using CreateContext = HGLRC(WINAPI*)(HDC device, HGLRC shared, const int* wanted);

void require(bool worked, const char* step) {
  if (!worked)
    throw std::runtime_error(std::string(step) + " failed (Windows error " + std::to_string(GetLastError()) + ")");
}

/// Extensions are found by one function, what OpenGL 1.1 had in the library itself.
GLADapiproc find(const char* name) {
  if (const auto function = wglGetProcAddress(name)) return reinterpret_cast<GLADapiproc>(function);
  return reinterpret_cast<GLADapiproc>(GetProcAddress(GetModuleHandleW(L"opengl32.dll"), name));
}

class WglOffscreen final : public Offscreen {
 public:
  WglOffscreen(int width, int height) : Offscreen(width, height) {
    try {
      makeDevice();
      makeContext();
      loadOpenGl(find);
      framebuffer_.make(width, height);
    } catch (...) {
      release();
      throw;
    }
  }
  ~WglOffscreen() override {
    framebuffer_.drop();
    release();
  }
  WglOffscreen(const WglOffscreen&) = delete;
  WglOffscreen& operator=(const WglOffscreen&) = delete;

  [[nodiscard]] OffscreenKind kind() const override { return OffscreenKind::Wgl; }

 private:
  void makeDevice() {
    window_ = CreateWindowExW(0, L"STATIC", L"tyg", WS_POPUP, 0, 0, 1, 1, nullptr, nullptr, nullptr, nullptr);
    require(window_ != nullptr, "making a window that is not shown");
    device_ = GetDC(window_);
    PIXELFORMATDESCRIPTOR format{};
    format.nSize = sizeof format;
    format.nVersion = 1;
    format.dwFlags = PFD_DRAW_TO_WINDOW | PFD_SUPPORT_OPENGL;
    format.iPixelType = PFD_TYPE_RGBA;
    format.cColorBits = 32;
    const int chosen = ChoosePixelFormat(device_, &format);
    require(chosen != 0 && SetPixelFormat(device_, chosen, &format) != 0, "choosing a format of pixels");
  }

  /// Asking for a core context takes a function that only a context gives.
  void makeContext() {
    context_ = wglCreateContext(device_);
    require(context_ != nullptr && wglMakeCurrent(device_, context_) != 0, "making an OpenGL context");
    const auto create = reinterpret_cast<CreateContext>(find("wglCreateContextAttribsARB"));
    require(create != nullptr, "finding wglCreateContextAttribsARB");
    const std::array<int, 7> wanted{kMajorVersion, 3, kMinorVersion, 3, kProfile, kCoreProfile, 0};
    const HGLRC core = create(device_, nullptr, wanted.data());
    require(core != nullptr, "making an OpenGL 3.3 core context");
    wglMakeCurrent(device_, core);
    wglDeleteContext(context_);
    context_ = core;
  }

  void release() {
    wglMakeCurrent(nullptr, nullptr);
    if (context_ != nullptr) wglDeleteContext(context_);
    if (device_ != nullptr) ReleaseDC(window_, device_);
    if (window_ != nullptr) DestroyWindow(window_);
  }

  HWND window_ = nullptr;
  HDC device_ = nullptr;
  HGLRC context_ = nullptr;
  OffscreenFramebuffer framebuffer_;
};

}  // namespace

std::unique_ptr<Offscreen> makeWglOffscreen(int width, int height) {
  return std::make_unique<WglOffscreen>(width, height);
}

}  // namespace tyg

#endif
