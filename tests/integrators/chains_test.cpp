// Chains, whose modes and shapes are known: standing waves, sag, a hanging chain, a pendulum, a catenary. Tight against
// the discrete chain, loose against the continuum.
#include <gtest/gtest.h>

#include <numbers>

#include "test_systems.h"
#include "tyg/methods.h"

namespace tyg::test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kGravity = 9.81;

/// A row of particles of 1 kg along x, both ends pinned.
Scene row(int particles, double ks) {
  Scene scene = emptyWorld(particles, 1);
  scene.pins = {{"top-left"}, {"top-right"}};
  scene.structural = {ks, 0};
  return scene;
}

struct Wave {
  double stretch;    ///< of the row before it is set off: 1 is rest
  Vec3 along;        ///< direction of the motion
  double stiffness;  ///< of one link in that direction, N/m
};

/// Each mode of the row, started at its crest, is back at its crest after a period.
void expectStandingWaves(const Wave& wave) {
  constexpr int kLinks = 8;
  constexpr double kAmplitude = 1e-5;
  for (int mode = 1; mode < kLinks; ++mode) {
    Bench<double> bench(row(kLinks + 1, 100));
    Points still = bench.points();
    for (Vec3& x : still.x) x = wave.stretch * x;
    Points crest = still;
    for (int i = 1; i < kLinks; ++i) {
      crest.x[std::size_t(i)] = crest.x[std::size_t(i)] + kAmplitude * std::sin(mode * kPi * i / kLinks) * wave.along;
    }
    const double frequency = 2 * std::sqrt(wave.stiffness) * std::sin(mode * kPi / (2 * kLinks));
    for (const double periods : {0.25, 1.0}) {
      bench.set(crest);
      bench.advance(findMethod("rk4"), periods * 2 * kPi / frequency, 2000);
      // The wave's own nonlinearity is of the order of its amplitude squared.
      EXPECT_LE(distance(bench.points(), periods == 1 ? crest : still), 1e-4 * kAmplitude) << "mode " << mode;
    }
  }
}

TEST(Row, SwingsLengthwiseInItsKnownModes) { expectStandingWaves({1, {1, 0, 0}, 100}); }

TEST(Row, SwingsSidewaysInItsKnownModesWhereItIsStretched) {
  constexpr double kStretch = 1.5, kTension = 100 * (kStretch - 1);
  expectStandingWaves({kStretch, {0, 0.6, 0.8}, kTension / kStretch});
}

TEST(HangingChain, SagsByTheSumOfItsLinksLoads) {
  constexpr int kLinks = 10;
  constexpr double kStiffness = 1000, kMass = 0.1;
  Scene scene = hangingChain(kLinks, 0.3, kMass, {kStiffness, 0});
  scene.drag = 2;  // the slowest mode has then died out by e^-40
  Bench<double> bench(scene);
  bench.advance(findMethod("rk4"), 8, 4000);
  const double sag = kMass * kGravity * kLinks * (kLinks + 1) / (2 * kStiffness);
  EXPECT_NEAR(bench.points().x[kLinks].y, -kLinks * 0.3 - sag, 1e-12);
}

// ---- a hanging chain of 1 m swinging sideways -----------------------------------------------------------------------

constexpr int kLinks = 20;
constexpr double kLinkLength = 1.0 / kLinks;

/// First mode of small swings of equal masses on links of equal length: inverse iteration on
/// w^2 x_i = g/l [ (n-i+1)(x_i - x_{i-1}) - (n-i)(x_{i+1} - x_i) ], x_0 = 0.
struct Mode {
  double frequency;
  std::vector<double> shape;  ///< 1 at the free end
};
Mode firstMode() {
  std::vector<double> shape(kLinks + 1, 1.0);
  double scale = 0;
  for (int sweep = 0; sweep < 60; ++sweep) {
    // The load to the right of a link, over the link's tension, is the slope there.
    std::vector<double> next(kLinks + 1, 0.0);
    for (int i = 1; i <= kLinks; ++i) {
      double load = 0;
      for (int j = i; j <= kLinks; ++j) load += shape[std::size_t(j)];
      next[std::size_t(i)] = next[std::size_t(i - 1)] + load * kLinkLength / (kGravity * (kLinks - i + 1));
    }
    scale = next.back();
    for (double& x : next) x /= scale;
    shape = next;
  }
  return {std::sqrt(1 / scale), shape};
}

