// The viewer's log: one CSV line a frame, written through to the disk line by line, so that scripts can follow a
// running window. Must not know: windows, the simulation.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "tyg/scene.h"

namespace tyg {

/// What one frame showed.
struct ViewLogLine {
  std::int64_t frame = 0;
  double wall = 0;         ///< s since the window opened
  double time = 0;         ///< simulated s
  std::string_view state;  ///< waiting, running, paused or frozen
  std::string_view integrator;
  double dt = 0;           ///< s
  Vec3 eye;                ///< m
  int picked = -1;         ///< particle pushed last; -1 before any push
  int pushes = 0;          ///< clicks so far
  double kinetic = 0;      ///< J
  std::string_view alarm;  ///< ok, unstable or not-finite
  std::string_view tool;   ///< that is chosen
  int held = -1;           ///< particle that is grabbed; -1: none
  int pins = 0;            ///< how many particles are pinned
  int cuts = 0;            ///< by hand, that are not taken back
};

class ViewLog {
 public:
  /// Starts the file anew with its header. Throws InputError where it cannot be written.
  explicit ViewLog(const std::filesystem::path& path);
  /// Throws InputError where the line does not reach the file (a full disk). Allocates nothing.
  void write(const ViewLogLine& line);

 private:
  std::filesystem::path path_;
  std::ofstream file_;
};

}  // namespace tyg
