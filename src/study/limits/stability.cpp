// Step limits: the smallest over the waves of the unbounded lattice, over the modes of the finite sheet, and over what
// any deformation can make of them.
#include "study/limits/stability.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "core/forces/term.h"
#include "core/forces/terms/springs.h"
#include "core/scene/bodies.h"
#include "core/spectrum/level_line.h"
#include "core/spectrum/rest_spectrum.h"
#include "study/limits/wave_search.h"

namespace tyg {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kEveryStep = std::numeric_limits<double>::infinity();

double finiteOrNone(double step) { return std::isfinite(step) ? step : kNone; }

/// The magnitude of the larger root of a mode, 1/s.
double fastRate(const Mode& mode) { return mode.discriminant() > 0 ? -rootsOf(mode)[0].real() : std::sqrt(mode.w2); }

/// The mode of a wave that limits a method, as an index into Lattice::modes.
std::size_t limitingMode(const Method& method, const std::array<Mode, 5>& modes) {
  std::size_t worst = 0;
  double smallest = kEveryStep;
  const auto compare = [&](std::size_t k) {
    const double limit = method.stableStep(modes.at(k).w2, modes.at(k).d);
    if (limit < smallest) worst = k, smallest = limit;
  };
  for (const std::size_t k : {0U, 1U, 2U}) compare(k);
  // The last two repeat the first two where a wave has one damping only.
  if (modes[3].d != modes[0].d) compare(3);
  if (modes[4].d != modes[1].d) compare(4);
  return worst;
}

/// The smallest limit of any mode with 0 <= w2 <= most.w2 and 0 <= d <= most.d. Along a ray through the region a limit
/// shrinks, so it lies on one of the two outer edges.
double smallestWithin(const Method& method, const Mode& most) {
  constexpr int kSamples = 2000;
  double smallest = kEveryStep;
  for (int k = 0; k <= kSamples; ++k) {
    const double share = double(k) / kSamples;
    smallest = std::min(
        {smallest, method.stableStep(most.w2, share * most.d), method.stableStep(share * share * most.w2, most.d)});
  }
  constexpr double kBetweenSamples = 1e-3;
  return (1 - kBetweenSamples) * smallest;
}

double limitOf(const Method& method, const Mode& mode) {
  return mode.w2 > 0 || mode.d > 0 ? method.stableStep(mode.w2, mode.d) : kEveryStep;
}

/// The smallest limit of all roots mu, each taken as a mode of its own; those of rigid motions are 0 but for rounding.
double limitOfRoots(const Method& method, std::span<const std::complex<double>> roots) {
  double fastest = 0, smallest = kEveryStep;
  for (const std::complex<double>& mu : roots) fastest = std::max(fastest, std::abs(mu));
  for (const std::complex<double>& mu : roots) {
    const double size = std::abs(mu);
    if (size <= 1e-5 * fastest) continue;
    constexpr double kRounding = 1e-9;
    const double loss = -mu.real() > kRounding * size ? -mu.real() : 0;
    const bool turns = std::abs(mu.imag()) > kRounding * size;
    smallest = std::min(smallest, turns ? method.stableStep(size * size, 2 * loss) : limitOf(method, {0, loss}));
  }
  return smallest;
}

/// Follows the normals of the method's level lines from one mode to the mode that is farthest along them.
template <class Farthest>
double settledLimit(const Method& method, const Farthest& farthest, Mode mode) {
  double limit = kEveryStep;
  for (int round = 0; round < 8; ++round) {
    mode = farthest(normalOfStiff(method, mode));
    const double before = limit;
    limit = limitOf(method, mode);
    if (std::abs(before - limit) < 1e-7 * limit) break;
  }
  return limit;
}

/// Of a wave under the axial law, whose stiffness and damping need not share their eigenvectors.
double axialLimit(const Lattice& lattice, const Method& method, double qx, double qy) {
  const std::array<Mode, 5> modes = lattice.modes(qx, qy);
  const double across = limitOf(method, modes.at(Lattice::kOutOfPlane));
  if (!hasStraightLevelLines(method, modes[0].d)) {
    return std::min(across, limitOfRoots(method, lattice.rootsInPlane(qx, qy)));
  }
  const auto farthest = [&](const LineNormal& normal) {
    return lattice.farthestInPlane(normal.ofK, normal.ofC, qx, qy);
  };
  return std::min(across, settledLimit(method, farthest, modes[0]));
}

/// The wave of the unbounded lattice at rest that limits a method that has a limit of modes.
LowestWave restWave(const Scene& scene, const Method& method) {
  const Lattice lattice(scene);
  return lowestWave(lattice, [&](double qx, double qy) {
    if (scene.damping == Damping::Axial) return axialLimit(lattice, method, qx, qy);
    const std::array<Mode, 5> modes = lattice.modes(qx, qy);
    const Mode& mode = modes.at(limitingMode(method, modes));
    return method.stableStep(mode.w2, mode.d);
  });
}

/// The mode of that wave that limits the method.
Mode modeOf(const Scene& scene, const Method& method, const LowestWave& wave) {
  const std::array<Mode, 5> modes = Lattice(scene).modes(wave.qx, wave.qy);
  return modes.at(limitingMode(method, modes));
}

/// Does the method hold by damping alone, so that the least damped motion sets its limit? Only a full spectrum tells
/// it.
bool isHeldByDamping(const Method& method, const Mode& mode) { return method.stableStep(mode.w2, 0) == 0; }

/// Of the finite sheet at rest with its pins.
double finiteSheetLimit(const Scene& scene, const Method& method, const Mode& ofLattice) {
  const RestSpectrum spectrum(scene);
  const bool small = scene.columns * scene.rows <= RestSpectrum::kMostDense;
  const double across = limitOf(method, spectrum.mostDampedOutOfPlane());
  if (!hasStraightLevelLines(method, ofLattice.d)) {
    return std::min(across, limitOfRoots(method, small ? spectrum.roots() : spectrum.outerRoots()));
  }
  const auto farthest = [&](const LineNormal& normal) { return spectrum.farthest(normal); };
  return std::min(across, settledLimit(method, farthest, ofLattice));
}

double unboundedLatticeLimit(const Scene& scene, const Method& method) {
  if (method.stableStepOfScene != nullptr) return finiteOrNone(method.stableStepOfScene(scene));
  if (method.stableStep == nullptr) return kNone;
  return finiteOrNone(restWave(scene, method).value);
}

/// The smaller one of two limits, of which either may be NaN.
double smallerOf(double a, double b) { return std::fmin(a, b); }

double heldLimitOf(const Method& method, const Mode& mode) {
  if (!(mode.w2 > 0 || mode.d > 0)) return kEveryStep;
  return method.stableStepWhereHeld != nullptr ? method.stableStepWhereHeld(mode.w2, mode.d)
                                               : method.stableStep(mode.w2, mode.d);
}

/// The mode of those that limits the method.
Mode worstHeldMode(const Scene& scene, const Method& method) {
  const std::vector<Mode> modes = heldModes(scene);
  const Mode &along = modes.at(0), &across = modes.at(1);
  if (method.stableStep == nullptr) return fastRate(across) > fastRate(along) ? across : along;
  return heldLimitOf(method, across) < heldLimitOf(method, along) ? across : along;
}

/// Does the damping of a held particle set its limit rather than the stiffness?
bool isHeldByItsDamping(const Method& method, const Mode& mode) {
  if (method.stableStep == nullptr) return mode.discriminant() > 0;
  return heldLimitOf(method, {0, mode.d}) < heldLimitOf(method, {mode.w2, 0});
}

/// Of the lattice alone.
double latticeLimit(const Scene& scene, const Method& method) {
  const std::optional<Scene> sheet = RestSpectrum::smallSheet(scene);
  if (method.stableStep == nullptr || !sheet) return unboundedLatticeLimit(scene, method);
  const LowestWave wave = restWave(scene, method);
  const double unbounded = finiteOrNone(wave.value);
  if (!(unbounded > 0)) return unbounded;
  const Mode mode = modeOf(scene, method, wave);
  const bool small = sheet->columns * sheet->rows <= RestSpectrum::kMostDense;
  if (!small && isHeldByDamping(method, mode)) return unbounded;
  const double own = finiteSheetLimit(*sheet, method, mode);
  return finiteOrNone(std::max(StepLimit::kBelowMeeting * own, std::min(own, unbounded)));
}

/// The smallest limit of any mode that may be left where springs go: of no more stiffness or damping than the lattice
/// has, and of no less damping for its stiffness than the least damped family. Where lines of one limit are straight,
/// what goes only makes it longer.
double limitInPieces(const Scene& scene, const Method& method) {
  const Lattice lattice(scene);
  const auto most = [&](double Mode::*number) {
    return extremeWave(lattice, [&](const Mode& mode) { return mode.*number; }).mode.*number;
  };
  const double w2 = most(&Mode::w2), d = most(&Mode::d);
  if (hasStraightLevelLines(method, d)) return kEveryStep;
  const double ratio = mostStiffnessPerDamping(scene), always = particleDamping(scene) / scene.particleMass;
  constexpr int kSamples = 60;
  constexpr double kBetweenSamples = 1e-3;
  double smallest = kEveryStep;
  for (int i = 0; i <= kSamples; ++i) {
    const double stiffness = w2 * i * i / (kSamples * kSamples), least = std::min(d, always + stiffness / ratio);
    for (int j = 0; j <= kSamples; ++j) {
      smallest = std::min(smallest, limitOf(method, {stiffness, least + (d - least) * j / kSamples}));
    }
  }
  return (1 - kBetweenSamples) * smallest;
}

/// Of the terms besides the springs the one that does most of the damping of the mode that limits a method; null where
/// the springs do more.
const ForceTerm* mainDamper(const Scene& scene, const StepLimit& limit) {
  const auto modesOf = [&](const Scene& of) { return Lattice(of).modes(limit.qx, limit.qy); };
  const std::array<Mode, 5> modes = modesOf(scene);
  const auto isLimiting = [&](const Mode& mode) { return mode.w2 == limit.mode.w2 && mode.d == limit.mode.d; };
  const auto k = std::size_t(std::ranges::find_if(modes, isLimiting) - modes.begin());
  if (k == modes.size()) return nullptr;
  double most = modesOf(withoutParticleDamping(scene)).at(k).d;
  const ForceTerm* main = nullptr;
  for (const ForceTerm* term : forceTerms()) {
    if (term->family || !hasTerm(scene, *term)) continue;
    Scene without = scene;
    leaveOut(without, *term);
    const double part = limit.mode.d - modesOf(without).at(k).d;
    if (part > most) main = term, most = part;
  }
  return main;
}

bool isLimitedByContact(const Scene& scene, const Method& method, double predicted) {
  if (holdingTerm(scene).term == nullptr) return false;
  constexpr double kSame = 1e-3;  // of a search for the stages of a whole spectrum
  const double without = latticeLimit(withoutBodies(scene), method);
  return !(without <= (1 + (method.stableStep == nullptr ? kSame : 0)) * predicted);
}

}  // namespace

