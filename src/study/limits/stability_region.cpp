// Stability regions in the plane of z = h mu, from the methods' own limits of one mode.
#include "study/limits/stability_region.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/spectrum/rest_spectrum.h"
#include "study/limits/stability.h"

namespace tyg {
namespace {

constexpr int kAngles = 180;

/// Of a pair of roots of size 1/h at an angle, in units of 1/h: how far the pair may go out.
double pairReach(const Method& method, double angle, double h) {
  return method.stableStep(1 / (h * h), -2 * std::cos(angle) / h) / h;
}

double chebyshevReach(const ChebyshevStages& stages, double angle) {
  const double stride = 0.004;
  double reach = stride;
  constexpr double kRounding = 1e-9;
  while (reach < 1e5 && std::abs(chebyshevGrowth(stages, std::polar(reach, angle))) <= 1 + kRounding) reach += stride;
  return reach - stride;
}

}  // namespace

std::vector<std::complex<double>> sceneRoots(const Scene& scene) {
  if (scene.columns * scene.rows <= RestSpectrum::kMostDense) return RestSpectrum(scene).roots();
  const Lattice lattice(scene);
  constexpr int kMostWaves = 40;
  const int columns = std::min(scene.columns, kMostWaves), rows = std::min(scene.rows, kMostWaves);
  std::vector<std::complex<double>> roots;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const auto modes = lattice.modes((i + 0.5) * std::numbers::pi / columns, (j + 0.5) * std::numbers::pi / rows);
      for (const std::size_t k : {0U, 1U, 2U}) {
        for (const std::complex<double>& mu : rootsOf(modes.at(k))) roots.push_back(mu);
      }
    }
  }
  return roots;
}

std::vector<std::complex<double>> heldRoots(const Scene& scene) {
  std::vector<std::complex<double>> roots;
  for (const Mode& mode : heldModes(scene)) {
    for (const std::complex<double>& mu : rootsOf(mode)) roots.push_back(mu);
  }
  return roots;
}

StabilityRegion regionOf(const Method& method, const Scene& scene, double h) {
  StabilityRegion region;
  const bool chebyshev = method.stableStep == nullptr && method.stableStepOfScene != nullptr;
  if (chebyshev) region.stages = chebyshevStages(chebyshevModes(scene, losesSprings(scene)), h);
  if (chebyshev && region.stages.count == 0) region.stages.count = 2;
  if (!chebyshev && method.stableStep == nullptr) return region;
  for (int k = 0; k <= kAngles; ++k) {
    const double angle = std::numbers::pi * (0.5 + double(k) / kAngles);
    region.edge.push_back(
        std::polar(chebyshev ? chebyshevReach(region.stages, angle) : pairReach(method, angle, h), angle));
  }
  region.onRealAxis = chebyshev ? -region.edge[kAngles / 2].real() : method.stableStep(0, 1 / h) / h;
  return region;
}

bool holdsAt(const Method& method, const StabilityRegion& region, const std::complex<double>& mu, double h, bool held) {
  const double size = std::abs(mu), loss = std::max(0.0, -mu.real());
  constexpr double kRounding = 1e-9;
  if (size == 0 || (region.edge.empty() && region.stages.count == 0)) return true;
  if (region.stages.count > 0)
    return std::abs(chebyshevGrowth(region.stages, {-loss * h, mu.imag() * h})) <= 1 + kRounding;
  const bool turns = std::abs(mu.imag()) > kRounding * size;
  const auto limitOf = held && method.stableStepWhereHeld != nullptr ? method.stableStepWhereHeld : method.stableStep;
  return h <= (1 + kRounding) * (turns ? limitOf(size * size, 2 * loss) : limitOf(0, loss));
}

}  // namespace tyg
