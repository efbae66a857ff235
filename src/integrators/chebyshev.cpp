// The polynomials and their derivatives come from the three-term recurrence of Chebyshev's; a scene gets the fewest
// stages that hold all modes that its springs can have.
#include "integrators/chebyshev.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/forces/term.h"
#include "core/forces/terms/springs.h"
#include "core/scene/bodies.h"
#include "core/spectrum/rest_spectrum.h"
#include "integrators/chebyshev_table.h"

namespace tyg {
namespace {

using Complex = std::complex<double>;

constexpr std::array kDamped{2.0 / 13, 1.0, 4.0, 16.0, 64.0};  // eps

/// What of a method its growth depends on.
struct Polynomial {
  int s;
  double w0, w1, b, value;

  explicit Polynomial(const ChebyshevStages& stages) : s(stages.count) {
    const ChebyshevTable table(stages);
    w0 = table.w0, w1 = table.w1, b = table.b.back(), value = table.value.back();
  }
  [[nodiscard]] Complex at(const Complex& z) const {
    const Complex x = w0 + w1 * z;
    Complex before = 1, now = x;  // T_0, T_1 by the three-term recurrence
    for (int j = 2; j <= s; ++j) {
      const Complex next = 2.0 * x * now - before;
      before = now;
      now = next;
    }
    return 1.0 + b * (now - value);
  }
};

/// Of all methods, by their stages and then by kDamped.
const std::vector<Polynomial>& polynomials() {
  static const std::vector<Polynomial> all = [] {
    std::vector<Polynomial> made;
    for (int s = 2; s <= kMostChebyshevStages; ++s) {
      for (const double eps : kDamped) made.emplace_back(ChebyshevStages{s, eps});
    }
    return made;
  }();
  return all;
}

/// Whether a method holds all of these at a step of h. The root that grows comes to the front: the next method most
/// likely fails there too.
bool holdsAll(const Polynomial& polynomial, double h, std::vector<Complex>& roots) {
  constexpr double kRounding = 1e-10;
  const auto growing =
      std::ranges::find_if(roots, [&](const Complex& mu) { return std::abs(polynomial.at(h * mu)) > 1 + kRounding; });
  if (growing == roots.end()) return true;
  std::swap(roots.front(), *growing);
  return false;
}

/// Of all modes, but for the lower ones of pairs: conjugate roots grow alike.
std::vector<Complex> upperRootsOf(std::span<const Mode> modes) {
  std::vector<Complex> roots;
  for (const Mode& mode : modes) {
    const auto [first, second] = rootsOf(mode);
    roots.push_back(first);
    if (second.imag() == 0) roots.push_back(second);
  }
  return roots;
}

/// The largest stiffness of a motion at rest over its damping by springs, 1/s, from a small sheet without pins, which
/// only take motions away. Edges count: there springs of one family stand without those that damp them inside.
double stiffnessPerDamping(Scene scene) {
  constexpr int kMost = 6;          // an axis
  constexpr double kLarger = 1.05;  // sheets of up to 13 x 13 were found to have up to a fiftieth more
  scene.columns = std::min(scene.columns, kMost), scene.rows = std::min(scene.rows, kMost);
  scene.pins.clear();
  return kLarger * RestSpectrum(withoutParticleDamping(scene)).mostStiffnessPerDamping();
}

/// Adds modes of every stiffness with the least damping that a motion of such stiffness has.
void addLeastDamped(const Scene& scene, bool inPieces, std::vector<Mode>& modes) {
  constexpr int kSamples = 100;
  Mode most;
  for (const Mode& mode : modes) most = {std::max(most.w2, mode.w2), std::max(most.d, mode.d)};
  const double ratio = inPieces ? mostStiffnessPerDamping(scene) : stiffnessPerDamping(scene);
  const double least = particleDamping(scene) / scene.particleMass;
  for (int k = 1; k <= kSamples; ++k) {
    const double w2 = most.w2 * k * k / (kSamples * kSamples);
    modes.push_back({w2, std::min(most.d, least + w2 / ratio)});
  }
}

/// Stiffness and damping of a particle in the layer of contact, as shares of the largest: S' and w of
/// core/forces/terms/contact.h at u = 1/2, 3/4, 1 and far below. Where cloth is light it rests near the top.
constexpr std::array<std::array<double, 2>, 4> kInTheLayer{{{0.5, 0.135}, {0.896, 0.34}, {1, 0.5}, {1, 1}}};

/// Adds what becomes of each mode, and of a resting particle, where something holds all particles.
void addHeld(const Scene& scene, std::vector<Mode>& modes) {
  const auto [term, hold] = holdingTerm(scene);
  if (term == nullptr) return;
  const double perMass = 1 / scene.particleMass;
  modes.push_back({0, 0});
  for (std::size_t k = 0, count = modes.size(); k < count; ++k) {
    const auto [w2, d] = modes[k];
    for (const auto& [ofStiffness, ofDamping] : kInTheLayer) {
      modes.push_back({w2 + ofStiffness * perMass * hold.stiffness, d + ofDamping * perMass * hold.damping});
    }
    if (hold.across > 0) modes.push_back({w2, d + perMass * hold.across});
  }
}

}  // namespace

ChebyshevTable::ChebyshevTable(const ChebyshevStages& stages)
    : b(std::size_t(stages.count) + 1), value(std::size_t(stages.count) + 1) {
  const int s = stages.count;
  w0 = 1 + stages.eps / (double(s) * s);
  // T_j, T'_j, T''_j at w0 by differentiating the recurrence T_j = 2 x T_(j-1) - T_(j-2).
  double t0 = 1, t1 = w0, d0 = 0, d1 = 1, e0 = 0, e1 = 0;
  value[0] = t0, value[1] = t1;
  for (int j = 2; j <= s; ++j) {
    const double t = 2 * w0 * t1 - t0, d = 2 * t1 + 2 * w0 * d1 - d0, e = 4 * d1 + 2 * w0 * e1 - e0;
    t0 = t1, t1 = t, d0 = d1, d1 = d, e0 = e1, e1 = e;
    value[std::size_t(j)] = t;
    b[std::size_t(j)] = e / (d * d);
  }
  b[0] = b[1] = b[2];
  w1 = d1 / e1;
}

Complex chebyshevGrowth(const ChebyshevStages& stages, Complex z) { return Polynomial(stages).at(z); }

std::vector<Mode> chebyshevModes(const Scene& scene, bool inPieces) {
  constexpr int kIntervals = 24;  // of the grid of phases, an axis
  const Lattice lattice(withoutBodies(scene));
  std::vector<Mode> all;
  lattice.forWaves(kIntervals, [&](double qx, double qy) {
    const std::array<Mode, 5> modes = lattice.modes(qx, qy);
    const bool axial = scene.damping == Damping::Axial;
    all.insert(all.end(), modes.begin(), axial ? modes.end() : modes.begin() + 3);  // the others repeat the first two
    if (!axial) all.push_back(lattice.anyDeformation(qx, qy));
  });
  addLeastDamped(scene, inPieces, all);
  addHeld(scene, all);
  return all;
}

ChebyshevStages chebyshevStages(std::span<const Mode> modes, double h) {
  std::vector<Complex> roots = upperRootsOf(modes);
  const std::vector<Polynomial>& all = polynomials();
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (holdsAll(all[k], h, roots)) return {all[k].s, kDamped.at(k % kDamped.size())};
  }
  return {};
}

ChebyshevReach::ChebyshevReach(std::span<const Mode> modes) : roots_(upperRootsOf(modes)) {
  for (const Complex& root : roots_) fastest_ = std::max(fastest_, std::abs(root));
}

/// From the stages on that reach far enough along the real axis, about 0.65 s^2; more are more likely to do than fewer.
bool ChebyshevReach::holds(double h) {
  constexpr double kReach = 0.65;
  const std::vector<Polynomial>& all = polynomials();
  const double enough = std::ceil(std::sqrt(std::min(1e6, h * fastest_) / kReach));
  const auto first = kDamped.size() * std::size_t(std::clamp(int(enough), 2, kMostChebyshevStages) - 2);
  const auto does = [&](const Polynomial& polynomial) { return holdsAll(polynomial, h, roots_); };
  return std::any_of(all.begin() + std::ptrdiff_t(first), all.end(), does) ||
         std::any_of(all.begin(), all.begin() + std::ptrdiff_t(first), does);
}

}  // namespace tyg
