// What the comparisons with other programs share: the sheets, the force that peers step, and the table of ratios.
// Must not know: any peer.
#pragma once

#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "study/motion/reference.h"
#include "tyg/simulation.h"

namespace tyg::peers {

constexpr int kCount = 64;          ///< particles along each side of the sheet that is stepped
constexpr int kStepsPerRound = 16;  ///< one iteration of every benchmark that counts steps
constexpr double kStep = 1e-4;      ///< s, far from every limit

/// The curtain on count x count particles of the same mass and spacing.
Scene curtain(int count, Precision precision);
/// Says in the benchmark's counters what one step of one particle costs.
void reportPerParticle(benchmark::State& state);

/// The force as teaching code has it: a list of springs between particles that lie one after the other in memory, six
/// numbers each (x, y, z, vx, vy, vz). For the relative law of damping, in double.
class SpringList {
 public:
  explicit SpringList(const Scene& scene);
  [[nodiscard]] std::vector<double> start() const;  ///< the scene's start shape at rest
  [[nodiscard]] std::size_t numbers() const { return 6 * isFree_.size(); }
  /// dy = dy/dt
  void operator()(const double* y, double* dy) const;
  void push(int particle, const Vec3& force) { pushed_ = particle, pushForce_ = force; }
  void clearPush() { pushed_ = -1; }
  static std::vector<Vec3> positionsOf(const std::vector<double>& y);

 private:
  struct Spring {
    std::size_t a, b;
    double ks, kd, rest;
  };
  void list(const Sheet& sheet, const SpringFamily& law, Family family);

  Sheet sheet_;
  Vec3 gravity_;
  std::vector<double> isFree_;  // 1 or 0
  std::vector<Spring> springs_;
  int pushed_ = -1;
  Vec3 pushForce_;
};

/// Positions of a simulation's particles, m.
std::vector<Vec3> positionsOf(const Simulation& simulation);

/// The two seconds of a 20x20 sheet that are run to a wanted error.
struct TwoSeconds {
  Scene scene;
  std::vector<double> times;  ///< s, of samples
  Reference reference;
  static constexpr double kWanted = 1e-5;  ///< error over the sheet's size
  /// E over the size. NaN where the motion is not complete.
  [[nodiscard]] double errorOf(const SampledMotion& motion) const;
};
/// Its reference is computed at the first call.
const TwoSeconds& twoSeconds();

/// One line of the table at the end: how many times longer `peer` takes than `ours`, both named as benchmarks are.
struct Comparison {
  std::string peer, ours;
  double wanted;  ///< times at least
};
std::vector<Comparison>& comparisons();

// One file per peer, in the program where its package is installed.
void addOdeint();
void addBullet();
void addCvode();

}  // namespace tyg::peers
