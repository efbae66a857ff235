// What people see of gravity: one vector of a scene, which no diet leaves out, since a cloth without weight is another.
#include "core/forces/terms/gravity.h"

#include <array>

#include "core/forces/term.h"

namespace tyg {
namespace {

constexpr std::array kParameters{Parameter{.key = "world.gravity",
                                           .label = "gravity",
                                           .unit = "m/s2",
                                           .count = 3,
                                           .allowed = Allowed::Any,
                                           .get = [](const Scene& scene) { return scene.gravity; },
                                           .set = [](Scene& scene, const Vec3& value) { scene.gravity = value; },
                                           .mostByHand = 100,
                                           .digits = 4}};

}  // namespace

constinit const ForceTerm Gravity::kTerm{
    .name = "gravity", .parameters = kParameters, .mayBeLeftOut = false, .steadyForce = [](const Scene& scene) {
      const double mass = scene.particleMass;
      return Vec3{mass * scene.gravity.x, mass * scene.gravity.y, mass * scene.gravity.z};
    }};

}  // namespace tyg
