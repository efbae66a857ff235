// What the ghost panel says: how far apart the two cloths are, what that means, and how far the ghost has come.
// Must not know: how the ghost follows, windows.
#pragma once

#include <string>

#include "viewer/ghost.h"

namespace tyg {

/// For the person; empty where there is nothing to say.
struct Sentence {
  enum class Tone { Plain, Dim, Good, Warning };
  std::string text{};
  Tone tone = Tone::Plain;
};

/// A ghost that is farther than this from the cloth, s, is of another time: the person is told, and does not see it.
constexpr double kNearlyInStep = 0.1;

/// How far apart they are, or were when they last met.
Sentence distanceWords(const Ghost& ghost);
/// What that distance tells.
Sentence meaningWords(const Ghost& ghost);
/// Why the ghost is not where the cloth is.
Sentence progressWords(const Ghost& ghost);

}  // namespace tyg
