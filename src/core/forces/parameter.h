// The numbers of the model that a scene may name and that may change while the cloth moves: their keys, units and
// ranges. Reader, writer, event log, Control panel and diet loop over them.
// Must not know: how forces are computed, who changes what.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "tyg/scene.h"

namespace tyg {

/// What the numbers of a parameter may be, besides finite.
enum class Allowed { Any, NotNegative, Positive };

/// What a parameter does to the motion, for methods that keep something that depends on it.
enum class Role { Other, Stiffness, Damping };

/// One number, or one vector, of a scene.
struct Parameter {
  std::string_view key;  ///< as scene files and event logs write it, for example `springs.shear.ks` or `world.gravity`
  std::string_view label;           ///< as panels and messages write it
  std::string_view unit;            ///< SI
  int count;                        ///< of numbers: 1, or 3 for a vector
  Allowed allowed;                  ///< for each of them
  Vec3 (*get)(const Scene& scene);  ///< a single number is x
  void (*set)(Scene& scene, const Vec3& value);
  Role role = Role::Other;
  bool required = false;                         ///< where a scene has the table of its term
  bool decidesPresence = true;                   ///< 0 leaves the term out; false: it only says how the term acts
  bool (*acts)(const Scene& scene) = nullptr;    ///< whether it does anything there; null: wherever its term does
  bool (*exists)(const Scene& scene) = nullptr;  ///< whether the scene has what it is a number of; null: always
  /// What the scene calls it; null or empty: the label.
  std::string_view (*nameIn)(const Scene& scene) = nullptr;
  bool isSpeed = false;  ///< a vector that people set by its size and its direction
  bool ofList = false;   ///< of the first table of a list such as [[wind]], which scene files have besides the term
  bool isShareOfSheet = false;  ///< a particle's share of what the whole sheet has, as its mass is
  double mostByHand = 0;        ///< the largest size that a panel lets a person set, > 0 for terms
  int digits = 0;               ///< that a panel shows
};

/// Every parameter, in the order of a scene file: those of the force terms, then `run.tolerance`.
std::span<const Parameter> liveParameters();
/// Null where there is no parameter of that key.
const Parameter* findParameter(std::string_view key);

/// The scene's values of all parameters of one role: where these are the same, so is what depends on them.
std::vector<Vec3> valuesOf(const Scene& scene, Role role);

}  // namespace tyg
