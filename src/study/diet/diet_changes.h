// The ways to make a scene leaner, one change each.
// Must not know: what a change costs or loses.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "tyg/method.h"
#include "tyg/scene.h"

namespace tyg {

enum class Change { Structural, Shear, Bend, SpringDamping, Drag, HalfSheet, Float, Step, Method };
inline constexpr std::array kChanges{Change::Structural,    Change::Shear, Change::Bend,
                                     Change::SpringDamping, Change::Drag,  Change::HalfSheet,
                                     Change::Float,         Change::Step,  Change::Method};

/// A scene with one change made, and the change in words, such as `no bend` or `sheet 10x10`.
struct Changed {
  std::string words;
  Scene scene;
};

/// The scenes that a change can make of one: none where it does not apply, one, or several to choose from. Steps come
/// from short to long: doubled as often as the method's limit at rest allows, then up to 0.95 of that limit; the first
/// one comes even where it is past the limit. Adaptive methods get ten times the tolerance. Methods come at the scene's
/// step, or at 0.95 of their own limit where that is shorter; those that refuse the scene are left out.
std::vector<Changed> changesOf(const Scene& scene, Change change);

/// May a change be made again on top of itself?
bool repeats(Change change);

/// How much of its limit at rest a method may use where a study chooses the step.
inline constexpr double kShareOfLimit = 0.95;

/// May a study recommend a method? Not the one that is kept to show a mistake: its results depend on the unit of time.
bool advisable(const Method& method);

}  // namespace tyg
