// What people and limits see of air and wind.
#include "core/forces/terms/air.h"

#include <array>
#include <cmath>

#include "core/forces/term.h"

namespace tyg {
namespace {

double length(const Vec3& v) { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

constexpr std::array kParameters{
    Parameter{.key = "air.density",
              .label = "air density",
              .unit = "kg/m3",
              .count = 1,
              .allowed = Allowed::NotNegative,
              .get =
                  [](const Scene& scene) {
                    return Vec3{scene.air.density, 0, 0};
                  },
              .set = [](Scene& scene, const Vec3& value) { scene.air.density = value.x; },
              .role = Role::Damping,
              .required = true,
              .mostByHand = 10,
              .digits = 2},
    Parameter{.key = "air.coefficient",
              .label = "drag coefficient",
              .unit = "1",
              .count = 1,
              .allowed = Allowed::NotNegative,
              .get =
                  [](const Scene& scene) {
                    return Vec3{scene.air.coefficient, 0, 0};
                  },
              .set = [](Scene& scene, const Vec3& value) { scene.air.coefficient = value.x; },
              .decidesPresence = false,
              .mostByHand = 3,
              .digits = 2}};

/// N s/m against a cell's motion along its normal, with the fastest wind of the scene.
double dampingOfCells(const Scene& scene) {
  double fastest = 0;
  for (const Wind& wind : scene.winds) fastest += length(wind.velocity) + length(wind.gust);
  return scene.air.density * scene.air.coefficient * scene.spacing * scene.spacing * fastest;
}

}  // namespace

template <class T>
void AirTerm::setMoment(const Scene& scene, double time, Moment<T>& moment, Numbers<T>& numbers) {
  moment.gusts.clear();
  std::array<double, 3> steady{};
  for (const Wind& wind : scene.winds) {
    const std::array<double, 3> velocity{wind.velocity.x, wind.velocity.y, wind.velocity.z};
    const std::array<double, 3> gust{wind.gust.x, wind.gust.y, wind.gust.z};
    for (std::size_t axis = 0; axis < 3; ++axis) steady[axis] += velocity[axis];
    const double speed = length(wind.velocity);
    if (wind.gust == Vec3{} || !(wind.wavelength > 0) || !(speed > 0)) continue;
    Gusts<T>& gusts = moment.gusts.emplace_back();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      gusts.amplitude[axis] = T(gust[axis]);
      gusts.wave[axis] = T(velocity[axis] / speed / wind.wavelength);
    }
    // In double, and then only what is left of whole periods: float could not tell late times apart.
    const double periods = speed * time / wind.wavelength;
    gusts.phase = T(periods - std::floor(periods));
  }
  for (std::size_t axis = 0; axis < 3; ++axis) numbers.steady[axis] = T(steady[axis]);
  numbers.firstGusts = moment.gusts.data();
  numbers.endGusts = moment.gusts.data() + moment.gusts.size();
}
template void AirTerm::setMoment(const Scene&, double, Moment<float>&, Numbers<float>&);
template void AirTerm::setMoment(const Scene&, double, Moment<double>&, Numbers<double>&);

constinit const ForceTerm AirTerm::kTerm{
    .name = "air", .parameters = kParameters, .cellDamping = dampingOfCells, .canSupply = [](const Scene& scene) {
      return scene.air.density > 0 && !scene.winds.empty();
    }};

}  // namespace tyg
