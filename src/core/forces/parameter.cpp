// The table of live parameters.
#include "core/forces/parameter.h"

#include <algorithm>
#include <array>

namespace tyg {
namespace {

template <SpringFamily Scene::*family, double SpringFamily::*number>
Vec3 getOfFamily(const Scene& scene) {
  return {scene.*family.*number, 0, 0};
}
template <SpringFamily Scene::*family, double SpringFamily::*number>
void setOfFamily(Scene& scene, const Vec3& value) {
  scene.*family.*number = value.x;
}

template <SpringFamily Scene::*family>
constexpr Parameter stiffness(std::string_view key, std::string_view label) {
  return {key,
          label,
          "N/m",
          1,
          Allowed::NotNegative,
          getOfFamily<family, &SpringFamily::ks>,
          setOfFamily<family, &SpringFamily::ks>};
}
template <SpringFamily Scene::*family>
constexpr Parameter damping(std::string_view key, std::string_view label) {
  return {key,
          label,
          "N s/m",
          1,
          Allowed::NotNegative,
          getOfFamily<family, &SpringFamily::kd>,
          setOfFamily<family, &SpringFamily::kd>};
}

template <double Scene::*number>
constexpr Parameter single(std::string_view key, std::string_view label, std::string_view unit, Allowed allowed) {
  return {key,
          label,
          unit,
          1,
          allowed,
          [](const Scene& scene) {
            return Vec3{scene.*number, 0, 0};
          },
          [](Scene& scene, const Vec3& value) { scene.*number = value.x; }};
}

constexpr std::array kParameters{
    stiffness<&Scene::structural>("springs.structural.ks", "structural stiffness"),
    damping<&Scene::structural>("springs.structural.kd", "structural damping"),
    stiffness<&Scene::shear>("springs.shear.ks", "shear stiffness"),
    damping<&Scene::shear>("springs.shear.kd", "shear damping"),
    stiffness<&Scene::bend>("springs.bend.ks", "bend stiffness"),
    damping<&Scene::bend>("springs.bend.kd", "bend damping"),
    Parameter{"world.gravity", "gravity", "m/s2", 3, Allowed::Any, [](const Scene& scene) { return scene.gravity; },
              [](Scene& scene, const Vec3& value) { scene.gravity = value; }},
    single<&Scene::drag>("world.drag", "drag", "N s/m", Allowed::NotNegative),
    single<&Scene::tolerance>("run.tolerance", "tolerance", "m", Allowed::Positive),
};

}  // namespace

std::span<const Parameter> liveParameters() { return kParameters; }

const Parameter* findParameter(std::string_view key) {
  const auto found = std::ranges::find(kParameters, key, &Parameter::key);
  return found == kParameters.end() ? nullptr : &*found;
}

}  // namespace tyg
