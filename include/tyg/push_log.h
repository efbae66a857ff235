// What a person did to a running cloth, tick by tick, so that it can be done again to the same bits.
// Must not know: windows, the simulation.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tyg/scene.h"

namespace tyg {

/// One deed, taking effect at the beginning of a tick.
struct LogEvent {
  enum class Kind { Push, Method, Step, Structural, Shear, Bend, Gravity, Drag, Tolerance };
  std::int64_t tick = 0;
  Kind kind = Kind::Push;
  int particle = 0;  ///< Push
  /// Push, N. Of the others what is new: Gravity, m/s2; Drag and Tolerance, x, N s/m and m; a family of springs, x, ks
  /// in N/m, and y, kd in N s/m.
  Vec3 force{};
  int ticks = 0;         ///< Push, how long
  std::string method{};  ///< Method
  double dt = 0;         ///< Step, s
  bool operator==(const LogEvent&) const = default;
};

/// The deeds in order, and what they were done to.
struct PushLog {
  std::string scene;  ///< built-in name or path
  int columns = 0, rows = 0;
  std::string integrator;  ///< at the start
  double dt = 0;           ///< s, at the start
  Precision precision = Precision::Double;
  std::int64_t ticks = 0;  ///< length of the run
  std::string hash;        ///< of the state at the end, hexadecimal; empty where nobody asked
  std::vector<LogEvent> events;
  std::string sceneText;  ///< TOML of the scene as the run began it, whatever its file says by now; empty: not told
  bool operator==(const PushLog&) const = default;
};

/// The log of a run of this scene with this method, before anything has been done.
PushLog beginLog(const Scene& scene, std::string_view integrator);
/// As text: `# key = value` lines, the scene's lines after `## ` each, then CSV with the header
/// `tick,event,particle,fx,fy,fz,ticks,method,dt`.
std::string formatPushLog(const PushLog& log);
/// Throws InputError with file, line, what was found and what is allowed.
PushLog parsePushLog(std::string_view text, const std::string& fileName);
/// Throws InputError where `log` cannot be done again in a simulation whose own log, at its start, is `own`.
void refuseUnfitLog(const PushLog& log, const PushLog& own);

}  // namespace tyg
