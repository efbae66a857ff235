// The smoothed wall time of a tick tells how many fit into what is left of the frame.
#include "viewer/tick_runner.h"

#include <algorithm>

namespace tyg {
namespace {

/// Ticks in one call: so many steps are fused.
constexpr std::int64_t kMostTogether = 64;
constexpr double kSmoothing = 0.2;  // of the wall time of a tick, from call to call

}  // namespace

void TickRunner::guard(Simulation& simulation) {
  simulation.observe([this] {
    late_ = clock_() - tickBegan_ >= kLongestTick;
    return !late_;
  });
}

std::int64_t TickRunner::ticksIn(double seconds) const {
  if (tickSeconds_ <= 0) return 1;
  return std::clamp(std::int64_t(std::min(seconds / tickSeconds_, 1e9)), std::int64_t{1}, kMostTogether);
}

void TickRunner::run(Simulation& simulation, History& history, RunListener& listener, std::int64_t ticks,
                     double seconds) {
  const double start = clock_();
  const std::int64_t first = simulation.ticks(), end = first + ticks;
  double now = start;
  while (simulation.ticks() < end && (simulation.ticks() == first || now - start < seconds)) {
    std::int64_t most = std::min(end - simulation.ticks(), ticksIn(start + seconds - now));
    if (!history.past()) most = std::min(most, listener.beforeTicks(simulation, end - simulation.ticks()));
    const std::int64_t before = simulation.ticks();
    tickBegan_ = now;
    history.tick(simulation, most);
    const std::int64_t ran = simulation.ticks() - before;
    if (ran == 0 || late_) break;  // the alarm went, or a tick was given up
    const double took = (clock_() - now) / double(ran);
    tickSeconds_ += (tickSeconds_ > 0 ? kSmoothing : 1) * (took - tickSeconds_);
    now = clock_();
  }
}

}  // namespace tyg
