// The methods that the graphics card knows, each as a sequence of passes over the sheet. The passes compute what the
// method's own file in src/integrators says, with the same operations. Must not know: scenes, where fields lie.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "gpu/card_sheet.h"

namespace tyg {

struct Scheme {
  std::string_view method;  ///< its name
  bool keepsForce = false;  ///< is the last force of a step the first of the next one?
  /// The times (s) of all evaluations of `count` steps, in order; `hasForce`: the first force is kept from before.
  std::vector<double> (*times)(const StepTimes& steps, int count, bool hasForce);
  /// The steps. The state is in Field::X and Field::V before and after, a kept force in Field::Force.
  void (*run)(CardSheet& sheet, double h, double inverseMass, int count, bool hasForce);
  /// Counts the evaluations and, with the method's own weights, the power in each of them.
  void (*account)(Forces<float>& forces, std::span<const Power> powers, double h, bool hasForce);
};

std::span<const Scheme> schemes();

}  // namespace tyg
