// Gathers the parameters of all force terms, and adds the one of adaptive methods.
#include "core/forces/parameter.h"

#include <algorithm>

#include "core/forces/term.h"

namespace tyg {
namespace {

constexpr Parameter kTolerance{.key = "run.tolerance",
                               .label = "tolerance",
                               .unit = "m",
                               .count = 1,
                               .allowed = Allowed::Positive,
                               .get =
                                   [](const Scene& scene) {
                                     return Vec3{scene.tolerance, 0, 0};
                                   },
                               .set = [](Scene& scene, const Vec3& value) { scene.tolerance = value.x; }};

std::vector<Parameter> gathered() {
  std::vector<Parameter> all;
  for (const ForceTerm* term : forceTerms()) all.insert(all.end(), term->parameters.begin(), term->parameters.end());
  all.push_back(kTolerance);
  return all;
}

}  // namespace

std::span<const Parameter> liveParameters() {
  static const std::vector<Parameter> kAll = gathered();
  return kAll;
}

const Parameter* findParameter(std::string_view key) {
  const std::span<const Parameter> all = liveParameters();
  const auto found = std::ranges::find(all, key, &Parameter::key);
  return found == all.end() ? nullptr : &*found;
}

std::vector<Vec3> valuesOf(const Scene& scene, Role role) {
  std::vector<Vec3> values;
  for (const Parameter& parameter : liveParameters()) {
    if (parameter.role == role) values.push_back(parameter.get(scene));
  }
  return values;
}

}  // namespace tyg
