// How long and how strongly a click pushes.
#include "viewer/push.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tyg {
namespace {

/// Simulated seconds that a click pushes, and by which holding the button goes on.
constexpr double kClickSeconds = 0.1, kHoldSeconds = 0.02;
constexpr double kShare = 0.15;         // of the cloth's weight: the usual force
constexpr double kLeastWeights = 3;     // but so many weights of a particle, for scenes of a few particles
constexpr double kEarthGravity = 9.81;  // m/s2: what a push is measured by even where a scene has no gravity
constexpr double kShownSeconds = 0.3;   // wall time that a push stays on screen

int wholeTicks(double seconds, double dt) {
  constexpr double kMost = 1e9;  // of ticks too short to simulate, a push lasts as many as can be counted
  return static_cast<int>(std::clamp(std::ceil(seconds / dt - 1e-9), 1.0, kMost));
}

}  // namespace

void HeldPush::begin(RunControl& run, int particle, const Vec3& force) {
  particle_ = particle;
  force_ = force;
  held_ = true;
  push(run.intervene(), kClickSeconds);
  began_ = run.now();
}

void HeldPush::push(Simulation& simulation, double seconds) {
  const int ticks = wholeTicks(seconds, simulation.dt());
  simulation.push(particle_, force_, ticks);
  end_ = simulation.ticks() + ticks;
}

std::int64_t HeldPush::follow(Simulation& simulation) {
  if (!held_) return std::numeric_limits<std::int64_t>::max();
  if (simulation.ticks() >= end_) push(simulation, kHoldSeconds);
  return end_ - simulation.ticks();
}

void HeldPush::restart() {
  held_ = false;
  end_ = 0;
  began_ = kLongAgo;
}

std::optional<ShownPush> HeldPush::arrow(const RunControl& run) const {
  const bool acts = held_ || actsAt(run.simulation().ticks());
  const bool shows = acts || run.now() - began_ < kShownSeconds;
  if (!shows || run.state() == RunState::Frozen) return std::nullopt;
  return ShownPush{.particle = particle_, .force = force_};
}

double usualPush(const Sheet& sheet) {
  return sheet.particleMass * kEarthGravity * std::max(kLeastWeights, kShare * sheet.count());
}

}  // namespace tyg
