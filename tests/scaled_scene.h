// The same cloth in other units of length, mass and time. With powers of two every number of a run is the same but for
// its exponent, so that results are compared to the last bit.
#pragma once

#include "test_systems.h"

namespace tyg::test {

struct Units {
  double length = 1, mass = 1, time = 1;
};

/// Powers of two near 1e-6 and 1e6, one after the other, then all at once.
inline constexpr Units kUnits[] = {{0x1p-20, 1, 1},
                                   {0x1p20, 1, 1},
                                   {1, 0x1p-20, 1},
                                   {1, 0x1p20, 1},
                                   {1, 1, 0x1p-20},
                                   {1, 1, 0x1p20},
                                   {0x1p-20, 0x1p20, 0x1p-20},
                                   {0x1p20, 0x1p-20, 0x1p20}};

inline Scene scaled(Scene scene, const Units& units) {
  const double perTime = units.mass / units.time, stiffness = perTime / units.time;
  const double acceleration = units.length / units.time / units.time, force = units.mass * acceleration;
  scene.spacing *= units.length, scene.particleMass *= units.mass, scene.drag *= perTime;
  for (SpringFamily* family : {&scene.structural, &scene.shear, &scene.bend}) {
    family->ks *= stiffness, family->kd *= perTime;
  }
  scene.gravity = acceleration * scene.gravity;
  for (Displacement& displacement : scene.displacements) displacement.by = units.length * displacement.by;
  for (Push& push : scene.pushes) {
    push.force = force * push.force;
    push.at *= units.time, push.duration *= units.time;
  }
  const double speed = units.length / units.time, volume = units.length * units.length * units.length;
  scene.air.density *= units.mass / volume;
  for (Wind& wind : scene.winds) {
    wind.velocity = speed * wind.velocity, wind.gust = speed * wind.gust;
    wind.wavelength *= units.length, wind.at *= units.time, wind.duration *= units.time;
  }
  for (Move& move : scene.moves) {
    move.velocity = speed * move.velocity;
    move.at *= units.time, move.duration *= units.time;
  }
  scene.contact.stiffness *= stiffness, scene.contact.layer *= units.length, scene.contact.grip *= perTime;
  if (scene.contact.gap) scene.contact.gap = units.length * *scene.contact.gap;
  for (Body& body : scene.bodies) {
    body.at = units.length * body.at, body.axis = units.length * body.axis, body.half = units.length * body.half;
    body.radius *= units.length;
  }
  scene.duration *= units.time, scene.dt *= units.time, scene.tolerance *= units.length;
  return scene;
}

}  // namespace tyg::test
