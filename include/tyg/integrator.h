// What a time integration method is to the rest of the program: one class with step() and reset(), one entry in a
// table. Must not know: scenes, time of day, how forces are computed.
#pragma once

#include <memory>
#include <string_view>

#include "tyg/forces.h"
#include "tyg/state.h"

namespace tyg {

/// Turns the state at t into the state at t + h. Owns its scratch memory and allocates nothing in step(), but for what
/// a library needs to solve equations and for what a new step length asks.
template <class T>
class Integrator {
 public:
  virtual ~Integrator() = default;
  /// One step of h seconds (> 0). The forces hold constant parameters during the step.
  virtual void step(Forces<T>& forces, State<T>& state, double h) = 0;
  /// `count` such steps, 1 to Forces::kMostSteps. The bits are those of step() again and again; methods whose force,
  /// kick and drift fit in one pass over the rows do better.
  virtual void steps(Forces<T>& forces, State<T>& state, double h, int count) {
    for (int k = 0; k < count; ++k) step(forces, state, h);
  }
  /// Adaptive methods: one accepted step of at most `most` seconds whose estimated error is within `tolerance` metres
  /// (> 0); returns the step taken. Others take the whole of `most`.
  virtual double stepWithin(Forces<T>& forces, State<T>& state, double most, double /*tolerance*/) {
    step(forces, state, most);
    return most;
  }
  /// Forgets what was kept from the last step. Whoever edits the state or the forces calls this.
  virtual void reset() {}
  /// A copy with the same memory, for snapshots.
  [[nodiscard]] virtual std::unique_ptr<Integrator> clone() const = 0;
  /// Memory that a copy takes, but for what does not grow with the sheet.
  [[nodiscard]] virtual std::size_t bytes() const = 0;
};

/// An entry of the table of methods. Everything that lists methods (command line, tests, charts) loops over that table.
struct Method {
  std::string_view name;       ///< as scenes and the command line write it
  std::string_view label;      ///< as charts and the window write it
  std::string_view scheme;     ///< one line: the formula
  int order;                   ///< of convergence, for smooth forces
  int evaluationsPerStep;      ///< force evaluations of one step; -1 where it varies with the step
  int evaluationsAtStart = 0;  ///< more of them in the first step, and after every reset
  bool adaptive = false;       ///< chooses its own steps within a scene's tolerance; dt is then not used
  /// Largest stable step in seconds for the mode x'' + d x' + w2 x = 0 (w2 in 1/s2, d in 1/s, both >= 0): infinite
  /// where every step is stable, 0 where none is. Null where the method has no limit, or none that a single mode sets.
  double (*stableStep)(double w2, double d) = nullptr;
  /// The same for all modes of a scene's sheet at rest at once, for methods that adapt to the whole spectrum; else
  /// null.
  double (*stableStepOfScene)(const Scene& scene) = nullptr;
  std::unique_ptr<Integrator<float>> (*makeFloat)(const Scene& scene, const Sheet& sheet);
  std::unique_ptr<Integrator<double>> (*makeDouble)(const Scene& scene, const Sheet& sheet);

  template <class T>
  [[nodiscard]] std::unique_ptr<Integrator<T>> make(const Scene& scene, const Sheet& sheet) const {
    if constexpr (sizeof(T) == sizeof(float)) {
      return makeFloat(scene, sheet);
    } else {
      return makeDouble(scene, sheet);
    }
  }
};

}  // namespace tyg
