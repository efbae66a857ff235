// What is shown of a cloth that is let run on past its alarm: its kinetic energy from moment to moment, and when it is
// torn apart so far that there is nothing more to see. Must not know: how it is drawn.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "viewer/shown_state.h"

namespace tyg {

class BreakRecord {
 public:
  struct Moment {
    double time = 0, kinetic = 0;  ///< s, J
  };
  /// It is shown for this long at most, s, and no faster than this.
  static constexpr double kMostSeconds = 8, kMostTicksPerSecond = 30;
  /// Ticks a second in which it is shown where it has broken after so many: some seconds, whatever the step.
  static double ticksPerSecond(std::int64_t ticks) {
    constexpr double kSeconds = 5, kLeast = 2;
    return std::clamp(double(ticks) / kSeconds, kLeast, kMostTicksPerSecond);
  }

  void clear() { moments_.clear(); }
  /// A state that is shown; those of a past that was noted before are left out.
  void note(const ShownState& shown) {
    if (moments_.empty() || shown.time() > moments_.back().time) moments_.push_back({shown.time(), shown.kinetic()});
  }
  /// It has been shown for some seconds, at steps of dt s.
  [[nodiscard]] bool isSeen(double dt) const {
    return !moments_.empty() && moments_.back().time - moments_.front().time > kMostSeconds * kMostTicksPerSecond * dt;
  }
  /// It is many times as large as its sheet.
  [[nodiscard]] static bool hasBroken(const ShownState& shown) {
    constexpr double kSizes = 6;
    return double(shown.box().size()) > kSizes * shown.sheet().size();
  }
  [[nodiscard]] std::span<const Moment> moments() const { return moments_; }

 private:
  std::vector<Moment> moments_;  ///< in ascending order of time
};

}  // namespace tyg
