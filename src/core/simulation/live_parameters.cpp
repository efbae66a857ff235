// Every function here is a loop over the table of live parameters.
#include "core/simulation/live_parameters.h"

#include <algorithm>

#include "core/forces/parameter.h"

namespace tyg {

std::vector<Vec3> liveValues(const Scene& scene) {
  std::vector<Vec3> values;
  for (const Parameter& parameter : liveParameters()) values.push_back(parameter.get(scene));
  return values;
}

void setLiveValues(Scene& scene, const std::vector<Vec3>& values) {
  auto value = values.begin();
  for (const Parameter& parameter : liveParameters()) parameter.set(scene, *value++);
}

bool sameLiveParameters(const Scene& first, const Scene& second) {
  return std::ranges::all_of(liveParameters(),
                             [&](const Parameter& parameter) { return parameter.get(first) == parameter.get(second); });
}

void copyLiveParameters(const Scene& from, Scene& to) {
  for (const Parameter& parameter : liveParameters()) parameter.set(to, parameter.get(from));
}

std::vector<WorldEvent> changesBetween(const Scene& from, const Scene& to) {
  std::vector<WorldEvent> changes;
  for (const Parameter& parameter : liveParameters()) {
    const Vec3 value = parameter.get(to);
    if (value != parameter.get(from)) changes.push_back({std::string(parameter.key), value});
  }
  return changes;
}

}  // namespace tyg
