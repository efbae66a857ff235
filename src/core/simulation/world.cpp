// See world.h. Everything that can change is three numbers at most, which a log keeps where it keeps a push's force.
#include "core/simulation/world.h"

#include <array>

namespace tyg {
namespace {

using Kind = LogEvent::Kind;

constexpr std::array kKinds{Kind::Structural, Kind::Shear, Kind::Bend, Kind::Gravity, Kind::Drag, Kind::Tolerance};

Vec3 valuesOf(const World& world, Kind kind) {
  const auto family = [](const SpringFamily& springs) { return Vec3{springs.ks, springs.kd, 0}; };
  switch (kind) {
    case Kind::Structural:
      return family(world.structural);
    case Kind::Shear:
      return family(world.shear);
    case Kind::Bend:
      return family(world.bend);
    case Kind::Gravity:
      return world.gravity;
    case Kind::Drag:
      return {world.drag, 0, 0};
    default:
      return {world.tolerance, 0, 0};
  }
}

}  // namespace

World worldOf(const Scene& scene) {
  return {scene.structural, scene.shear, scene.bend, scene.gravity, scene.drag, scene.tolerance};
}

void setWorld(Scene& scene, const World& world) {
  scene.structural = world.structural, scene.shear = world.shear, scene.bend = world.bend;
  scene.gravity = world.gravity;
  scene.drag = world.drag, scene.tolerance = world.tolerance;
}

std::vector<LogEvent> changesBetween(const World& from, const World& to) {
  std::vector<LogEvent> changes;
  for (const Kind kind : kKinds) {
    const Vec3 values = valuesOf(to, kind);
    if (values != valuesOf(from, kind)) changes.push_back({.kind = kind, .force = values});
  }
  return changes;
}

void change(World& world, const LogEvent& deed) {
  const SpringFamily springs{deed.force.x, deed.force.y};
  switch (deed.kind) {
    case Kind::Structural:
      world.structural = springs;
      return;
    case Kind::Shear:
      world.shear = springs;
      return;
    case Kind::Bend:
      world.bend = springs;
      return;
    case Kind::Gravity:
      world.gravity = deed.force;
      return;
    case Kind::Drag:
      world.drag = deed.force.x;
      return;
    case Kind::Tolerance:
      world.tolerance = deed.force.x;
      return;
    default:
      return;
  }
}

}  // namespace tyg
