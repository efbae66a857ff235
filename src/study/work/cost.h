// What work costs on this machine: seconds for one unit of a method's work, measured in short bursts that take turns
// with a yardstick, so that a busy machine does not decide. Must not know: what the prices are for, which clock it is.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "study/motion/sampled_motion.h"
#include "tyg/method.h"

namespace tyg {

/// Units of work of a run: its force evaluations, or its steps for a method that makes none.
std::int64_t workOf(const Method& method, const SampledMotion& run);

/// What a force evaluation of a scene's grid, terms and precision costs, counted instead of measured: in springs, of
/// which a particle counts as two, its drag and the damping of a spring as half a one, a body that it may touch as one
/// to three and its friction as three quarters, and everything 0.6 times in float.
double countedCost(const Scene& scene);

/// Seconds that one unit of work of a scene takes, by the scene's own method, step, precision, grid and terms.
using UnitCost = std::function<double(const Scene& scene, int threads)>;

/// A device that may do work in place of the processor, with the same bits.
struct DeviceOffer {
  std::shared_ptr<Device> device{};  ///< null: there is none
  UnitCost cost{};                   ///< there; infinite where it does not take the scene
};

/// Of one unit of work, s, where it costs least.
struct Price {
  double seconds = 0;
  std::shared_ptr<Device> device{};  ///< that does it; null: the processor
  double elsewhere = 0;              ///< s on the other of the two; infinite where there is none, or it cannot
};
Price cheapestPrice(const UnitCost& processor, const DeviceOffer& offer, const Scene& scene, int threads);

/// Measures unit costs. Each is measured once and kept: the next question of the same kind gets the same answer.
class CostMeter {
 public:
  /// s from any start, for work on so many threads. For one thread it had better be the time that the thread itself has
  /// computed: other programs then do not count.
  using Clock = std::function<double(int threads)>;

  /// `yardstick` is what all others take turns with, on `threads` threads.
  CostMeter(Scene yardstick, int threads, Clock clock);

  /// s for one unit; `scene.integrator` must name a method that takes the scene (else InputError).
  /// On a device, where one is given, it is by the clock's time for two threads at least: a device works beside this
  /// thread. Throws InputError where the device does not take the scene.
  double secondsPerUnit(const Scene& scene, int threads, const std::shared_ptr<Device>& device = nullptr);

 private:
  double measured(const Scene& scene, int threads, const std::shared_ptr<Device>& device);

  Scene yardstick_;
  int threads_;
  Clock clock_;
  double yardstickSeconds_ = 0;
  std::map<std::string, double> known_;
};

}  // namespace tyg
