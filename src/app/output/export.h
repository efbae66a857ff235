// A moving scene as files for other programs.
// Must not know: options of the command line, windows.
#pragma once

#include <filesystem>
#include <vector>

#include "tyg/scene.h"

namespace tyg {

/// What to export, and where to.
struct ExportRequest {
  std::vector<double> times;  ///< s, >= 0, ascending, at least one: those of the frames
  double fps = 24;            ///< frames to a second, > 0
  std::filesystem::path out;  ///< FILE.usda, or a folder for numbered OBJ files
  int threads = 0;            ///< as Settings::threads
};

/// Checks the output, simulates, writes, and names what it wrote on standard output. A scene that loses springs is
/// simulated twice, so that its mesh can stay the same. Returns the program's exit code; throws InputError where the
/// output cannot be written.
int exportScene(const Scene& scene, const ExportRequest& request);

}  // namespace tyg
