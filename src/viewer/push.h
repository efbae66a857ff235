// A push: a force on one particle for whole ticks, which goes on as long as it is held.
// Must not know: windows, cursors, which tool pushes.
#pragma once

#include <cstdint>

#include "viewer/tool.h"

namespace tyg {

/// A push lasts whole ticks and is in the run's log. Holding it adds another one where the last one ends, so that no
/// two pushes ever act at once.
class HeldPush {
 public:
  /// Pushes a particle with this force (N) for as long as a click does, and then as long as it is held.
  void begin(RunControl& run, int particle, const Vec3& force);
  void release() { held_ = false; }
  /// See Tool.
  std::int64_t follow(Simulation& simulation);
  [[nodiscard]] bool actsAt(std::int64_t tick) const { return tick < end_; }
  void restart();
  /// While it acts or is about to, and long enough to be seen; else none.
  [[nodiscard]] std::optional<ShownPush> arrow(const RunControl& run) const;

 private:
  static constexpr double kLongAgo = -1e9;  // s, of the clock
  void push(Simulation& simulation, double seconds);

  bool held_ = false;
  int particle_ = 0;
  Vec3 force_;               ///< N
  std::int64_t end_ = 0;     ///< tick
  double began_ = kLongAgo;  ///< s, of the clock
};

/// N: the force of a click where tools act with their usual strength: seen everywhere, and it tears nothing.
double usualPush(const Sheet& sheet);

}  // namespace tyg
