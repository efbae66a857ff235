// What people see of the springs: the stiffness and the damping of each family, and where a scene keeps them.
#include "core/forces/terms/springs.h"

#include <algorithm>
#include <array>

#include "core/forces/term.h"

namespace tyg {
namespace {

template <SpringFamily Scene::*family, double SpringFamily::*number>
constexpr Parameter parameterOf(std::string_view key, std::string_view label) {
  Parameter parameter{.key = key,
                      .label = label,
                      .unit = "N/m",
                      .count = 1,
                      .allowed = Allowed::NotNegative,
                      .get =
                          [](const Scene& scene) {
                            return Vec3{scene.*family.*number, 0, 0};
                          },
                      .set = [](Scene& scene, const Vec3& value) { scene.*family.*number = value.x; },
                      .role = Role::Stiffness,
                      .mostByHand = 1e5,
                      .digits = 4};
  if (number == &SpringFamily::kd) {
    parameter.unit = "N s/m", parameter.role = Role::Damping;
    parameter.mostByHand = 100, parameter.digits = 3;
  }
  return parameter;
}

constexpr std::array kStructural{
    parameterOf<&Scene::structural, &SpringFamily::ks>("springs.structural.ks", "structural stiffness"),
    parameterOf<&Scene::structural, &SpringFamily::kd>("springs.structural.kd", "structural damping")};
constexpr std::array kShear{parameterOf<&Scene::shear, &SpringFamily::ks>("springs.shear.ks", "shear stiffness"),
                            parameterOf<&Scene::shear, &SpringFamily::kd>("springs.shear.kd", "shear damping")};
constexpr std::array kBend{parameterOf<&Scene::bend, &SpringFamily::ks>("springs.bend.ks", "bend stiffness"),
                           parameterOf<&Scene::bend, &SpringFamily::kd>("springs.bend.kd", "bend damping")};

}  // namespace

double mostStiffnessPerDamping(const Scene& scene) {
  double most = 0;
  for (const Family family : kFamilies) {
    const SpringFamily& springs = familyOf(scene, family);
    if (springs.ks > 0) most = std::max(most, springs.ks / springs.kd);
  }
  return most;
}

const SpringFamily& familyOf(const Scene& scene, Family family) {
  switch (family) {
    case Family::Structural:
      return scene.structural;
    case Family::Shear:
      return scene.shear;
    case Family::Bend:
      break;
  }
  return scene.bend;
}

template <>
constinit const ForceTerm StructuralSprings::kTerm{
    .name = "structural", .parameters = kStructural, .family = Family::Structural};
template <>
constinit const ForceTerm ShearSprings::kTerm{.name = "shear", .parameters = kShear, .family = Family::Shear};
template <>
constinit const ForceTerm BendSprings::kTerm{.name = "bend", .parameters = kBend, .family = Family::Bend};

}  // namespace tyg
