// See room.h.
#include "viewer/room.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

namespace tyg {
namespace {

/// The trial run that finds out how much room a cloth needs: simulated and wall time at most, ticks between looks.
constexpr double kTrialSeconds = 3, kTrialWallSeconds = 0.15;
constexpr int kTicksPerLook = 10;

void addCorners(const Box& box, std::vector<glm::vec3>& room) {
  const std::array<glm::vec3, 8> corners = box.corners();
  room.insert(room.end(), corners.begin(), corners.end());
}

/// Where a pinned cloth that starts flat will hang.
void addHangingCloth(const Simulation& simulation, std::vector<glm::vec3>& room) {
  const Sheet& sheet = simulation.sheet();
  const Vec3& pull = simulation.scene().gravity;
  const glm::vec3 gravity(pull.x, pull.y, pull.z);
  if (sheet.start != Start::Flat || glm::length(gravity) == 0) return;
  const glm::vec3 fall = static_cast<float>(sheet.spacing * (sheet.rows - 1)) * glm::normalize(gravity);
  for (const int pin : sheet.pins) {
    const Vec3 at = sheet.startPosition(pin);
    room.push_back(fall + glm::vec3(at.x, at.y, at.z));
  }
}

/// Where a pinned cloth gets to in its first seconds, by trying it out for as long as nobody notices. Only the view
/// depends on how far that comes.
void addMotion(Simulation trial, const std::function<double()>& clock, std::vector<glm::vec3>& room) {
  std::vector<float> xyz(static_cast<std::size_t>(3 * trial.sheet().count()));
  const double start = clock(), end = std::min(trial.scene().duration, kTrialSeconds);
  while (trial.time() < end && clock() - start < kTrialWallSeconds) {
    trial.tick();
    if (trial.ticks() % kTicksPerLook != 0) continue;
    if (trial.check() != Status::Ok) return;
    trial.copyPositions(xyz);
    addCorners(boxAround(xyz), room);
  }
}

}  // namespace

std::vector<glm::vec3> roomOf(const Simulation& simulation, const Box& box, const Settings& settings,
                              const std::function<double()>& clock) {
  std::vector<glm::vec3> room;
  addCorners(box, room);
  if (simulation.sheet().pins.empty()) return room;
  addHangingCloth(simulation, room);
  addMotion(Simulation(simulation.scene(), simulation.method(), settings), clock, room);
  return room;
}

}  // namespace tyg
