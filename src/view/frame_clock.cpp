// Time that is owed adds up from frame to frame, up to a limit, and is paid in whole ticks.
#include "view/frame_clock.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tyg {
namespace {

constexpr double kSmoothing = 0.5;  // wall s over which the real-time factor is averaged
constexpr double kSlack = 1e-6;     // ticks: sums of 1/30 s and of 1/144 s reach the same tick whatever their rounding

bool positive(double number) { return std::isfinite(number) && number > 0; }

}  // namespace

void FrameClock::setTick(double seconds) {
  if (!positive(seconds)) {
    throw std::invalid_argument("a tick must be longer than 0 s");
  }
  tick_ = seconds;
}

void FrameClock::setSpeed(double factor) {
  if (!positive(factor)) {
    throw std::invalid_argument("a speed must be above 0");
  }
  speed_ = factor;
  factor_ = factor;
}

int FrameClock::due(double wallSeconds) {
  lastWall_ = positive(wallSeconds) ? wallSeconds : 0;
  // A tick longer than the cap must still become due some time.
  const double most = std::max(kMostPerFrame * speed_, tick_);
  owed_ = std::min(owed_ + lastWall_ * speed_, most);
  const double ticks = std::floor(owed_ / tick_ + kSlack);
  owed_ -= ticks * tick_;
  return static_cast<int>(std::min(ticks, 1e9));
}

void FrameClock::ran(int ticks) {
  if (lastWall_ > 0) {
    // One frame holds whole ticks only, so single frames jitter; the weights make long frames count for more.
    const double now = ticks * tick_ / lastWall_;
    factor_ += (1 - std::exp(-lastWall_ / kSmoothing)) * (now - factor_);
  }
  lastWall_ = 0;
}

void FrameClock::restart() {
  owed_ = 0;
  lastWall_ = 0;
  factor_ = speed_;
}

}  // namespace tyg
