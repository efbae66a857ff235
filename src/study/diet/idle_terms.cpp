// Estimates that err on the side of silence.
#include "study/diet/idle_terms.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "tyg/sheet.h"

namespace tyg {
namespace {

constexpr double kVisible = 1e-3;

double length(const Vec3& v) { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

struct NamedFamily {
  const char* name;
  Family which;
  const SpringFamily& springs;
};

bool isFreeFall(const Scene& scene) {
  const auto nothing = [](const Push& push) { return length(push.force) == 0 || push.duration == 0; };
  return scene.pins.empty() && scene.displacements.empty() && std::ranges::all_of(scene.pushes, nothing);
}

void addFamily(const Scene& scene, const NamedFamily& family, std::vector<std::string>& idle) {
  if (!family.springs.present()) return;
  const Sheet sheet = makeSheet(scene);
  const std::string name = family.name;
  if (springCount(sheet, family.which) == 0) {
    idle.push_back("there are no " + name + " springs on so narrow a sheet");
    return;
  }
  const double weight = scene.particleMass * length(scene.gravity);
  const double pull = family.springs.ks * restLength(sheet, family.which);
  if (family.springs.ks > 0 && family.springs.kd == 0 && pull < kVisible * weight) {
    idle.push_back(name + " springs: pulled to twice their length they hold less than a thousandth of a weight");
  }
  // A particle has four springs of a family, at both ends of which velocities differ by twice the largest at most.
  constexpr double kEnds = 8;
  if (family.springs.kd > 0 && kEnds * family.springs.kd * scene.duration < kVisible * scene.particleMass) {
    idle.push_back("the damping of " + name + " springs takes less than a thousandth of any velocity in the whole run");
  }
}

void addEvents(const Scene& scene, std::vector<std::string>& idle) {
  const Sheet sheet = makeSheet(scene);
  const auto isPinned = [&](const Place& place) {
    return std::ranges::binary_search(sheet.pins, particleAt(sheet, place));
  };
  for (std::size_t k = 0; k < scene.pushes.size(); ++k) {
    const Push& push = scene.pushes[k];
    const std::string name = "push " + std::to_string(k + 1);
    if (length(push.force) == 0 || push.duration == 0) {
      idle.push_back(name + " has no force or no length");
    } else if (push.at >= scene.duration) {
      idle.push_back(name + " begins after the end of the run");
    } else if (isPinned(push.particle)) {
      idle.push_back(name + " acts on a pinned particle");
    }
  }
  for (std::size_t k = 0; k < scene.displacements.size(); ++k) {
    if (length(scene.displacements[k].by) == 0) {
      idle.push_back("displacement " + std::to_string(k + 1) + " moves nothing");
    }
  }
}

}  // namespace

std::vector<std::string> idleTerms(const Scene& scene) {
  std::vector<std::string> idle;
  const std::array<NamedFamily, 3> families{{{"structural", Family::Structural, scene.structural},
                                             {"shear", Family::Shear, scene.shear},
                                             {"bend", Family::Bend, scene.bend}}};
  if (isFreeFall(scene)) {
    const bool any = std::ranges::any_of(families, [](const NamedFamily& family) { return family.springs.present(); });
    if (any) idle.emplace_back("springs: nothing holds, moves or pushes this sheet, so none of them ever stretches");
  } else {
    for (const NamedFamily& family : families) addFamily(scene, family, idle);
  }
  if (scene.drag > 0 && scene.drag * scene.duration < kVisible * scene.particleMass) {
    idle.emplace_back("drag takes less than a thousandth of any velocity in the whole run");
  }
  addEvents(scene, idle);
  return idle;
}

}  // namespace tyg
