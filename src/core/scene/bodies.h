// What a scene's bodies need besides what its file says: the numbers that follow from the sheet, and what does not fit.
// Must not know: files, how forces are computed.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "tyg/scene.h"

namespace tyg {

/// The largest m w^2 of the sheet at rest, taken as unbounded, from the closed form of docs/model.md, section 8, N/m; 0
/// without springs.
double largestStiffness(const Scene& scene);

/// Whether there are bodies that the cloth touches.
bool touchesBodies(const Scene& scene);

/// What is wrong with a body beside the other numbers of its scene.
struct UnfitBody {
  std::size_t body = 0;  ///< its place in Scene::bodies
  std::string_view key;  ///< that is wrong
  std::string found, allowed;
};
std::optional<UnfitBody> unfitBody(const Scene& scene);
/// Throws InputError where a body does not fit the sheet, or where the contact lacks a number.
void refuseUnfitBodies(const Scene& scene);
/// Whether the bodies that are touched fit the sheet, which may have become coarser.
bool fitsBodies(const Scene& scene);

/// `ball`, `box`, ...
std::string_view nameOf(Shape shape);
/// A body as people call it: its name, or else its shape, with its number among the bodies where there are several of
/// that shape: `table`, `ball`, `ball 2`.
std::string wordsFor(const Scene& scene, std::size_t body);
/// What the cloth touches: `the ball` where there is one body, else `the bodies`.
std::string bodiesInWords(const Scene& scene);

/// The scene without this body and its motions; without its last one there is no contact either.
Scene withoutBody(Scene scene, std::size_t body);
Scene withoutBodies(Scene scene);

/// The largest tolerance (m) at which a method that chooses its own steps meets bodies as they are; infinite where
/// nothing is touched.
double largestTolerance(const Scene& scene);
/// The tolerance (m) that such a method keeps: the scene's, as far as the bodies allow it.
double usedTolerance(const Scene& scene);
/// The largest one in words, for what is allowed.
std::string largestToleranceInWords(const Scene& scene);
/// The step (s) that a method of its own choice may take at this speed (m/s) and acceleration (m/s2) without leaping
/// over a body: half of the smallest radius is all that a particle may move. Infinite where nothing is touched.
double stepThatMeetsBodies(const Scene& scene, double speed, double acceleration);

}  // namespace tyg
