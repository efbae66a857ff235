// What of a scene can change while its cloth moves: springs, gravity, drag, tolerance.
// Must not know: particles, methods, who changes it.
#pragma once

#include <vector>

#include "tyg/push_log.h"
#include "tyg/scene.h"

namespace tyg {

/// That part of a scene; fields as there.
struct World {
  SpringFamily structural, shear, bend;
  Vec3 gravity;
  double drag = 0, tolerance = 0;
  bool operator==(const World&) const = default;
};
World worldOf(const Scene& scene);
void setWorld(Scene& scene, const World& world);

/// The deeds that turn one into the other, without their ticks.
std::vector<LogEvent> changesBetween(const World& from, const World& to);
/// Does such a deed; one of another kind does nothing.
void change(World& world, const LogEvent& deed);

}  // namespace tyg
