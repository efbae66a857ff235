// Compares the largest effect that a term can have with what can be seen. Where in doubt, it says nothing.
#include "study/diet/idle_terms.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string_view>
#include <type_traits>

#include <fmt/core.h>

#include "core/forces/term.h"
#include "core/forces/terms/springs.h"
#include "core/scene/bodies.h"
#include "study/diet/free_fall.h"
#include "tyg/sheet.h"

namespace tyg {
namespace {

constexpr double kVisible = 1e-3;

double length(const Vec3& v) { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

bool isFreeFall(const Scene& scene) {
  const auto nothing = [](const Push& push) { return length(push.force) == 0 || push.duration == 0; };
  if (scene.air.density > 0 || !scene.pins.empty() || !scene.displacements.empty()) return false;
  return std::ranges::all_of(scene.pushes, nothing) && !mayFallOntoABody(scene);
}

void addFamily(const Scene& scene, Family family, std::string_view name, std::vector<std::string>& idle) {
  const Sheet sheet = makeSheet(scene);
  if (springCount(sheet, family) == 0) {
    idle.push_back(fmt::format("there are no {} springs on so narrow a sheet", name));
    return;
  }
  const SpringFamily& springs = familyOf(scene, family);
  const double weight = length(steadyForce(scene));
  const double pull = springs.ks * restLength(sheet, family);
  if (springs.ks > 0 && springs.kd == 0 && pull < kVisible * weight) {
    idle.push_back(
        fmt::format("{} springs: pulled to twice their length they hold less than a thousandth of a weight", name));
  }
  // A particle has four springs of a family, at both ends of which velocities differ by twice the largest at most.
  constexpr double kEnds = 8;
  if (springs.kd > 0 && kEnds * springs.kd * scene.duration < kVisible * scene.particleMass) {
    idle.push_back(
        fmt::format("the damping of {} springs takes less than a thousandth of any velocity in the whole run", name));
  }
}

/// What acts from a time on for a while.
template <class Timed>
bool addTimed(const Scene& scene, const Timed& timed, double size, const std::string& name,
              std::vector<std::string>& idle) {
  if (size == 0 || timed.duration == 0) {
    idle.push_back(name +
                   (std::is_same_v<Timed, Push> ? " has no force or no length" : " has no velocity or no length"));
  } else if (timed.at >= scene.duration) {
    idle.push_back(name + " begins after the end of the run");
  } else {
    return false;
  }
  return true;
}

/// Air acts on cells alone, and a wind needs air.
void addAir(const Scene& scene, std::vector<std::string>& idle) {
  const bool hasAir = scene.air.density > 0 && scene.air.coefficient > 0;
  if (scene.air.density > 0 && !hasAir) idle.emplace_back("air: its drag coefficient is 0");
  if (hasAir && (scene.columns == 1 || scene.rows == 1)) {
    idle.emplace_back("air: it acts on the cells of a sheet, and a chain has none");
    return;
  }
  for (std::size_t k = 0; k < scene.winds.size(); ++k) {
    const std::string name = fmt::format("wind {}", k + 1);
    const Wind& wind = scene.winds[k];
    if (addTimed(scene, wind, length(wind.velocity), name, idle)) continue;
    if (!hasAir) idle.push_back(name + " blows where there is no air");
    if (wind.wavelength > 0 && wind.gust == Vec3{}) idle.push_back(name + " has a wavelength, but no gust");
  }
}

void addContact(const Scene& scene, bool freeFall, std::vector<std::string>& idle) {
  if (!touchesBodies(scene)) return;
  if (freeFall) idle.push_back(bodiesInWords(scene) + ": the sheet falls freely and never touches a body");
  const double friction = scene.contact.friction;
  if (friction > 0 && (freeFall || friction < kVisible)) {
    idle.emplace_back(freeFall ? "friction: nothing is touched"
                               : "friction: it is less than a thousandth of what presses the cloth onto a body");
  }
}

void addCuts(const Scene& scene, std::vector<std::string>& idle) {
  Sheet sheet = makeSheet(scene);
  std::vector<std::size_t> order(scene.cuts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t k) { return scene.cuts[k].at; });
  for (const std::size_t k : order) {
    const Missing before = sheet.missing;
    sheet.missing = before.withCut(sheet.columns, sheet.rows, scene.cuts[k].line);
    if (scene.cuts[k].at >= scene.duration) {
      idle.push_back(fmt::format("cut {} is made after the end of the run", k + 1));
    } else if (sheet.missing == before) {
      idle.push_back(fmt::format("cut {} takes nothing that is still there", k + 1));
    }
  }
  if (std::isfinite(strainThatTears(scene)) && springCount(makeSheet(scene), Family::Structural) == 0) {
    idle.emplace_back("tear: there is no spring that could break");
  }
}

void addEvents(const Scene& scene, std::vector<std::string>& idle) {
  const Sheet sheet = makeSheet(scene);
  const auto isPinned = [&](const Place& place) {
    return std::ranges::binary_search(sheet.pins, particleAt(sheet, place));
  };
  for (std::size_t k = 0; k < scene.pushes.size(); ++k) {
    const Push& push = scene.pushes[k];
    const std::string name = fmt::format("push {}", k + 1);
    if (!addTimed(scene, push, length(push.force), name, idle) && isPinned(push.particle)) {
      idle.push_back(name + " acts on a pinned particle");
    }
  }
  for (std::size_t k = 0; k < scene.moves.size(); ++k) {
    addTimed(scene, scene.moves[k], length(scene.moves[k].velocity), fmt::format("move {}", k + 1), idle);
  }
  for (std::size_t k = 0; k < scene.displacements.size(); ++k) {
    if (length(scene.displacements[k].by) == 0) {
      idle.push_back(fmt::format("displacement {} moves nothing", k + 1));
    }
  }
}

}  // namespace

std::vector<std::string> idleTerms(const Scene& scene) {
  std::vector<std::string> idle;
  const bool freeFall = isFreeFall(scene);
  const auto springs = [&](const ForceTerm* term) { return term->family && hasTerm(scene, *term); };
  if (freeFall && std::ranges::any_of(forceTerms(), springs)) {
    idle.emplace_back("springs: nothing holds, moves or pushes this sheet, so none of them ever stretches");
  }
  for (const ForceTerm* term : forceTerms()) {
    if (springs(term) && !freeFall) addFamily(scene, *term->family, term->name, idle);
    const double damping = term->particleDamping != nullptr ? term->particleDamping(scene) : 0;
    if (damping > 0 && damping * scene.duration < kVisible * scene.particleMass) {
      idle.push_back(fmt::format("{} takes less than a thousandth of any velocity in the whole run", term->name));
    }
  }
  addAir(scene, idle);
  addContact(scene, freeFall, idle);
  addEvents(scene, idle);
  addCuts(scene, idle);
  return idle;
}

}  // namespace tyg