std::vector<Mode> heldModes(const Scene& scene) {
  const auto [term, hold] = holdingTerm(scene);
  if (term == nullptr) return {};
  const double perMass = 1 / scene.particleMass, everywhere = perMass * particleDamping(scene);
  return {{perMass * hold.stiffness, perMass * hold.damping + everywhere}, {0, perMass * hold.across + everywhere}};
}

double heldLimit(const Scene& scene, const Method& method) {
  if (method.stableStep == nullptr || holdingTerm(scene).term == nullptr) return kNone;
  double smallest = kEveryStep;
  for (const Mode& mode : heldModes(scene)) smallest = std::min(smallest, heldLimitOf(method, mode));
  return finiteOrNone(smallest);
}

double unboundedLimit(const Scene& scene, const Method& method) {
  return smallerOf(unboundedLatticeLimit(scene, method), heldLimit(scene, method));
}

double restLatticeLimit(const Scene& scene, const Method& method) {
  const double whole = smallerOf(latticeLimit(scene, method), heldLimit(scene, method));
  if (!losesSprings(scene) || method.stableStep == nullptr || !(whole > 0)) return whole;
  return std::min(whole, limitInPieces(scene, method));
}

bool catchesAir(const Scene& scene) { return scene.columns > 1 && scene.rows > 1 && cellDampingTerm(scene) != nullptr; }

