// Positions are floats: pictures and other programs show no more than that.
#include "app/output/moving_scene.h"

#include <algorithm>
#include <array>
#include <iostream>
#include <utility>

#include "app/output/exit_code.h"
#include "app/reports/run_report.h"
#include "core/simulation/device_positions.h"
#include "study/limits/stability.h"
#include "tyg/methods.h"
#include "util/interrupt.h"
#include "view/body_shapes.h"

namespace tyg {

std::vector<double> frameTimes(double from, double to, double fps) {
  std::vector<double> times;
  // Each from its number, so that rounding does not add up; the slack keeps a last frame that falls on the end.
  for (int frame = 0; from + frame / fps <= to + 1e-9; ++frame) times.push_back(std::min(from + frame / fps, to));
  return times;
}

MovingScene::MovingScene(const Scene& scene, const Settings& settings, const std::function<bool(double)>& progress)
    : simulation_(scene, findMethod(scene.integrator), settings),
      xyz_(3 * static_cast<std::size_t>(simulation_.sheet().count())) {
  simulation_.observe([this, progress] { return progress(simulation_.time()); });
}

bool MovingScene::reach(double time) {
  if (time > simulation_.time()) simulation_.advanceTo(time);  // and checks the energies
  onDevice_ = simulation_.positionsOnDevice();
  isHere_ = false;
  placeBodies(simulation_.scene(), simulation_.time(), bodies_);
  return !interrupted() && simulation_.status() == Status::Ok;
}

std::span<const float> MovingScene::xyz() {
  if (!std::exchange(isHere_, true)) onDevice_ ? onDevice_->read(xyz_) : simulation_.copyPositions(xyz_);
  return xyz_;
}

DrawnPositions MovingScene::drawn() {
  if (!onDevice_) return DrawnPositions(xyz());
  return {onDevice_->buffer(), [this] { return xyz(); }};
}

Box MovingScene::box() {
  if (!onDevice_) return boxAround(xyz());
  const auto vec = [](const std::array<float, 3>& v) { return glm::vec3(v[0], v[1], v[2]); };
  return {vec(onDevice_->low()), vec(onDevice_->high())};
}

int sayStopped(const std::string& command, Simulation& simulation, Progress& progress) {
  progress.finish();
  if (interrupted()) return sayInterrupted(command, "what was not finished was not written");
  const FinishedRun finished{simulation, simulation.ledger(), false, 0,
                             restLatticeLimit(simulation.scene(), simulation.method())};
  std::cerr << command << ": " << failureAdvice(finished) << std::endl;
  return kSimulationFailed;
}

}  // namespace tyg
