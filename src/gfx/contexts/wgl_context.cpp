// Asking for a core context takes a function that only a context gives, so that two are made.
#ifdef _WIN32

#include "gfx/contexts/wgl_context.h"

#include <windows.h>

#include <array>
#include <stdexcept>
#include <string>

namespace tyg {
namespace {

// WGL_ARB_create_context and WGL_ARB_create_context_profile.
constexpr int kMajorVersion = 0x2091, kMinorVersion = 0x2092, kProfile = 0x9126, kCoreProfile = 1;
using CreateContext = HGLRC(WINAPI*)(HDC device, HGLRC shared, const int* wanted);

void require(bool worked, const char* step) {
  if (worked) return;
  throw std::runtime_error(std::string(step) + " failed (Windows error " + std::to_string(GetLastError()) + ")");
}

HWND windowOf(void* window) { return static_cast<HWND>(window); }
HDC deviceOf(void* device) { return static_cast<HDC>(device); }
HGLRC contextOf(void* context) { return static_cast<HGLRC>(context); }

}  // namespace

WglContext::WglContext(int major, int minor) {
  try {
    makeDevice();
    makeContext(major, minor);
  } catch (...) {
    release();
    throw;
  }
}

WglContext::~WglContext() { release(); }

/// Extensions are found by one function, what OpenGL 1.1 had in the library itself.
void (*WglContext::find(const char* name))() {
  using Function = void (*)();
  if (const auto function = wglGetProcAddress(name)) return reinterpret_cast<Function>(function);
  return reinterpret_cast<Function>(GetProcAddress(GetModuleHandleW(L"opengl32.dll"), name));
}

void WglContext::makeDevice() {
  window_ = CreateWindowExW(0, L"STATIC", L"tyg", WS_POPUP, 0, 0, 1, 1, nullptr, nullptr, nullptr, nullptr);
  require(window_ != nullptr, "making a window that is not shown");
  device_ = GetDC(windowOf(window_));
  PIXELFORMATDESCRIPTOR format{};
  format.nSize = sizeof format;
  format.nVersion = 1;
  format.dwFlags = PFD_DRAW_TO_WINDOW | PFD_SUPPORT_OPENGL;
  format.iPixelType = PFD_TYPE_RGBA;
  format.cColorBits = 32;
  const int chosen = ChoosePixelFormat(deviceOf(device_), &format);
  require(chosen != 0 && SetPixelFormat(deviceOf(device_), chosen, &format) != 0, "choosing a format of pixels");
}

void WglContext::makeContext(int major, int minor) {
  const HDC device = deviceOf(device_);
  context_ = wglCreateContext(device);
  require(context_ != nullptr && wglMakeCurrent(device, contextOf(context_)) != 0, "making an OpenGL context");
  const auto create = reinterpret_cast<CreateContext>(find("wglCreateContextAttribsARB"));
  require(create != nullptr, "finding wglCreateContextAttribsARB");
  const std::array<int, 7> wanted{kMajorVersion, major, kMinorVersion, minor, kProfile, kCoreProfile, 0};
  const HGLRC core = create(device, nullptr, wanted.data());
  require(core != nullptr, "making an OpenGL core context");
  wglMakeCurrent(device, core);
  wglDeleteContext(contextOf(context_));
  context_ = core;
}

void WglContext::release() {
  wglMakeCurrent(nullptr, nullptr);
  if (context_ != nullptr) wglDeleteContext(contextOf(context_));
  if (device_ != nullptr) ReleaseDC(windowOf(window_), deviceOf(device_));
  if (window_ != nullptr) DestroyWindow(windowOf(window_));
}

}  // namespace tyg

#endif
