// A push lasts whole ticks and is in the run's log. Holding the button adds another one where the last one ends, so
// that no two pushes ever act at once.
#include "viewer/push_tool.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "view/picking.h"

namespace tyg {
namespace {

/// Simulated seconds that a click pushes, and by which holding the button goes on.
constexpr double kClickSeconds = 0.1, kHoldSeconds = 0.02;
constexpr double kShare = 0.15;         // of the cloth's weight: the usual force
constexpr double kLeastWeights = 3;     // but so many weights of a particle, for scenes of a few particles
constexpr double kEarthGravity = 9.81;  // m/s2: what a push is measured by even where a scene has no gravity
constexpr double kShownSeconds = 0.3;   // wall time that a push stays on screen
constexpr double kLongAgo = -1e9;       // s, of the clock

int wholeTicks(double seconds, double dt) {
  constexpr double kMost = 1e9;  // of ticks too short to simulate, a push lasts as many as can be counted
  return static_cast<int>(std::clamp(std::ceil(seconds / dt - 1e-9), 1.0, kMost));
}

class PushTool final : public Tool {
 public:
  void press(const ToolScope& scope, glm::vec2 cursor) override {
    const glm::vec2 window(scope.view.pixels().width, scope.view.pixels().height);
    const Camera& camera = scope.view.camera();
    const Sheet& sheet = scope.run.simulation().sheet();
    const std::optional<int> hit = pickParticle(camera, cursor, window, sheet, scope.run.shown().positions());
    const glm::dvec3 away = hit ? glm::dvec3(sightLine(camera, cursor, window).direction) : glm::dvec3(0, 0, 1);
    const glm::dvec3 force = scope.record.strength * usualPush(sheet) * away;
    particle_ = hit ? *hit : particleAt(sheet, Place{.name = "middle"});
    force_ = {force.x, force.y, force.z};
    held_ = true;
    push(scope.run.intervene(), kClickSeconds);
    pressedAt_ = scope.run.now();
    scope.record.picked = particle_;
    ++scope.record.uses;
    if (std::ranges::binary_search(sheet.pins, particle_)) {
      scope.notes.say("That particle is pinned: no push moves it.");
    }
  }

  void release() override { held_ = false; }

  std::int64_t follow(Simulation& simulation) override {
    if (!held_) return std::numeric_limits<std::int64_t>::max();
    if (simulation.ticks() >= end_) push(simulation, kHoldSeconds);
    return end_ - simulation.ticks();
  }

  [[nodiscard]] bool actsAt(std::int64_t tick) const override { return tick < end_; }

  void restart() override {
    held_ = false;
    end_ = 0;
    pressedAt_ = kLongAgo;
  }

  /// While it acts or is about to, and long enough to be seen.
  [[nodiscard]] ToolDrawing drawing(const RunControl& run) const override {
    const bool acts = held_ || actsAt(run.simulation().ticks());
    const bool shows = acts || run.now() - pressedAt_ < kShownSeconds;
    if (!shows || run.state() == RunState::Frozen) return {};
    return {.arrow = ShownPush{.particle = particle_, .force = force_}};
  }

 private:
  void push(Simulation& simulation, double seconds) {
    const int ticks = wholeTicks(seconds, simulation.dt());
    simulation.push(particle_, force_, ticks);
    end_ = simulation.ticks() + ticks;
  }

  bool held_ = false;
  int particle_ = 0;
  Vec3 force_;                   ///< N, of the last push
  std::int64_t end_ = 0;         ///< tick
  double pressedAt_ = kLongAgo;  ///< s, of the clock
};

}  // namespace

double usualPush(const Sheet& sheet) {
  return sheet.particleMass * kEarthGravity * std::max(kLeastWeights, kShare * sheet.count());
}

std::unique_ptr<Tool> makePushTool() { return std::make_unique<PushTool>(); }

}  // namespace tyg
