// Extensions are looked up by name: libraries without them still start.
#ifndef _WIN32

#include "gfx/contexts/egl_context.h"

#include <fmt/core.h>

#include <array>
#include <mutex>
#include <stdexcept>
#include <string>
#include <string_view>

namespace tyg {
namespace {

template <class Function>
Function extension(const char* name) {
  return reinterpret_cast<Function>(eglGetProcAddress(name));
}

bool isSoftware(EGLDeviceEXT device) {
  const auto text = extension<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
  const char* extensions = text == nullptr ? nullptr : text(device, EGL_EXTENSIONS);
  return extensions != nullptr &&
         std::string_view(extensions).find("EGL_MESA_device_software") != std::string_view::npos;
}

}  // namespace

void requireEgl(bool worked, const char* step) {
  if (!worked) throw std::runtime_error(fmt::format("{} failed (EGL error {})", step, eglGetError()));
}

EglDisplay::EglDisplay(EGLDisplay display) : display_(display) {
  requireEgl(eglInitialize(display_, nullptr, nullptr) == EGL_TRUE, "initialising EGL");
}

EglDisplay::~EglDisplay() { eglTerminate(display_); }

std::shared_ptr<EglDisplay> EglDisplay::surfaceless() {
  static std::mutex mutex;
  static std::weak_ptr<EglDisplay> present;
  const std::lock_guard lock(mutex);
  std::shared_ptr<EglDisplay> display = present.lock();
  if (display) return display;
  const auto find = extension<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  requireEgl(find != nullptr, "finding eglGetPlatformDisplayEXT");
  EGLDisplay handle = find(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
  requireEgl(handle != EGL_NO_DISPLAY, "opening a surfaceless display");
  display = std::make_shared<EglDisplay>(handle);
  present = display;
  return display;
}

std::vector<std::shared_ptr<EglDisplay>> EglDisplay::ofCards() {
  constexpr EGLint kMostDevices = 16;
  std::array<EGLDeviceEXT, kMostDevices> devices{};
  EGLint count = 0;
  const auto list = extension<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  const auto find = extension<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  std::vector<std::shared_ptr<EglDisplay>> displays;
  if (list == nullptr || find == nullptr || list(kMostDevices, devices.data(), &count) != EGL_TRUE) return displays;
  for (std::size_t k = 0; k < std::size_t(count); ++k) {
    if (isSoftware(devices.at(k))) continue;
    EGLDisplay handle = find(EGL_PLATFORM_DEVICE_EXT, devices.at(k), nullptr);
    if (handle == EGL_NO_DISPLAY) continue;
    try {
      displays.push_back(std::make_shared<EglDisplay>(handle));
    } catch (const std::runtime_error&) {
      continue;  // a card without a driver
    }
  }
  return displays;
}

EglContext::EglContext(std::shared_ptr<EglDisplay> display, int major, int minor) : display_(std::move(display)) {
  const std::array<EGLint, 7> wanted{
      EGL_CONTEXT_MAJOR_VERSION,           major,   EGL_CONTEXT_MINOR_VERSION, minor, EGL_CONTEXT_OPENGL_PROFILE_MASK,
      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
  requireEgl(eglBindAPI(EGL_OPENGL_API) == EGL_TRUE, "choosing OpenGL");
  context_ = eglCreateContext(display_->handle(), EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted.data());
  const std::string making = fmt::format("making an OpenGL {}.{} core context", major, minor);
  requireEgl(context_ != EGL_NO_CONTEXT, making.c_str());
  if (eglMakeCurrent(display_->handle(), EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE) return;
  eglDestroyContext(display_->handle(), context_);
  requireEgl(false, "making it current");
}

EglContext::~EglContext() {
  eglMakeCurrent(display_->handle(), EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_->handle(), context_);
}

}  // namespace tyg

#endif
