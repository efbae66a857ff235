// A window with an OpenGL 3.3 core context and a queue of what the person did: all that the viewer sees of GLFW and
// freeglut. Must not know: the cloth, what a key means, how anything is drawn.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>

#include "viewer/input_event.h"

namespace tyg {

struct WindowOptions {
  std::string title;
  Extent size{1280, 720};  ///< asked for; the screen may give less
};

/// A window cannot be opened or used; `what()` is one sentence for the person.
class WindowError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};
/// There is no display to open a window on.
class NoDisplay : public WindowError {
 public:
  using WindowError::WindowError;
};

class Window {
 public:
  Window() = default;
  virtual ~Window() = default;
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// What happened since the last call, oldest first, waiting up to `seconds` for the first event (0: not at all).
  /// Valid until the next call.
  virtual std::span<const WindowEvent> events(double seconds) = 0;
  /// Shows what was drawn; waits for the screen where it has a rhythm.
  virtual void swap() = 0;
  virtual void setTitle(const std::string& title) = 0;
  virtual void toggleFullScreen() = 0;  ///< all of the screen, and back to where it was
  [[nodiscard]] virtual Extent framebuffer() const = 0;
  [[nodiscard]] virtual double contentScale() const = 0;  ///< of texts on this screen; 1 on an ordinary one
  [[nodiscard]] virtual bool closeRequested() const = 0;  ///< the window's own close button was used
  /// Finds the functions of its context by their names.
  using Finder = void (*(*)(const char* name))();
  [[nodiscard]] virtual Finder finder() const = 0;
  /// `work` is done before the context ends, where that may happen while this lives: freeglut's ends within events(),
  /// when the window is closed.
  virtual void beforeContextEnds(std::function<void()> /*work*/) {}

  // The overlay's input and clock, for ImGui: attach after ImGui's context exists, detach before it goes. A frame
  // begins after ImGui's renderer has begun its own.
  virtual void attachOverlay() = 0;
  virtual void beginOverlayFrame() = 0;
  virtual void detachOverlay() = 0;
  /// The person did more than the overlay's last frame could take: another frame is to follow at once.
  [[nodiscard]] virtual bool overlayBehind() const = 0;
};

/// Each opens a window whose context is current and whose OpenGL functions are loaded. One window at a time.
/// Throws NoDisplay or WindowError.
std::unique_ptr<Window> openGlfwWindow(const WindowOptions& options);
std::unique_ptr<Window> openGlutWindow(const WindowOptions& options);

}  // namespace tyg
