// The ways to make a scene leaner, one change each.
// Must not know: what a change costs or loses.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/forces/term.h"
#include "tyg/method.h"
#include "tyg/scene.h"

namespace tyg {

/// One of the bodies of a scene.
struct BodyOfScene {
  Body body{};
  std::size_t index = 0;  ///< its place in Scene::bodies
  std::string words;      ///< as people call it there
  bool operator==(const BodyOfScene&) const = default;
};

/// A way to make a scene leaner.
struct Change {
  enum Kind {
    LeaveOut,
    SpringDamping,
    OneBody,
    Friction,
    ContactDamping,
    StillAir,
    SteadyWind,
    HalfSheet,
    Float,
    Step,
    Method
  };
  Kind kind = LeaveOut;
  const ForceTerm* term = nullptr;  ///< LeaveOut: which
  BodyOfScene body{};               ///< OneBody: which is left out, with its motions
  bool operator==(const Change&) const = default;
};
/// All of them that a scene may have: each term that may be left out, each of its bodies, and what does not depend on
/// terms.
std::vector<Change> allChanges(const Scene& scene);

/// A scene with one change made, and the change in words, such as `no bend` or `sheet 10x10`.
struct Changed {
  std::string words;
  Scene scene;
};

/// The scenes that a change can make of one: none where it does not apply, one, or several to choose from. Steps come
/// from short to long: doubled as often as the method's limit at rest allows, then up to 0.95 of that limit; the first
/// one comes even where it is past the limit. Adaptive methods get ten times the tolerance, where bodies allow that.
/// Methods come at the scene's step, or at 0.95 of their own limit where that is shorter; those that refuse the scene
/// are left out. A sheet that is too coarse for its bodies is none.
std::vector<Changed> changesOf(const Scene& scene, const Change& change);

/// May a change be made again on top of itself?
bool repeats(const Change& change);

/// How much of its limit at rest a method may use where a study chooses the step.
inline constexpr double kShareOfLimit = 0.95;

}  // namespace tyg
