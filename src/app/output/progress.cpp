// The progress line.
#include "app/output/progress.h"

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <utility>

namespace tyg {
namespace {

constexpr std::chrono::milliseconds kQuietAtFirst{500}, kBetweenDraws{100};
constexpr const char* kWipe = "\r\033[K";

}  // namespace

Progress::Progress(std::string what)
    : what_(std::move(what)), terminal_(isatty(STDERR_FILENO) == 1), nextDraw_(start_ + kQuietAtFirst) {}

Progress::~Progress() { finish(); }

void Progress::finish() {
  if (drawn_) std::fputs(kWipe, stderr);
  drawn_ = false;
}

void Progress::show(double fraction) {
  if (!terminal_) return;
  const Clock::time_point now = Clock::now();
  if (now < nextDraw_) return;
  nextDraw_ = now + kBetweenDraws;
  drawn_ = true;
  std::fprintf(stderr, "%s%s: %3.0f %%", kWipe, what_.c_str(), std::floor(100 * fraction));
  if (fraction > 0) {
    const double taken = std::chrono::duration<double>(now - start_).count();
    std::fprintf(stderr, ", %s left (Ctrl-C stops)", readableTime(taken * (1 - fraction) / fraction).c_str());
  }
  std::fflush(stderr);
}

std::string readableTime(double seconds) {
  const auto whole = static_cast<long long>(std::ceil(std::fmin(seconds, 1e15)));
  const auto pair = [](long long high, const char* highUnit, long long low, const char* lowUnit) {
    return std::to_string(high) + highUnit + std::to_string(low) + lowUnit;
  };
  if (whole < 60) return std::to_string(whole) + " s";
  if (whole < 3600) return pair(whole / 60, " min ", whole % 60, " s");
  return pair(whole / 3600, " h ", whole / 60 % 60, " min");
}

}  // namespace tyg
