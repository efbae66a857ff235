// The bounds of a cloth's motion: where it is and where it will swing to, so that the first view shows all of it and
// the bodies that it meets.
// Must not know: the camera, windows.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <vector>

#include "tyg/simulation.h"
#include "view/box.h"

namespace tyg {

/// Points around the bodies and everything that the cloth of this scene, now within `box`, reaches in its first
/// seconds. A trial run finds them; it ends early where simulating takes a noticeable time by this clock (s).
std::vector<glm::vec3> motionBounds(const Simulation& simulation, const Box& box, const Settings& settings,
                                    const std::function<double()>& clock);

}  // namespace tyg
