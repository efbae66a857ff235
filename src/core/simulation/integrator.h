// What a time integration method is to the rest of the program: one class with step() and reset(). Must not know:
// scenes, time of day, how forces are computed.
#pragma once

#include <memory>

#include "core/forces/forces.h"
#include "core/forces/state.h"
#include "core/simulation/device_state.h"

namespace tyg {

/// Turns the state at time t into the state at t + h (s). Owns its scratch memory and allocates nothing in step(), but
/// for what a library needs to solve equations and for what a new step length asks.
template <class T>
class Integrator {
 public:
  virtual ~Integrator() = default;
  /// One step of h seconds (> 0). The forces hold constant parameters during the step.
  /// Every force is evaluated at its own time: t for the state, and t plus the stage's share of h for a stage.
  virtual void step(Forces<T>& forces, State<T>& state, double t, double h) = 0;
  /// `count` such steps, 1 to Forces::kMostSteps. The bits are those of step() again and again; methods whose force,
  /// kick and drift fit in one pass over the rows do better.
  virtual void steps(Forces<T>& forces, State<T>& state, const StepTimes& times, int count) {
    for (int k = 0; k < count; ++k) step(forces, state, times.at(k), times.h);
  }
  /// Adaptive methods: one accepted step of at most `most` seconds whose estimated error is within `tolerance` metres
  /// (> 0); returns the step taken. Others take the whole of `most`.
  virtual double stepWithin(Forces<T>& forces, State<T>& state, double t, double most, double /*tolerance*/) {
    step(forces, state, t, most);
    return most;
  }
  /// To be called before the state is read from outside: an integrator that takes its steps on a device may leave the
  /// state there until then.
  virtual void fetch(State<T>& /*state*/) {}
  /// This state on the device that the integrator steps on, valid until the next step; null where there is no device.
  /// Whoever changes a particle from outside changes it there too.
  virtual DeviceState<T>* onDevice(const State<T>& /*state*/) { return nullptr; }
  /// Forgets what was kept from the last step. To be called after every change of the state or of the forces from
  /// outside.
  virtual void reset() {}
  /// Goes on with the parameters of this scene, of the same sheet, exactly as a new integrator of it would. Does anew
  /// only what depends on those that have changed. Throws InputError, and changes nothing, where the method does not
  /// take them.
  virtual void useParameters(const Scene& /*scene*/, const Sheet& /*sheet*/) { reset(); }
  /// A copy with the same memory, for snapshots.
  [[nodiscard]] virtual std::unique_ptr<Integrator> clone() const = 0;
  /// Memory that a copy takes, but for what does not grow with the sheet.
  [[nodiscard]] virtual std::size_t bytes() const = 0;
};

}  // namespace tyg
