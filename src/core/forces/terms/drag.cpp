// What people and limits see of drag: one number, which resists every motion of a particle alike. A particle of another
// grid of the same cloth gets its share of the whole sheet's.
#include "core/forces/terms/drag.h"

#include <array>

#include "core/forces/term.h"

namespace tyg {
namespace {

constexpr std::array kParameters{Parameter{.key = "world.drag",
                                           .label = "drag",
                                           .unit = "N s/m",
                                           .count = 1,
                                           .allowed = Allowed::NotNegative,
                                           .get =
                                               [](const Scene& scene) {
                                                 return Vec3{scene.drag, 0, 0};
                                               },
                                           .set = [](Scene& scene, const Vec3& value) { scene.drag = value.x; },
                                           .role = Role::Damping,
                                           .isShareOfSheet = true,
                                           .mostByHand = 1,
                                           .digits = 3}};

}  // namespace

constinit const ForceTerm Drag::kTerm{
    .name = "drag", .parameters = kParameters, .particleDamping = [](const Scene& scene) { return scene.drag; }};

}  // namespace tyg
