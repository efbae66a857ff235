// The steps or tolerances at which a method is studied.
// Must not know: results, clocks.
#pragma once

#include <vector>

#include "tyg/method.h"
#include "tyg/scene.h"

namespace tyg {

/// One setting of a method.
struct Rung {
  double dt = 0;         ///< s
  double tolerance = 0;  ///< m; 0 for methods of fixed steps
};

/// The rungs from coarse to fine, more of them than anyone can wait for. A fixed-step method starts at twice its stable
/// limit, goes down by sqrt(2) to below it and then by 2, in steps that divide the time between samples. An adaptive
/// method goes through the powers of ten from about a hundredth of the sheet's size down to a millionth of a millionth
/// of it; where bodies are touched, only through those that they allow.
std::vector<Rung> ladderOf(const Scene& scene, const Method& method);

}  // namespace tyg
