// The numbers of the model that a scene may name and that may change while the cloth moves: their keys, units and
// ranges. Reader, writer, event log, Control panel and diet loop over them.
// Must not know: how forces are computed, who changes what.
#pragma once

#include <span>
#include <string_view>

#include "tyg/scene.h"

namespace tyg {

/// What the numbers of a parameter may be, besides finite.
enum class Allowed { Any, NotNegative, Positive };

/// One number, or one vector, of a scene.
struct Parameter {
  std::string_view key;  ///< as scene files and event logs write it, for example `springs.shear.ks` or `world.gravity`
  std::string_view label;           ///< as panels and messages write it
  std::string_view unit;            ///< SI
  int count;                        ///< of numbers: 1, or 3 for a vector
  Allowed allowed;                  ///< for each of them
  Vec3 (*get)(const Scene& scene);  ///< a single number is x
  void (*set)(Scene& scene, const Vec3& value);
};

/// Every parameter, in the order of a scene file: those of the force terms, then `run.tolerance`.
std::span<const Parameter> liveParameters();
/// Null where there is no parameter of that key.
const Parameter* findParameter(std::string_view key);

}  // namespace tyg
