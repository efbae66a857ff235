// What freeglut does not tell of the display: whether there is one, where the keyboard's focus is, and when something
// happens, and on Windows where half of OpenGL is. Each window system answers in a file of its own:
// glut_system_x11.cpp, glut_system_windows.cpp. Must not know: the window that freeglut opens.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>

namespace tyg {

class GlutSystem {
 public:
  /// Does not return: the process ends there.
  using EndHere = void (*)(const char* reason);

  /// Throws NoDisplay or WindowError, so that freeglut need not end the process. Until opened() is called, `endHere`
  /// gets what the display refuses.
  explicit GlutSystem(EndHere endHere);
  ~GlutSystem();
  GlutSystem(const GlutSystem&) = delete;
  GlutSystem& operator=(const GlutSystem&) = delete;

  /// The window is open.
  void opened();
  /// A number for the window that gets what is typed.
  [[nodiscard]] std::uintptr_t focus() const;
  /// Finds a function of OpenGL.
  static void (*find(const char* name))();
  /// Waits until there is something for freeglut to do, as far as that can be known, or until the time is over.
  static void wait(std::chrono::milliseconds longest);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace tyg
