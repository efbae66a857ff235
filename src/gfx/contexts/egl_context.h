// EGL without a surface: displays, and contexts that are current without anything to draw into. Included by the files
// of this folder that use EGL alone. Must not know: what is drawn or computed.
#pragma once

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <memory>
#include <vector>

namespace tyg {

/// Throws std::runtime_error that says which step failed.
void requireEgl(bool worked, const char* step);

/// A display that is initialised while anybody holds it: EGL gives everybody the same one, and ends it for all.
class EglDisplay {
 public:
  explicit EglDisplay(EGLDisplay display);
  ~EglDisplay();
  EglDisplay(const EglDisplay&) = delete;
  EglDisplay& operator=(const EglDisplay&) = delete;
  [[nodiscard]] EGLDisplay handle() const { return display_; }

  /// The one that needs neither a display nor a window system. Throws std::runtime_error.
  static std::shared_ptr<EglDisplay> surfaceless();
  /// Those of graphics cards; none where EGL cannot list them.
  static std::vector<std::shared_ptr<EglDisplay>> ofCards();

 private:
  EGLDisplay display_;
};

/// An OpenGL core context of this version or a later one, current in the thread that made it while it lives.
class EglContext {
 public:
  /// Throws std::runtime_error that says which step failed.
  EglContext(std::shared_ptr<EglDisplay> display, int major, int minor);
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

 private:
  std::shared_ptr<EglDisplay> display_;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace tyg
