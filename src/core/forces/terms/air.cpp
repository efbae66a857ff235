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
  moment.blowing.clear();
  for (const Wind& wind : scene.winds) {
    Blowing<T> blowing;
    const std::array<double, 3> velocity{wind.velocity.x, wind.velocity.y, wind.velocity.z};
    const std::array<double, 3> gust{wind.gust.x, wind.gust.y, wind.gust.z};
    const double speed = length(wind.velocity);
    blowing.hasGust = wind.gust != Vec3{} && wind.wavelength > 0 && speed > 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      blowing.velocity[axis] = T(velocity[axis]), blowing.gust[axis] = T(gust[axis]);
      if (blowing.hasGust) blowing.wave[axis] = T(velocity[axis] / speed / wind.wavelength);
    }
    // In double, and then only what is left of whole periods: float could not tell late times apart.
    const double periods = blowing.hasGust ? speed * time / wind.wavelength : 0;
    blowing.phase = T(periods - std::floor(periods));
    moment.blowing.push_back(blowing);
  }
  numbers.firstBlowing = moment.blowing.data();
  numbers.endBlowing = moment.blowing.data() + moment.blowing.size();
}
template void AirTerm::setMoment(const Scene&, double, Moment<float>&, Numbers<float>&);
template void AirTerm::setMoment(const Scene&, double, Moment<double>&, Numbers<double>&);

constinit const ForceTerm AirTerm::kTerm{
    .name = "air", .parameters = kParameters, .cellDamping = dampingOfCells, .canSupply = [](const Scene& scene) {
      return scene.air.density > 0 && !scene.winds.empty();
    }};

}  // namespace tyg
