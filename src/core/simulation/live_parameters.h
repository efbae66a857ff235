// The live parameters of a scene: the numbers of core/forces/parameter.h, which may change while its cloth moves.
// Must not know: particles, methods, who changes them.
#pragma once

#include <vector>

#include "tyg/event_log.h"
#include "tyg/scene.h"

namespace tyg {

/// Their values, in the order of liveParameters().
std::vector<Vec3> liveValues(const Scene& scene);
void setLiveValues(Scene& scene, const std::vector<Vec3>& values);
/// Whether two scenes have the same ones. Allocates nothing.
bool sameLiveParameters(const Scene& first, const Scene& second);
/// Gives `to` those of `from`. Allocates nothing.
void copyLiveParameters(const Scene& from, Scene& to);
/// The events that turn those of one scene into those of the other.
std::vector<WorldEvent> changesBetween(const Scene& from, const Scene& to);

}  // namespace tyg
