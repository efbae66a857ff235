// Each drawing wipes the line and writes it anew.
#include "app/output/progress.h"

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <utility>

#include <fmt/core.h>

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
  fmt::print(stderr, "{}{}: {:3.0f} %", kWipe, what_, std::floor(100 * fraction));
  if (fraction > 0) {
    const double taken = std::chrono::duration<double>(now - start_).count();
    fmt::print(stderr, ", {} left (Ctrl-C stops)", readableTime(taken * (1 - fraction) / fraction));
  }
  std::fflush(stderr);
}

std::string readableTime(double seconds) {
  const auto whole = static_cast<long long>(std::ceil(std::fmin(seconds, 1e15)));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", whole / 3600, whole / 60 % 60);
}

}  // namespace tyg
