// OpenGL on Windows, which gives a context only to a window: this one is never shown.
// Must not know: what is drawn or computed.
#pragma once

namespace tyg {

/// An OpenGL core context of this version or a later one, current in the thread that made it while it lives.
class WglContext {
 public:
  /// Throws std::runtime_error that says which step failed.
  WglContext(int major, int minor);
  ~WglContext();
  WglContext(const WglContext&) = delete;
  WglContext& operator=(const WglContext&) = delete;

  /// Finds its functions.
  static void (*find(const char* name))();

 private:
  void makeDevice();
  void makeContext(int major, int minor);
  void release();

  void *window_ = nullptr, *device_ = nullptr, *context_ = nullptr;  ///< HWND, HDC and HGLRC of windows.h
};

}  // namespace tyg