TEST(HangingChain, OfTwentyLinksHasItsKnownFirstFrequency) {
  EXPECT_NEAR(firstMode().frequency, 3.720, 5e-4);
  EXPECT_NEAR(firstMode().frequency, 3.766, 0.02 * 3.766);  // the continuum: J0(2 w sqrt(L/g)) = 0
}

TEST(HangingChain, SwingsAtItsFirstFrequency) {
  constexpr double kStiffness = 1e6, kMass = 0.05, kAmplitude = 1e-4;
  const Mode mode = firstMode();
  Bench<double> bench(hangingChain(kLinks, kLinkLength, kMass, {kStiffness, 0}));
  double y = 0;
  for (int i = 1; i <= kLinks; ++i) {
    y -= kLinkLength + kMass * kGravity * (kLinks - i + 1) / kStiffness;
    bench.state.position.set(i, {kAmplitude * mode.shape[std::size_t(i)], y, 0});
  }
  const double quarter = kPi / 2 / mode.frequency;
  const auto end = [&] { return bench.state.position.get(kLinks).x / kAmplitude; };
  bench.advance(findMethod("rk4"), quarter, 3000);
  EXPECT_NEAR(end(), 0, 1e-3);  // links stretched by up to 2e-4 of their length
  bench.advance(findMethod("rk4"), 3 * quarter, 9000);
  EXPECT_NEAR(end(), 1, 1e-3);
}

TEST(Pendulum, SwingsSlowerByTheKnownRatioAtNinetyDegrees) {
  constexpr double kRatio = 1.18034;  // 2/pi K(sin 45 degrees)
  Scene scene = oscillator(1e8, 0);   // stretched by 3e-7 at most
  scene.gravity = {0, -kGravity, 0};
  Bench<double> bench(scene);  // starts level, 1 m to the right of the pin
  const double quarter = kRatio * kPi / 2 / std::sqrt(kGravity);
  bench.advance(findMethod("rk4"), quarter, 10000);
  const Vec3 arm = bench.points().x[1] - bench.points().x[0], velocity = bench.points().v[1];
  EXPECT_NEAR(quarter - arm.x / velocity.x, quarter, 1e-5 * quarter);  // when it really stands below the pin
  EXPECT_NEAR(arm.y, -1, 1e-6);
}

// ---- a catenary: 1000 m of cable between two masts 800 m apart, one 100 m higher
// -------------------------------------

constexpr double kCable = 1000, kSpan = 800, kHeight = 100;

/// H/w, m: the root a of 2 a sinh(span / 2a) = sqrt(length^2 - height^2), by bisection.
double catenaryParameter() {
  double low = 100, high = 10000;
  for (int i = 0; i < 100; ++i) {
    const double a = (low + high) / 2;
    (2 * a * std::sinh(kSpan / 2 / a) > std::sqrt(kCable * kCable - kHeight * kHeight) ? low : high) = a;
  }
  return low;
}

TEST(Catenary, PullsAtItsMastsAsKnown) {
  constexpr int kCableLinks = 50;
  EXPECT_NEAR(catenaryParameter(), 342.24, 0.01);
  Scene scene = row(kCableLinks + 1, 2e4);
  scene.spacing = kCable / kCableLinks;
  scene.gravity = {0, -kGravity, 0};
  scene.drag = 0.15;
  Bench<double> bench(scene);
  Points at = bench.points();
  for (int i = 0; i <= kCableLinks; ++i) {
    const double share = double(i) / kCableLinks;
    at.x[std::size_t(i)] = {kSpan * share, kHeight * share - 1200 * share * (1 - share), 0};
  }
  bench.set(at);
  bench.advance(findMethod("leapfrog"), 300, 60000);
  at = bench.points();
  EXPECT_LE(distance({at.v, {}}, {std::vector<Vec3>(at.v.size()), {}}), 1e-6) << "at rest";
  const Vec3 link = at.x[1] - at.x[0];
  const double tension = 2e4 * (length(link) - scene.spacing), weight = kGravity * kCableLinks / kCable;  // N, N/m
  EXPECT_NEAR(tension * link.x / length(link) / weight, catenaryParameter(), 0.005 * catenaryParameter());
}

}  // namespace
}  // namespace tyg::test
