// The window's frames: takes what the person did, moves the viewer, draws, and writes the log, until the window closes.
// Must not know: the command line, what an input does, how anything is drawn.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "ui/cloth_painter.h"
#include "ui/frame_capture.h"
#include "ui/hud.h"
#include "ui/input_router.h"
#include "ui/opening_window.h"
#include "ui/panels/panels.h"
#include "viewer/hints.h"
#include "viewer/view_log.h"
#include "viewer/viewer.h"
#include "viewer/window_memory.h"

namespace tyg {

class FrameLoop {
 public:
  /// `opening`, `viewer` and `memory` must live as long as this does. `log` is a file for one CSV line a frame; a
  /// window with one shows no hints. Throws std::runtime_error where the driver refuses the shaders, and InputError
  /// where the log cannot be written.
  FrameLoop(OpeningWindow& opening, Viewer& viewer, WindowMemory& memory, const std::optional<std::string>& log);

  /// Until the window is closed, the person leaves, or the program is interrupted. Returns what is left to tell the
  /// person when the window is gone; empty: nothing.
  std::string run();

 private:
  void takeEvents();
  [[nodiscard]] Insets insets() const;
  void show();
  void draw();
  void followTitle();
  void followImage();
  void updateHints();
  void writeLog();
  std::string endMovie();
  void recall();
  void remember();

  Viewer& viewer_;
  WindowMemory& memory_;
  Background background_ = Background::Dark;  ///< at the start
  std::optional<Show> look_;                  ///< chosen before the start
  bool fullScreen_ = false;
  Window& window_;
  ImGuiSession& imgui_;
  ClothPainter painter_;
  Hud hud_;
  Panels panels_;
  FrameCapture capture_;
  InputRouter router_;
  Hints hints_;
  std::unique_ptr<ViewLog> log_;
  std::string title_, image_;
  double opened_;     ///< s, of the wall clock
  double spare_ = 0;  ///< s that the last frame was too short
  std::int64_t frame_ = 0;
  int stale_;     ///< frames to show, because something happened
  Extent shown_;  ///< size of the window in the last frame that was shown
};

}  // namespace tyg
