// The motion that errors are measured against, how far it can be trusted, and how strongly the cloth itself amplifies a
// small disturbance (docs/model.md, section 7). Must not know: the methods under study, clocks.
#pragma once

#include <functional>
#include <vector>

#include "study/motion/bulk.h"

namespace tyg {

/// The least error (m) of a sheet of this size (m) that means something: the larger of how far two references disagree
/// (m) and of what the largest amplification so far makes of one rounding error; at most the size.
double errorFloor(double size, double amplification, double disagreement, Precision precision);
/// Whether an error means something above such a floor: ten of them must fit into it.
inline bool meansSomething(double error, double floor) { return floor < error / 10; }

/// A scene's motion by an adaptive method of high order with a tolerance of 1e-13 of the sheet's size (more where less
/// is asked for, see ReferenceAim), in double, and what is known about its own error. Everything by sample time, at
/// least 20 of them.
struct Reference {
  Scene scene;      ///< as it was run
  double size = 0;  ///< of the sheet, m
  SampledMotion motion;
  double secondStep = 0;  ///< s, of the classical Runge-Kutta method that gave the second opinion
  /// Largest distance (m, RMS over particles) so far between the two. Empty where the second opinion failed.
  std::vector<double> disagreement;
  /// A: how far a twin that starts a billionth of the size away has gone from here, over its start distance. Past
  /// kTwinLost it is a lower bound: the twin then has gone a thousandth of the size, too far to tell of small errors.
  std::vector<double> amplification;
  static constexpr double kTwinLost = 1e6;
  std::vector<Bulk> bulk, twinBulk;  ///< of the reference and of the twin, whose run may have failed before the end
  bool stopped = false;              ///< by the observer

  /// Is it complete, with a second opinion?
  [[nodiscard]] bool usable() const;
  /// Where it is not: which of the two methods failed, and how.
  [[nodiscard]] std::string whyUnusable() const;
  /// errorFloor() up to a sample time.
  [[nodiscard]] double floorAt(std::size_t sample, Precision precision) const;
  /// The same over the whole run.
  [[nodiscard]] double floorOf(Precision precision) const { return floorAt(motion.times.size() - 1, precision); }
  /// How far a motion as a whole is from the reference after its horizon (s).
  [[nodiscard]] BulkDistance distanceAfter(double horizon, const SampledMotion& run) const;
  /// The twin's own distance there. While the twin is not lost its spread is in proportion to its start: rounding units
  /// larger than that make the band as many times wider.
  [[nodiscard]] BulkDistance bandAfter(double horizon, Precision precision) const;
  /// T*: the last sample time (s) whose floor is below a tenth of this error (m); 0 where there is none.
  [[nodiscard]] double horizonOf(double error, Precision precision) const;
};

/// How exact a reference is made. One that need not be as exact as can be costs less.
struct ReferenceAim {
  double tolerance = 0;  ///< m, of the adaptive method; kept between 1e-13 (as is 0) and 1e-11 of the sheet's size
  double agreement = 0;  ///< m: the second opinion gets no closer than this, nor than half the tolerance
  /// A run of this scene by dopri54 in double at that very tolerance and at sampleTimes(), if there is one: not run
  /// again.
  const SampledMotion* motion = nullptr;
  double patience = 8;  ///< the second opinion makes at most so many times the reference's evaluations
};

/// Throws InputError where a scene's springs or dampers hold the adaptive method to steps so small that nobody could
/// wait for an exact motion.
void refuseEndlessReference(const Scene& scene);

/// Computes a scene's reference over its whole duration. Throws InputError as refuseEndlessReference() does. `observer`
/// gets the fraction done and may return false to stop.
Reference makeReference(const Scene& scene, int threads, const std::function<bool(double fraction)>& observer,
                        const ReferenceAim& aim = {});

/// The same scene, every free particle moved by the same small random displacements each time: `distance` m RMS over
/// all particles.
Scene twinOf(Scene scene, double distance);

}  // namespace tyg
