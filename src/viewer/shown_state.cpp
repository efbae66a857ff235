// Copies into a second buffer first: what turns out not to be finite must not replace what is shown.
#include "viewer/shown_state.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/simulation/device_positions.h"

namespace tyg {
namespace {

/// Sheet sizes: of a cloth that is let break and is larger than this there is nothing to see.
constexpr double kMostSizes = 1000;

/// A cloth on a device that has grown by more than this since its energy was last looked at is looked at first.
constexpr float kSuspicious = 1.25F;

/// Not so large that boxAround() would leave it out.
bool isUsual(const std::array<float, 3>& corner) {
  constexpr float kFarthest = 1e15F;  // m
  return std::ranges::all_of(corner, [](float x) { return std::abs(x) < kFarthest; });
}

glm::vec3 vec(const std::array<float, 3>& v) { return {v[0], v[1], v[2]}; }

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
  onDevice_.reset();
  note(simulation, glance.ledger.kinetic, boxAround(positions_));
  lookedAt_ = box_.size();
  return true;
}

bool ShownState::follow(const Simulation& simulation) {
  auto onDevice = simulation.status() == Status::Ok ? simulation.positionsOnDevice() : nullptr;
  if (!onDevice || !isUsual(onDevice->low()) || !isUsual(onDevice->high())) return take(simulation, false);
  const Box box{vec(onDevice->low()), vec(onDevice->high())};
  if (box.size() > kSuspicious * lookedAt_) return take(simulation, false);
  onDevice_ = std::move(onDevice);
  isRead_ = false;
  note(simulation, simulation.checkedKinetic(), box);
  return true;
}

void ShownState::note(const Simulation& simulation, double kinetic, const Box& box) {
  kinetic_ = kinetic;
  time_ = simulation.time();
  tick_ = simulation.ticks();
  box_ = box;
  followSheet(simulation);
}

std::span<const float> ShownState::positions() const {
  if (onDevice_ && !std::exchange(isRead_, true)) {
    positions_.resize(static_cast<std::size_t>(3 * sheet_.count()));
    onDevice_->read(positions_);
  }
  return positions_;
}

DrawnPositions ShownState::drawn() const {
  if (!onDevice_) return DrawnPositions(positions_);
  return {onDevice_->buffer(), [this] { return positions(); }};
}

}  // namespace tyg
