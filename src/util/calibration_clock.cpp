// For one thread the time that the processor spent on it, so that other programs do not count; for more, wall time.
#include "util/calibration_clock.h"

#include <chrono>
#include <ctime>

namespace tyg {

double calibrationClock(int threads) {
  timespec now{};  // not in std everywhere
  if (threads > 1 || clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now) != 0) return wallClock();
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double wallClock() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace tyg
