// The line is wiped and written again each time.
#include "app/output/progress.h"

#include <cmath>
#include <cstdio>
#include <iostream>

#include <fmt/core.h>

#include "app/output/exit_code.h"
#include "util/interrupt.h"
#include "util/standard_files.h"
#include "util/visible_text.h"

namespace tyg {
namespace {

constexpr std::chrono::milliseconds kQuietAtFirst{500}, kBetweenDraws{100};
constexpr const char* kWipe = "\r\033[K";

}  // namespace

Progress::Progress(std::string_view what)
    : what_(oneLine(what)), terminal_(messagesGoToTerminal()), nextDraw_(start_ + kQuietAtFirst) {}

Progress::~Progress() { finish(); }

void Progress::finish() {
  if (drawn_) std::fputs(kWipe, stderr);
  drawn_ = false;
}

bool Progress::show(double fraction) {
  if (terminal_ && Clock::now() >= nextDraw_) draw(fraction);
  return !interrupted();
}

std::function<bool(double)> Progress::part(double from, double to) {
  return [this, from, to](double fraction) { return show(from + (to - from) * fraction); };
}

void Progress::draw(double fraction) {
  const Clock::time_point now = Clock::now();
  nextDraw_ = now + kBetweenDraws;
  drawn_ = true;
  fmt::print(stderr, "{}{}: {:3.0f} %", kWipe, what_, std::floor(100 * fraction));
  if (fraction > 0) {
    const double taken = std::chrono::duration<double>(now - start_).count();
    fmt::print(stderr, ", {} left (Ctrl-C stops)", readableTime(taken * (1 - fraction) / fraction));
  }
  std::fflush(stderr);
}

void sayLargeOutput(const std::string& command, const std::string& out, const Scene& scene, std::size_t times,
                    double bytes) {
  constexpr double kGigabyte = 1e9;
  const double all = bytes * double(times) * scene.columns * scene.rows;
  if (all < kGigabyte) return;
  std::cerr << fmt::format("{}: {} will take about {:.2g} GB", command, oneLine(out), all / kGigabyte) << std::endl;
}

int sayInterrupted(const std::string& command, const std::string& kept) {
  std::cerr << command << ": interrupted; " << kept << std::endl;
  return kInterrupted;
}

std::string readableTime(double seconds) {
  const auto whole = static_cast<long long>(std::ceil(std::fmin(seconds, 1e15)));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", whole / 3600, whole / 60 % 60);
}

}  // namespace tyg
