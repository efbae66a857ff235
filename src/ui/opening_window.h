// The window from before there is a cloth to show in it: a large one takes a while, and the window says so.
// Must not know: the viewer, the command line, what is drawn later.
#pragma once

#include <memory>
#include <string>

#include "tyg/scene.h"
#include "ui/imgui_session.h"
#include "ui/windows/window.h"

namespace tyg {

enum class WindowLibrary { Glfw, Glut };

struct OpeningOptions {
  WindowLibrary library = WindowLibrary::Glfw;
  Extent size{1280, 720};  ///< pixels, > 0; the screen may give less
  double uiScale = 1;      ///< > 0: of the text, on top of the screen's own scale
};

std::string windowTitle(const Scene& scene);

class OpeningWindow {
 public:
  /// Opens the window of the scene. Throws NoDisplay or WindowError.
  OpeningWindow(const OpeningOptions& options, const Scene& scene);

  [[nodiscard]] Window& window() { return *window_; }
  [[nodiscard]] ImGuiSession& imgui() { return imgui_; }

 private:
  void announce(const std::string& words);

  std::unique_ptr<Window> window_;
  ImGuiSession imgui_;
};

}  // namespace tyg
