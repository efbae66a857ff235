// For one thread the time that the processor spent on it, so that other programs do not count; for more, wall time. A
// system that does not know the former finely gives wall time for one thread too.
#include "util/calibration_clock.h"

#include <chrono>
#include <ctime>

namespace tyg {
namespace {

/// Windows counts the time of a thread in ticks of 16 ms, which is longer than what is measured.
bool threadTimeIsFine() {
  timespec tick{};  // not in std everywhere
  return clock_getres(CLOCK_THREAD_CPUTIME_ID, &tick) == 0 && tick.tv_sec == 0 && tick.tv_nsec < 1'000'000;
}

}  // namespace

double calibrationClock(int threads) {
  static const bool kFine = threadTimeIsFine();
  timespec now{};
  if (threads > 1 || !kFine || clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now) != 0) return wallClock();
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double wallClock() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace tyg
