// The mistakes that programs of cloth make, one entry each: what it is called, what to do about it, and how to make it.
// Must not know: methods, motions that were handed in.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "study/check/student_program.h"

namespace tyg {

/// An entry of the table. Everything that looks for mistakes, and every test of that, loops over the table.
struct Mistake {
  std::string_view name;  ///< as reports and scripts write it
  std::string_view with;  ///< completes "these are leapfrog's positions ..."
  std::string_view cure;  ///< one sentence that a student can act on
  /// What of a model it changes: of two mistakes of one kind only one can be made.
  enum class Kind { Gravity, Mass, Count, Structural, Shear, Bend, Damping, Pins, Order, Push } kind;
  void (*edit)(Scene& scene) = nullptr;     ///< makes it in a scene; null where no scene can have it
  void (*spoil)(Habits& habits) = nullptr;  ///< makes it in a program of the student's kind; null where a scene can
};
std::span<const Mistake> mistakes();

/// A scene and the habits of the program that runs it, with none, one or several mistakes.
struct Model {
  Scene scene;
  Habits habits;
  std::vector<const Mistake*> made;  ///< in the order of the table

  /// Whether a scene holds it all, so that Tyg's own methods can run it.
  [[nodiscard]] bool isScene() const { return habits == Habits{}; }
  /// The names of the mistakes with " and " between; empty where there are none.
  [[nodiscard]] std::string names() const;
};
/// The model with one more mistake. Nothing changes where the mistake makes no difference to this scene, or where its
/// scene has what a program of the student's kind cannot do; `made` then stays as it was.
Model withMistake(Model model, const Mistake& mistake);

}  // namespace tyg
