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
  scene.duration *= units.time, scene.dt *= units.time, scene.tolerance *= units.length;
  return scene;
}

}  // namespace tyg::test
