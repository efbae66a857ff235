// A scene that is moved on from one time to the next for something that shows it: positions, bodies, and what is said
// where it cannot go on. Must not know: what shows it, options of the command line.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "app/output/progress.h"
#include "tyg/scene.h"
#include "tyg/simulation.h"
#include "view/box.h"
#include "view/drawn_positions.h"

namespace tyg {

/// Times from `from` to `to` (s), both included, `fps` of them to a second.
std::vector<double> frameTimes(double from, double to, double fps);

class MovingScene {
 public:
  /// `progress` gets the time that is reached, s, and stops the simulation where it returns false. Throws InputError.
  MovingScene(const Scene& scene, const Settings& settings, const std::function<bool(double)>& progress);

  /// Goes on to this time, s, which is met exactly. False when the cloth is lost or somebody said stop.
  bool reach(double time);

  /// x, y, z of every particle, m; read back here where a device has them.
  [[nodiscard]] std::span<const float> xyz();
  /// The same for whoever draws, until reach() is called again.
  [[nodiscard]] DrawnPositions drawn();
  [[nodiscard]] Box box();                                                ///< around all particles, m
  [[nodiscard]] std::span<const Body> bodies() const { return bodies_; }  ///< with Body::at where they are now
  [[nodiscard]] Simulation& simulation() { return simulation_; }

 private:
  Simulation simulation_;
  std::shared_ptr<const DevicePositions> onDevice_;  // null: no device has them in the context that draws
  std::vector<float> xyz_;
  bool isHere_ = false;  // in xyz_
  std::vector<Body> bodies_;
};

/// After reach() gave false: says on standard error why `command` cannot go on, and returns its exit code.
int sayStopped(const std::string& command, Simulation& simulation, Progress& progress);

}  // namespace tyg