double certifiedLimit(const Scene& scene, const Method& method) {
  if (method.stableStep == nullptr || catchesAir(scene)) return kNone;
  const Lattice lattice(scene);
  const bool isHeld = holdingTerm(scene).term != nullptr;
  const auto over = [&](const WaveFunction& function) { return lowestWave(lattice, function); };
  const double mostD = -over([&](double qx, double qy) { return -lattice.anyDeformation(qx, qy).d; }).value;
  if (hasStraightLevelLines(method, mostD)) {
    return finiteOrNone(over([&](double qx, double qy) {
                          const Mode mode = lattice.anyDeformation(qx, qy);
                          return isHeld ? heldLimitOf(method, mode) : limitOf(method, mode);
                        }).value);
  }
  const double mostW2 = -over([&](double qx, double qy) { return -lattice.anyDeformation(qx, qy).w2; }).value;
  return finiteOrNone(smallestWithin(method, {mostW2, mostD}));
}

StepLimit stepLimit(const Scene& scene, const Method& method) {
  StepLimit limit;
  limit.predicted = restLatticeLimit(scene, method);
  limit.certified = certifiedLimit(scene, method);
  if (std::isnan(limit.predicted)) return limit;
  if (isLimitedByContact(scene, method, limit.predicted)) {
    limit.byContact = true;
    limit.mode = worstHeldMode(scene, method);
    limit.byDamping = isHeldByItsDamping(method, limit.mode);
    return limit;
  }
  const Lattice lattice(scene);
  if (method.stableStep == nullptr || limit.predicted == 0) {
    // Where no step holds, the fastest wave grows first; where stages run out, the wave of the fastest root.
    const bool byStages = limit.predicted > 0;
    const LatticeWave wave =
        extremeWave(lattice, [&](const Mode& mode) { return byStages ? fastRate(mode) : mode.w2; });
    limit.qx = wave.qx, limit.qy = wave.qy, limit.mode = wave.mode;
    limit.outOfPlane = byStages && wave.mode.w2 == 0;
    limit.byDamping = byStages && wave.mode.discriminant() > 0;
    if (limit.byDamping) limit.damper = mainDamper(scene, limit);
    const std::optional<Scene> sheet = RestSpectrum::smallSheet(scene);
    if (!byStages && sheet) limit.mode = RestSpectrum(*sheet).farthest({1, 0});
    return limit;
  }
  const LowestWave wave = restWave(scene, method);
  limit.qx = wave.qx, limit.qy = wave.qy;
  const std::array<Mode, 5> modes = lattice.modes(wave.qx, wave.qy);
  const std::size_t worst = limitingMode(method, modes);
  limit.mode = modes.at(worst);
  limit.outOfPlane = worst == Lattice::kOutOfPlane;
  limit.byDamping = method.stableStep(0, limit.mode.d) < method.stableStep(limit.mode.w2, 0);
  if (limit.byDamping) limit.damper = mainDamper(scene, limit);
  return limit;
}

}  // namespace tyg
