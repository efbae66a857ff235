// What one step costs, in ns per particle, against the way teaching code does it: a list of springs between particles
// kept as structures. Ratios count. On a quiet machine, interleaved, after `cmake --build --preset release`:
//   build/release/tests/steps_benchmark --benchmark_enable_random_interleaving=true --benchmark_repetitions=5
#include <benchmark/benchmark.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "core/forces/row_kernel.h"
#include "tyg/methods.h"
#include "tyg/simulation.h"

namespace tyg {
namespace {

constexpr double kStep = 1e-4;      // s, far from every limit
constexpr int kStepsPerRound = 64;  // as a simulation takes them between two energy checks

/// The curtain on count x count particles of the same mass and spacing.
Scene curtain(int count, Precision precision) {
  Scene scene = loadScene("curtain");
  scene.columns = scene.rows = count;
  scene.precision = precision;
  scene.dt = kStep;
  return scene;
}

void reportPerParticle(benchmark::State& state, int count) {
  const double particleSteps = double(count) * count * kStepsPerRound * double(state.iterations());
  state.counters["per_particle_step"] =
      benchmark::Counter(particleSteps, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// Arguments: particles along a side, threads. `level`: the machine's best where empty. `pushed`: one particle is
/// pushed all the time.
void steps(benchmark::State& state, const std::string& method, Precision precision,
           std::optional<VectorLevel> level = {}, bool pushed = false) {
  if (level > bestVectorLevel()) return state.SkipWithError("this machine does not have that vector level");
  useVectorLevel(level);
  const int count = int(state.range(0));
  Scene scene = curtain(count, precision);
  if (pushed) scene.pushes = {{.particle = Place{.name = "middle"}, .force = {0, 0, 0.01}, .at = 0, .duration = 1e6}};
  Simulation simulation(scene, findMethod(method), {.threads = int(state.range(1))});
  double time = 0;
  for (auto _ : state) {
    time += kStepsPerRound * kStep;
    simulation.advanceTo(time);
  }
  useVectorLevel({});
  if (simulation.status() != Status::Ok) state.SkipWithError("the simulation failed");
  reportPerParticle(state, count);
}

template <class T>
struct PlainVector {
  T x = 0, y = 0, z = 0;
};
template <class T>
PlainVector<T> operator-(const PlainVector<T>& a, const PlainVector<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
PlainVector<T> operator*(T s, const PlainVector<T>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class T>
void add(PlainVector<T>& a, const PlainVector<T>& b) {
  a.x += b.x, a.y += b.y, a.z += b.z;
}

/// Symplectic Euler on particles as structures and springs as a list: the same arithmetic, as teaching code has it.
template <class T>
class PlainSheet {
 public:
  explicit PlainSheet(const Scene& scene) : sheet_(makeSheet(scene)), particles_(std::size_t(sheet_.count())) {
    for (int k = 0; k < sheet_.count(); ++k) {
      const Vec3 at = sheet_.startPosition(k);
      particles_[std::size_t(k)].x = {T(at.x), T(at.y), T(at.z)};
    }
    for (const int pin : sheet_.pins) particles_[std::size_t(pin)].isFree = 0;
    list(scene.structural, Family::Structural);
    list(scene.shear, Family::Shear);
    list(scene.bend, Family::Bend);
  }

  void step(T h) {
    const T mass = T(sheet_.particleMass);
    for (Particle& p : particles_) p.f = {0, -mass * T(9.81), 0};
    for (const Spring& s : springs_) {
      Particle &a = particles_[std::size_t(s.a)], &b = particles_[std::size_t(s.b)];
      const PlainVector<T> d = b.x - a.x;
      const T length = std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
      PlainVector<T> f = (s.ks * (length - s.rest) / length) * d;
      add(f, s.kd * (b.v - a.v));
      add(a.f, f);
      add(b.f, T(-1) * f);
    }
    for (Particle& p : particles_) {
      add(p.v, (p.isFree * h / mass) * p.f);
      add(p.x, h * p.v);
    }
  }

 private:
  struct Particle {
    PlainVector<T> x, v, f;
    T isFree = 1;
  };
  struct Spring {
    int a, b;
    T ks, kd, rest;
  };
  void list(const SpringFamily& law, Family family) {
    for (const SpringEnds& ends : springsOf(sheet_, family)) {
      springs_.push_back({ends.first, ends.second, T(law.ks), T(law.kd), T(restLength(sheet_, family))});
    }
  }

  Sheet sheet_;
  std::vector<Particle> particles_;
  std::vector<Spring> springs_;
};

template <class T>
void listOfSprings(benchmark::State& state) {
  const int count = int(state.range(0));
  PlainSheet<T> sheet(curtain(count, Precision::Double));
  for (auto _ : state) {
    for (int k = 0; k < kStepsPerRound; ++k) sheet.step(T(kStep));
  }
  reportPerParticle(state, count);
}

void sizes(benchmark::internal::Benchmark* benchmark) {
  for (const int count : {20, 64, 256, 1024}) benchmark->Args({count, 1});
  for (const int count : {256, 1024}) benchmark->Args({count, 2});
  benchmark->UseRealTime()->Unit(benchmark::kMillisecond);
}

BENCHMARK_TEMPLATE(listOfSprings, float)->Name("list_of_springs/float")->Arg(64)->Arg(256)->UseRealTime();
BENCHMARK_TEMPLATE(listOfSprings, double)->Name("list_of_springs/double")->Arg(64)->Arg(256)->UseRealTime();
BENCHMARK_CAPTURE(steps, symplectic_euler_float, "symplectic-euler", Precision::Float)->Apply(sizes);
BENCHMARK_CAPTURE(steps, symplectic_euler_double, "symplectic-euler", Precision::Double)->Apply(sizes);
BENCHMARK_CAPTURE(steps, leapfrog_float, "leapfrog", Precision::Float)->Apply(sizes);
BENCHMARK_CAPTURE(steps, leapfrog_double, "leapfrog", Precision::Double)->Apply(sizes);
BENCHMARK_CAPTURE(steps, symplectic_euler_float_avx2, "symplectic-euler", Precision::Float, VectorLevel::V3)
    ->Apply(sizes);
BENCHMARK_CAPTURE(steps, symplectic_euler_double_avx2, "symplectic-euler", Precision::Double, VectorLevel::V3)
    ->Apply(sizes);
BENCHMARK_CAPTURE(steps, leapfrog_float_pushed, "leapfrog", Precision::Float, std::nullopt, true)->Apply(sizes);
BENCHMARK_CAPTURE(steps, leapfrog_double_pushed, "leapfrog", Precision::Double, std::nullopt, true)->Apply(sizes);
BENCHMARK_CAPTURE(steps, rk4_double, "rk4", Precision::Double)->Args({64, 1})->UseRealTime();

}  // namespace
}  // namespace tyg

BENCHMARK_MAIN();
