// Finds the bounds with a trial run of a copy of the simulation, and from the length of what hangs below a pin.
#include "viewer/motion_bounds.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/forces/term.h"
#include "view/body_shapes.h"

namespace tyg {
namespace {

/// The trial run: its simulated and its wall time at most, s, and the ticks between two looks at it.
constexpr double kTrialSeconds = 3, kTrialWallSeconds = 0.15;
constexpr int kTicksPerLook = 10;
/// Of the rows and of the columns, evenly, the particles whose places tell where the cloth is, edges included.
constexpr int kLookedAt = 8;
/// Particles beyond which a trial would only take as long as setting the sheet up again does, and hardly move.
constexpr int kMostInTrial = 512 * 512;

void addCorners(const Box& box, std::vector<glm::vec3>& points) {
  const std::array<glm::vec3, 8> corners = box.corners();
  points.insert(points.end(), corners.begin(), corners.end());
}

/// Where a pinned cloth that starts flat will hang.
void addHangingCloth(const Simulation& simulation, std::vector<glm::vec3>& points) {
  const Sheet& sheet = simulation.sheet();
  const Vec3 pull = steadyForce(simulation.scene());
  const glm::dvec3 force(pull.x, pull.y, pull.z);
  if (sheet.start != Start::Flat || glm::length(force) == 0) return;
  const glm::vec3 fall(sheet.spacing * (sheet.rows - 1) * glm::normalize(force));
  for (const int pin : sheet.pins) {
    const Vec3 at = sheet.startPosition(pin);
    points.push_back(fall + glm::vec3(at.x, at.y, at.z));
  }
}

void addBodies(const Simulation& simulation, const Box& cloth, std::vector<glm::vec3>& points) {
  std::vector<Body> bodies;
  placeBodies(simulation.scene(), simulation.time(), bodies);
  addBodyPoints(bodies, cloth, points);
}

/// Some of so many rows or columns, the first and the last among them.
template <class Look>
void forLookedAt(int count, const Look& look) {
  const int some = std::min(count, kLookedAt);
  for (int k = 0; k < some; ++k) look(some > 1 ? k * (count - 1) / (some - 1) : 0);
}

/// Where a cloth gets to in its first seconds that is pinned, or that bodies hold up; one that misses them falls far.
/// How far the trial comes depends on the machine, and only the first view depends on that.
void addMotion(Simulation trial, const Box& cloth, const std::function<double()>& clock,
               std::vector<glm::vec3>& points) {
  const Box around = surroundingsOf(cloth);
  std::vector<float> xyz(static_cast<std::size_t>(3 * trial.sheet().count()));
  const bool hasBodies = !trial.scene().bodies.empty();
  const auto clamped = [&](const glm::vec3& point) { return glm::clamp(point, around.low, around.high); };
  const double start = clock(), end = std::min(trial.scene().duration, kTrialSeconds);
  const auto goesOn = [&] { return clock() - start < kTrialWallSeconds; };
  trial.observe(goesOn);
  while (trial.time() < end && goesOn()) {
    trial.tick();
    if (trial.status() != Status::Ok) return;  // no later tick would bring it on
    if (trial.ticks() % kTicksPerLook != 0) continue;
    if (trial.check() != Status::Ok) return;
    trial.copyPositions(xyz);
    const Sheet& sheet = trial.sheet();
    forLookedAt(sheet.rows, [&](int row) {
      forLookedAt(sheet.columns, [&](int column) {
        const auto at = static_cast<std::size_t>(3 * (row * sheet.columns + column));
        const glm::vec3 place(xyz[at], xyz[at + 1], xyz[at + 2]);
        points.push_back(hasBodies ? clamped(place) : place);
      });
    });
  }
  addBodies(trial, cloth, points);
}

}  // namespace

std::vector<glm::vec3> motionBounds(const Simulation& simulation, const Box& box, const Settings& settings,
                                    const std::function<double()>& clock) {
  std::vector<glm::vec3> points;
  addCorners(box, points);
  addBodies(simulation, box, points);
  if (simulation.sheet().pins.empty() && simulation.scene().bodies.empty()) return points;
  addHangingCloth(simulation, points);
  if (simulation.sheet().count() > kMostInTrial) return points;
  addMotion(Simulation(simulation.scene(), simulation.method(), settings), box, clock, points);
  return points;
}

}  // namespace tyg
