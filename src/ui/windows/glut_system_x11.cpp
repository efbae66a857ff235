// An X connection of our own asks before freeglut does, and watches the focus.
#ifndef _WIN32

#include <GL/freeglut.h>
#include <X11/Xlib.h>
#include <poll.h>

#include <algorithm>
#include <array>
#include <thread>

#include "ui/windows/glut_system.h"
#include "ui/windows/window.h"

// Xlib's macro would hide everything of that name.
#undef None

namespace tyg {
namespace {

GlutSystem::EndHere endOfProcess = nullptr;

int onXError(::Display* display, XErrorEvent* error) {
  std::array<char, 256> text{};
  XGetErrorText(display, error->error_code, text.data(), static_cast<int>(text.size()));
  endOfProcess(text.data());
  return 0;
}

}  // namespace

struct GlutSystem::Impl {
  ::Display* display = XOpenDisplay(nullptr);
  XErrorHandler before = nullptr;

  ~Impl() {
    if (display != nullptr) XCloseDisplay(display);
  }
};

GlutSystem::GlutSystem(EndHere endHere) : impl_(std::make_unique<Impl>()) {
  if (impl_->display == nullptr) throw NoDisplay("no display to open a window on (no X server answers)");
  int opcode = 0, event = 0, error = 0;
  if (XQueryExtension(impl_->display, "GLX", &opcode, &event, &error) == 0) {
    throw WindowError("this display gives no OpenGL 3.3 window (it has no GLX)");
  }
  endOfProcess = endHere;
  impl_->before = XSetErrorHandler(onXError);
}

GlutSystem::~GlutSystem() = default;

void GlutSystem::opened() { XSetErrorHandler(impl_->before); }

std::uintptr_t GlutSystem::focus() const {
  ::Window focus = 0;
  int revertTo = 0;
  XGetInputFocus(impl_->display, &focus, &revertTo);
  return focus;
}

void (*GlutSystem::find(const char* name))() { return glutGetProcAddress(name); }

/// freeglut cannot wait for an event by itself: its connection to the server is that of the current context.
void GlutSystem::wait(std::chrono::milliseconds longest) {
  constexpr std::chrono::milliseconds kNap{5};
  using CurrentDisplay = ::Display* (*)();
  static const auto currentDisplay = reinterpret_cast<CurrentDisplay>(glutGetProcAddress("glXGetCurrentDisplay"));
  ::Display* display = currentDisplay != nullptr ? currentDisplay() : nullptr;
  if (display == nullptr) return std::this_thread::sleep_for(std::min(kNap, longest));
  if (XPending(display) > 0) return;
  pollfd connection{.fd = ConnectionNumber(display), .events = POLLIN, .revents = 0};
  poll(&connection, 1, static_cast<int>(longest.count()));
}

}  // namespace tyg

#endif
