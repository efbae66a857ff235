// A moment of a run, and whether something that is said in times or in ticks acts then.
// Must not know: what acts.
#pragma once

#include <cstdint>

namespace tyg {

/// Times closer than `sameTime` count as the same. s.
struct Instant {
  double time = 0, sameTime = 0;
  std::int64_t tick = 0;

  /// Whether it lies in [at, at + duration).
  [[nodiscard]] bool isWithin(double at, double duration) const {
    const double soon = time + sameTime;
    return at <= soon && soon < at + duration;
  }
};

}  // namespace tyg
