// The run stops at every sample time; the edges of pushes, winds and motions choose how many there are.
#include "study/motion/sampled_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/simulation/timetable.h"

namespace tyg {
namespace {

constexpr int kFewestSamples = 20, kMostSamples = 64;

bool edgesFallOn(const Scene& scene, int samples) {
  constexpr double kRounding = 1e-9;
  return std::ranges::all_of(edgesWithin(scene), [&](double edge) {
    const double sample = edge / scene.duration * samples;
    return std::abs(sample - std::round(sample)) < kRounding;
  });
}

std::vector<Vec3> positionsOf(const Simulation& simulation) {
  std::vector<Vec3> positions;
  const int count = simulation.sheet().count();
  positions.reserve(static_cast<std::size_t>(count));
  for (int particle = 0; particle < count; ++particle) positions.push_back(simulation.position(particle));
  return positions;
}

}  // namespace

std::vector<double> sampleTimes(const Scene& scene) {
  int samples = kFewestSamples;
  while (samples < kMostSamples && !edgesFallOn(scene, samples)) ++samples;
  if (!edgesFallOn(scene, samples)) samples = kFewestSamples;
  std::vector<double> times;
  for (int k = 1; k <= samples; ++k) times.push_back(k == samples ? scene.duration : scene.duration * k / samples);
  return times;
}

SampledMotion sampledRun(const Scene& scene, const Method& method, const std::vector<double>& times,
                         const SamplingOptions& options) {
  Simulation simulation(scene, method,
                        {.threads = options.threads, .ledger = options.ledger, .device = options.device});
  SampledMotion motion;
  if (!options.ledger) motion.energyDrift = std::numeric_limits<double>::quiet_NaN();
  simulation.observe([&] {
    const bool tooMany = options.mostEvaluations > 0 && simulation.forceEvaluations() > options.mostEvaluations;
    if (tooMany || (options.observer && !options.observer(simulation.time()))) motion.stopped = true;
    return !motion.stopped;
  });
  for (const double time : times) {
    simulation.advanceTo(time);
    motion.status = simulation.status();
    if (motion.status != Status::Ok || motion.stopped) break;
    motion.times.push_back(time);
    motion.positions.push_back(positionsOf(simulation));
    motion.missing.push_back(simulation.sheet().missing);
    const Ledger ledger = simulation.ledger();
    motion.energies.push_back(ledger.mechanical());
    if (options.ledger) motion.energyDrift = std::max(motion.energyDrift, std::abs(ledger.drift));
  }
  motion.steps = simulation.steps();
  motion.forceEvaluations = simulation.forceEvaluations();
  motion.largestStep = simulation.largestStep();
  motion.ledger = simulation.ledger();
  return motion;
}

}  // namespace tyg
