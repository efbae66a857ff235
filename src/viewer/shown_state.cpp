// Copies into a second buffer first: what turns out not to be finite must not replace what is shown.
#include "viewer/shown_state.h"

#include <algorithm>
#include <cmath>

namespace tyg {
namespace {

/// Sheet sizes: of a cloth that is let break and is larger than this there is nothing to see.
constexpr double kMostSizes = 1000;

}  // namespace

bool ShownState::take(const Simulation& simulation, bool pastAlarm) {
  const Glance glance = simulation.glance();
  const auto numbers = static_cast<std::size_t>(3 * simulation.sheet().count());
  positions_.resize(numbers);
  if (glance.status == Status::NotFinite || (glance.status != Status::Ok && !pastAlarm)) return false;
  next_.resize(numbers);
  simulation.copyPositions(next_);
  // A run past its alarm leaves what a picture can hold before it leaves what can be computed with.
  if (!std::ranges::all_of(next_, [](float x) { return std::isfinite(x); })) return false;
  if (pastAlarm && double(boxAround(next_).size()) > kMostSizes * simulation.sheet().size()) return false;
  positions_.swap(next_);
  kinetic_ = glance.ledger.kinetic;
  time_ = simulation.time();
  tick_ = simulation.ticks();
  box_ = boxAround(positions_);
  followSheet(simulation);
  return true;
}

}  // namespace tyg
