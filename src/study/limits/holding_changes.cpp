// Each change is looked for outwards, by factors of two, on the unbounded lattice, whose limit is quickly known and
// close to the sheet's own; and then with that, between the last factor that does not hold and the first that does.
#include "study/limits/holding_changes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/forces/terms/springs.h"
#include "study/limits/stability.h"

namespace tyg {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr std::array kSprings{&Scene::structural, &Scene::shear, &Scene::bend};

void scaleStiffness(Scene& scene, double factor) {
  for (const auto family : kSprings) (scene.*family).ks *= factor;
}
void scaleDamping(Scene& scene, double factor) {
  for (const auto family : kSprings) (scene.*family).kd *= factor;
}
void scaleMass(Scene& scene, double factor) { scene.particleMass *= factor; }

/// A number with three significant digits, not above it.
double threeDigitsBelow(double number) {
  if (!(number > 0) || !std::isfinite(number)) return number;
  const double unit = std::pow(10, std::floor(std::log10(number)) - 2);
  return std::floor(number / unit * (1 + 1e-12)) * unit;
}
double threeDigitsAbove(double number) {
  const double below = threeDigitsBelow(number);
  if (!(below < number * (1 - 1e-12))) return below;
  return below + std::pow(10, std::floor(std::log10(below)) - 2);
}

/// How far a step is within a limit, as the logarithm of their ratio; infinite where there is no limit.
double slackOf(double limit, double dt) {
  return std::isnan(limit) ? std::numeric_limits<double>::infinity() : std::log(limit / dt);
}

/// The first power of `towards` with which `slack` (of the logarithm of a factor) is not negative; where there is none
/// up to a few thousand, the one with the largest slack.
template <class Slack>
int firstThatHolds(double towards, const Slack& slack) {
  constexpr int kDoublings = 12;
  int best = 1;
  double most = -std::numeric_limits<double>::infinity();
  for (int k = 1; k <= kDoublings; ++k) {
    const double found = slack(k * std::log(towards));
    if (found >= 0) return k;
    if (found > most) best = k, most = found;
  }
  return best;
}

/// The factor nearest to 1, above or below it as `towards` is, with which the step holds with next to nothing to spare;
/// NaN where none up to a few thousand does.
template <class Change>
double holdingFactor(const Scene& scene, const Method& method, double dt, double towards, const Change& change) {
  constexpr int kMostRounds = 20;
  constexpr double kSpare = 1e-3;
  const auto changed = [&](double logFactor) {
    Scene other = scene;
    change(other, std::exp(logFactor));
    return other;
  };
  const auto slack = [&](double logFactor) { return slackOf(restLatticeLimit(changed(logFactor), method), dt); };
  int k = firstThatHolds(towards,
                         [&](double logFactor) { return slackOf(unboundedLimit(changed(logFactor), method), dt); });
  double holds = k * std::log(towards), spare = slack(holds);
  if (spare < 0) return kNone;
  double fails = 0, lacking = -std::numeric_limits<double>::infinity();
  while (--k > 0) {
    const double less = k * std::log(towards), found = slack(less);
    if (found < 0) {
      fails = less, lacking = found;
      break;
    }
    holds = less, spare = found;
  }
  // A limit is nearly a power of the factor, so that a line through both ends leads close to it.
  for (int round = 0; round < kMostRounds && spare > kSpare; ++round) {
    const bool isFinite = std::isfinite(lacking) && std::isfinite(spare);
    const double share = isFinite ? std::clamp((kSpare / 2 - lacking) / (spare - lacking), 0.02, 0.98) : 0.5;
    const double between = fails + share * (holds - fails), found = slack(between);
    (found < 0 ? fails : holds) = between;
    (found < 0 ? lacking : spare) = found;
  }
  return std::exp(holds);
}

/// Of two factors the one that changes less; either may be NaN.
double nearer(double a, double b) {
  if (std::isnan(a) || std::isnan(b)) return std::isnan(a) ? b : a;
  return std::abs(std::log(a)) < std::abs(std::log(b)) ? a : b;
}

/// The damping that holds, N s/m of the structural springs.
double holdingDamping(Scene scene, const Method& method, double dt) {
  if (scene.structural.kd == 0) {
    if (scene.shear.kd > 0 || scene.bend.kd > 0) return kNone;
    constexpr double kNextToNothing = 1e-3;  // of what is critical for one spring
    const double kd = kNextToNothing * std::sqrt(scene.structural.ks * scene.particleMass);
    for (const auto family : kSprings) (scene.*family).kd = (scene.*family).ks > 0 ? kd : 0;
  }
  const double more = holdingFactor(scene, method, dt, 2, scaleDamping);
  const double less = holdingFactor(scene, method, dt, 0.5, scaleDamping);
  const double factor = nearer(more, less), kd = scene.structural.kd * factor;
  return factor > 1 ? threeDigitsAbove(kd) : threeDigitsBelow(kd);
}

}  // namespace

bool holdsAtRest(const Scene& scene, const Method& method, double dt) {
  return slackOf(restLatticeLimit(scene, method), dt) >= 0;
}

HoldingChanges changesThatHold(const Scene& scene, const Method& method, double dt) {
  const double mass = holdingFactor(scene, method, dt, 2, scaleMass);
  return {.dt = threeDigitsBelow(restLatticeLimit(scene, method)),
          .stiffness = threeDigitsBelow(holdingFactor(scene, method, dt, 0.5, scaleStiffness)),
          .damping = holdingDamping(scene, method, dt),
          .mass = threeDigitsAbove(scene.particleMass * mass)};
}

std::vector<std::string> springsThatLimit(const Scene& scene, const Method& method, bool byDamping) {
  constexpr std::array kNames{"structural", "shear", "bend"};
  const double limit = restLatticeLimit(scene, method);
  std::vector<std::string> names;
  if (std::isnan(limit)) return names;
  for (std::size_t k = 0; k < kSprings.size(); ++k) {
    Scene without = scene;
    double& cause = byDamping ? (without.*kSprings.at(k)).kd : (without.*kSprings.at(k)).ks;
    if (std::exchange(cause, 0) == 0) continue;
    const double other = restLatticeLimit(without, method);
    if (!(std::abs(other - limit) <= 0.01 * limit)) names.emplace_back(kNames.at(k));
  }
  return names;
}

}  // namespace tyg
