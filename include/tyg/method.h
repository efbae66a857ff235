// What is known of a time integration method, which moves a sheet: its names, its order, its cost, its stability limit.
// Fourth of the headers to read. Must not know: how a method computes a step.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "tyg/scene.h"
#include "tyg/sheet.h"

namespace tyg {

template <class T>
class Integrator;

/// What a study found out about the step limit of a method on one scene.
struct LimitFinding {
  bool damped = false;     ///< did the scene keep its damping?
  bool byDamping = false;  ///< is it damping that sets the limit, and not stiffness?
  double predicted = 0;    ///< s; 0 where no step is stable; NaN where no mode of the sheet sets a limit
  double w2 = 0;           ///< stiffness of the mode that fails first, 1/s2
  double seconds = 0;      ///< length of the scene's own motion, s
  double survived = 0;     ///< largest step that this motion survived, s; NaN where that was not measured
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
  /// The same for a particle that something holds, such as contact, where the method treats that damping in another way
  /// than the springs'; null: in the same way.
  double (*stableStepWhereHeld)(double w2, double d) = nullptr;
  /// The same for all modes of a scene's sheet at rest at once, for methods that adapt to the whole spectrum; else
  /// null.
  double (*stableStepOfScene)(const Scene& scene) = nullptr;
  /// Of a method that has no limit: why, as the end of the sentence "it has no limit: ...". Empty for the others.
  std::string_view whyNoLimit{};
  /// What people have to know about a limit besides its numbers, a sentence that begins with the method's name; empty
  /// where there is nothing to say. Null where there never is.
  std::string (*noteOnLimit)(const LimitFinding& finding) = nullptr;
  bool solves = false;    ///< does a step cost much besides its force evaluations, as solves and sweeps do?
  bool advisable = true;  ///< may advice and diets recommend it?
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
