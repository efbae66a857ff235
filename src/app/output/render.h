// Pictures and movies of a scene without a display.
// Must not know: options of the command line, windows.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "gfx/contexts/offscreen.h"
#include "gfx/passes/sheet_renderer.h"
#include "tyg/simulation.h"

namespace tyg {

/// What to draw, and where to put it.
struct RenderRequest {
  std::vector<double> times;   ///< s, >= 0, ascending, at least one
  double fps = 30;             ///< of a movie, > 0
  glm::ivec2 size{1280, 720};  ///< pixels; a movie's are rounded up to even numbers
  std::filesystem::path out;   ///< one time: FILE.png; several: FILE.mp4, FILE.gif, else a folder for PNGs
  DrawOptions draw;
  std::optional<Show> show;  ///< of the cloth; nothing: as the scene has it
  int threads = 0;           ///< as Settings::threads
  /// Gives what moves the cloth, as Settings::device, which may compute in the context that draws: its functions are
  /// found there. Nothing: the processor moves it.
  std::function<std::shared_ptr<Device>(Offscreen::Find)> chooseDevice{};
};

/// Checks the output, simulates, draws, writes, and names the files on standard output. One view that holds the whole
/// motion. Returns the program's exit code; throws InputError where the output cannot be written or nothing can draw.
int render(const Scene& scene, const RenderRequest& request);

/// What `tyg view` does without a display: a picture, and a movie where ffmpeg is there and the run is long enough for
/// one, in the current folder under names that no file has yet. `like`: all but times and output.
int renderInstead(const Scene& scene, const RenderRequest& like);

}  // namespace tyg
