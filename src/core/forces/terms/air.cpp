// What people and limits see of air and wind.
#include "core/forces/terms/air.h"

#include <array>
#include <cmath>

#include "core/forces/point_math.h"
#include "core/forces/term.h"

namespace tyg {
namespace {

double length(const Vec3& v) { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

constexpr double kUsualWavelength = 1;  // m, of gusts that are given none

Wind firstWind(const Scene& scene) { return scene.winds.empty() ? Wind{} : scene.winds.front(); }

/// Gusts travel with a wind.
bool hasWind(const Scene& scene) { return firstWind(scene).velocity != Vec3{}; }

/// Without air a wind blows nothing, but may still be taken away.
bool hasAirOrWind(const Scene& scene) { return scene.air.density > 0 || !scene.winds.empty(); }

/// Changes the first wind so that a scene file could have it: there is none where it is nothing, and no gust without
/// both a velocity and a wavelength. Set in the order of the table, the values of any such wind come back.
template <class Change>
void setFirstWind(Scene& scene, const Change& change) {
  const Wind before = firstWind(scene);
  Wind wind = before;
  change(wind);
  if (wind == before) return;
  const bool losesGust = (wind.velocity == Vec3{} && before.velocity != Vec3{}) || wind.wavelength == 0;
  if (losesGust) wind.gust = {};
  if (scene.winds.empty()) scene.winds.emplace_back();
  scene.winds.front() = wind;
  if (scene.winds.size() == 1 && wind == Wind{}) scene.winds.clear();
}

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
              .label = "coefficient",
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
              .digits = 2},
    Parameter{
        .key = "wind.velocity",
        .label = "wind",
        .unit = "m/s",
        .count = 3,
        .allowed = Allowed::Any,
        .get = [](const Scene& scene) { return firstWind(scene).velocity; },
        .set = [](Scene& scene, const Vec3& value) { setFirstWind(scene, [&](Wind& wind) { wind.velocity = value; }); },
        .decidesPresence = false,
        .exists = hasAirOrWind,
        .isSpeed = true,
        .ofList = true,
        .mostByHand = 30,
        .digits = 3},
    Parameter{.key = "wind.wavelength",
              .label = "gust length",
              .unit = "m",
              .count = 1,
              .allowed = Allowed::NotNegative,
              .get =
                  [](const Scene& scene) {
                    return Vec3{firstWind(scene).wavelength, 0, 0};
                  },
              .set = [](Scene& scene,
                        const Vec3& value) { setFirstWind(scene, [&](Wind& wind) { wind.wavelength = value.x; }); },
              .decidesPresence = false,
              .acts = hasWind,
              .exists = hasAirOrWind,
              .ofList = true,
              .mostByHand = 30,
              .digits = 3},
    Parameter{.key = "wind.gust",
              .label = "gusts",
              .unit = "m/s",
              .count = 3,
              .allowed = Allowed::Any,
              .get = [](const Scene& scene) { return firstWind(scene).gust; },
              .set =
                  [](Scene& scene, const Vec3& value) {
                    setFirstWind(scene, [&](Wind& wind) {
                      wind.gust = value;
                      if (value != Vec3{} && wind.wavelength == 0) wind.wavelength = kUsualWavelength;
                    });
                  },
              .decidesPresence = false,
              .acts = hasWind,
              .exists = hasAirOrWind,
              .ofList = true,
              .mostByHand = 30,
              .digits = 3}};

/// N s/m against a cell's motion along its normal, with the fastest wind of the scene.
double dampingOfCells(const Scene& scene) {
  double fastest = 0;
  for (const Wind& wind : scene.winds) fastest += length(wind.velocity) + length(wind.gust);
  return scene.air.density * scene.air.coefficient * scene.spacing * scene.spacing * fastest;
}

}  // namespace

template <class T>
void AirTerm::setMoment(const Scene& /*scene*/, const Acting& acting, double time, Moment<T>& moment,
                        Numbers<T>& numbers) {
  moment.gusts.clear();
  std::array<double, 3> steady{};
  for (const Wind& wind : acting.winds) {
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
template void AirTerm::setMoment(const Scene&, const Acting&, double, Moment<float>&, Numbers<float>&);
template void AirTerm::setMoment(const Scene&, const Acting&, double, Moment<double>&, Numbers<double>&);

Vec3 windAt(const Scene& scene, double time, const Vec3& place) {
  if (!(scene.air.density > 0)) return {};
  Acting blowing{.winds = scene.winds};
  std::erase_if(blowing.winds, [&](const Wind& wind) { return time < wind.at || time >= wind.at + wind.duration; });
  AirTerm::Moment<double> moment;
  AirTerm::Numbers<double> numbers;
  AirTerm::setMoment(scene, blowing, time, moment, numbers);
  Point<double> sum = PointMath<double>::all3(numbers.steady);
  for (const auto& gusts : moment.gusts) {
    sum = sum + AirTerm::gustOf(PointMath<double>(), gusts, Point<double>{place.x, place.y, place.z});
  }
  return {sum.x, sum.y, sum.z};
}

constinit const ForceTerm AirTerm::kTerm{
    .name = "air", .parameters = kParameters, .cellDamping = dampingOfCells, .canSupply = [](const Scene& scene) {
      return scene.air.density > 0 && !scene.winds.empty();
    }};

}  // namespace tyg
