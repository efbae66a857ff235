// The room that a cloth needs: where it is and where it will swing to, for the first view of it.
// Must not know: the camera, windows.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <vector>

#include "tyg/simulation.h"
#include "view/box.h"

namespace tyg {

/// Points around all places that the cloth of this scene, now within `box`, gets to in its first seconds, as far as
/// simulating them takes no noticeable time by this clock (s).
std::vector<glm::vec3> roomOf(const Simulation& simulation, const Box& box, const Settings& settings,
                              const std::function<double()>& clock);

}  // namespace tyg
