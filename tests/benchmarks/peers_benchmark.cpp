// Tyg beside other programs on the same sheets, in one interleaved run; at the end a table of ratios by the least of
// the repetitions. Peers are built where their packages are installed: libboost-dev, libbullet-dev, libsundials-dev.
//   build/release/tests/peers_benchmark          counters: from_ours and error are fractions of the sheet's size
#include <algorithm>
#include <cstdio>
#include <limits>
#include <map>

#include "core/simulation/integrator.h"
#include "peers.h"
#include "study/limits/stability.h"
#include "tyg/methods.h"
#include "util/workers.h"

namespace tyg::peers {
namespace {

/// The method alone, as peers have it: no alarm.
template <class T>
void steps(benchmark::State& state, const char* methodName, Precision precision) {
  const Scene scene = curtain(kCount, precision);
  const Sheet sheet = makeSheet(scene);
  Workers workers(1);
  Forces<T> forces(scene, sheet, workers);
  State<T> cloth = startState<T>(sheet);
  const auto method = findMethod(methodName).make<T>(scene, sheet);
  for (auto _ : state) method->steps(forces, cloth, {0, 0, kStep}, kStepsPerRound);
  reportPerParticle(state);
}

struct Found {
  double dt = 0, error = 1;
  std::int64_t evaluations = 0;
};

/// The largest step of leapfrog, from 0.95 of its limit down by tenths, that comes within the wanted error.
Found largestStep() {
  const TwoSeconds& wanted = twoSeconds();
  if (!wanted.reference.usable()) return {};
  const Method& leapfrog = findMethod("leapfrog");
  Scene scene = wanted.scene;
  Found found{.dt = 0.95 * restLatticeLimit(scene, leapfrog) / 0.9};
  while (!(found.error <= TwoSeconds::kWanted)) {
    scene.dt = found.dt *= 0.9;
    const SampledMotion motion = sampledRun(scene, leapfrog, wanted.times, {.threads = 1, .observer = {}});
    found.error = wanted.errorOf(motion);
    found.evaluations = motion.forceEvaluations;
  }
  return found;
}

void twoSecondRun(benchmark::State& state) {
  static const Found kFound = largestStep();
  if (kFound.dt <= 0) return state.SkipWithError("the reference has no second opinion");
  Scene scene = twoSeconds().scene;
  scene.dt = kFound.dt;
  for (auto _ : state) {
    state.PauseTiming();
    Simulation simulation(scene, findMethod("leapfrog"), {.threads = 1});
    state.ResumeTiming();
    simulation.advanceTo(scene.duration);
  }
  state.counters["error"] = kFound.error;
  state.counters["dt"] = kFound.dt;
  state.counters["evaluations"] = double(kFound.evaluations);
}

/// Prints medians as the console does, and the table of comparisons at the end.
class Table : public benchmark::ConsoleReporter {
 public:
  Table() : ConsoleReporter(OO_Tabular) {}
  void ReportRuns(const std::vector<Run>& runs) override {
    std::vector<Run> medians;
    for (const Run& run : runs) {
      if (run.aggregate_name == "median" || run.error_occurred) medians.push_back(run);
      if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
      const auto [least, isNew] = least_.try_emplace(run.run_name.function_name, run.GetAdjustedCPUTime());
      if (!isNew) least->second = std::min(least->second, run.GetAdjustedCPUTime());
    }
    if (!medians.empty()) ConsoleReporter::ReportRuns(medians);
  }
  void Finalize() override {
    std::printf("\n%-32s %-28s %8s %8s\n", "peer", "ours", "times", "wanted");
    for (const Comparison& one : comparisons()) {
      if (!least_.contains(one.peer) || !least_.contains(one.ours)) continue;
      std::printf("%-32s %-28s %8.2f %8.1f\n", one.peer.c_str(), one.ours.c_str(), least_[one.peer] / least_[one.ours],
                  one.wanted);
    }
  }

 private:
  std::map<std::string, double> least_;  // processor time of one iteration
};

void addOurs() {
  benchmark::RegisterBenchmark("tyg/rk4/double", steps<double>, "rk4", Precision::Double);
  benchmark::RegisterBenchmark("tyg/symplectic-euler/float", steps<float>, "symplectic-euler", Precision::Float);
  benchmark::RegisterBenchmark("tyg/leapfrog/two_seconds", twoSecondRun)->Unit(benchmark::kMillisecond);
}

}  // namespace
}  // namespace tyg::peers

int main(int count, char** words) {
  using namespace tyg::peers;
  addOurs();
#ifdef TYG_PEER_ODEINT
  addOdeint();
#endif
#ifdef TYG_PEER_BULLET
  addBullet();
#endif
#ifdef TYG_PEER_CVODE
  addCvode();
#endif
  // Taking turns spares the comparison what the machine does meanwhile; options given by hand come later and win.
  std::vector<char*> all{words[0]};
  std::string defaults[] = {"--benchmark_enable_random_interleaving=true", "--benchmark_repetitions=5",
                            "--benchmark_min_time=0.1"};
  for (std::string& word : defaults) all.push_back(word.data());
  all.insert(all.end(), words + 1, words + count);
  int allCount = int(all.size());
  benchmark::Initialize(&allCount, all.data());
  if (benchmark::ReportUnrecognizedArguments(allCount, all.data())) return 2;
  Table table;
  benchmark::RunSpecifiedBenchmarks(&table);
  return 0;
}
