// How often the advice of `tyg advise` keeps its promise, and how far its choice is from the best one that an
// exhaustive search finds: over the built-in scenes and over random ones of fixed seeds, for errors and for budgets.
// Costs are work times its calibrated cost, in the processor's own time of this thread. Usage: advice_statistics
// [random scenes = 40] [built-in scenes too: 0 or 1 = 1]. Prints a CSV row for each case as it comes, then the figures.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "../test_systems.h"
#include "study/advice/advice.h"
#include "study/diet/diet_changes.h"
#include "study/limits/stability.h"
#include "study/motion/error.h"
#include "tyg/methods.h"

namespace tyg::test {
namespace {

double threadTime(int /*threads*/) {
  std::timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

double powerOfTen(Numbers& numbers, double low, double high) { return std::pow(10, numbers.between(low, high)); }

/// A cloth as people make them: half a kilogram to a tenth of one a square metre, soft to stiff, hardly to well damped.
Scene randomCloth(unsigned seed) {
  Numbers numbers(seed);
  Scene scene;
  scene.name = "random-" + std::to_string(seed);
  scene.columns = int(numbers.between(4, 12)), scene.rows = int(numbers.between(4, 12));
  scene.spacing = numbers.between(0.03, 0.12);
  scene.particleMass = numbers.between(0.1, 0.5) * scene.spacing * scene.spacing;
  scene.start = numbers.coin() ? Start::Flat : Start::Hanging;
  scene.damping = numbers.between(0, 1) < 0.25 ? Damping::Axial : Damping::Relative;
  const double ks = powerOfTen(numbers, 1, 4), ratio = powerOfTen(numbers, -2.5, 0);
  const double kd = ratio * std::sqrt(ks * scene.particleMass);
  scene.structural = {ks, kd};
  if (numbers.between(0, 1) < 0.8) scene.shear = {ks * numbers.between(0.2, 1), kd};
  if (numbers.between(0, 1) < 0.7) scene.bend = {ks * numbers.between(0.01, 0.3), kd};
  if (numbers.coin()) scene.drag = scene.particleMass * numbers.between(0.05, 1);
  const char* const kPins[] = {"top", "left", "corners", "top-left"};
  scene.pins = {{kPins[std::size_t(numbers.between(0, 3.999))]}};
  if (numbers.coin()) {
    const double weight = scene.particleMass * scene.columns * scene.rows * 9.81;
    scene.pushes = {{{"middle"}, numbers.inCube(0.5 * weight), 0.1, 0.1}};
  }
  scene.duration = 0.6;
  scene.integrator = "rk4";
  scene.dt = 0.5 * restLatticeLimit(scene, findMethod("rk4"));
  return scene;
}

struct Outcome {
  double error, seconds;
};

/// All settings on the fine ladder of one method in one precision, from loose to tight, that cost at most `most` s;
/// none after the first whose error is within `enough`.
void climb(const Scene& scene, const Method& method, const Reference& reference, double enough, double most,
           const UnitCost& cost, std::vector<Outcome>& outcomes) {
  constexpr double kFiner = 1.15, kLoosestOfLimit = 1.02, kSlack = 1.05;
  double limit = restLatticeLimit(scene, method);
  if (limit == 0) limit = restLatticeLimit(scene, findMethod("symplectic-euler"));
  const double interval = reference.motion.times.front();
  double parameter =
      method.adaptive ? 0.02 * reference.size : std::min(interval, limit > 0 ? kLoosestOfLimit * limit : interval);
  Scene setting = scene;
  for (int rung = 0; rung < 200; ++rung, parameter /= method.adaptive ? 2 : kFiner) {
    const double step = interval / std::ceil(interval / parameter - 1e-9);
    (method.adaptive ? setting.tolerance : setting.dt) = method.adaptive ? parameter : step;
    SamplingOptions options;
    options.threads = 1;
    const double unit = cost(setting, 1);
    options.mostEvaluations = std::int64_t(kSlack * most / unit) + 1;
    const SampledMotion run = sampledRun(setting, method, reference.motion.times, options);
    const double seconds = double(workOf(method, run)) * unit;
    if (seconds > most || run.stopped) return;
    if (run.status != Status::Ok) continue;
    outcomes.push_back({motionError(run, reference.motion).rms, seconds});
    if (outcomes.back().error <= enough) return;
  }
}

std::vector<Outcome> exhaustive(const Scene& scene, const Reference& reference, double enough, double most,
                                const UnitCost& cost) {
  std::vector<Outcome> outcomes;
  for (const Method& method : methods()) {
    if (!method.advisable || !takes(method, scene)) continue;
    for (const Precision precision : {Precision::Double, Precision::Float}) {
      Scene setting = scene;
      setting.integrator = method.name, setting.precision = precision;
      climb(setting, method, reference, enough, most, cost, outcomes);
    }
  }
  return outcomes;
}

/// The cheapest of those within an error; `otherwise` where there is none.
double leastSeconds(const std::vector<Outcome>& outcomes, double error, double otherwise) {
  for (const Outcome& outcome : outcomes) {
    if (outcome.error <= error) otherwise = std::min(otherwise, outcome.seconds);
  }
  return otherwise;
}

double leastError(const std::vector<Outcome>& outcomes, double otherwise) {
  for (const Outcome& outcome : outcomes) otherwise = std::min(otherwise, outcome.error);
  return otherwise;
}

struct Tally {
  int asked = 0, held = 0, near = 0, cannot = 0;
  std::vector<double> ratios, errorRatios;
};

/// What is judged of one choice: it cost so many times what is cheapest for its error (or for the error asked for), and
/// within a budget it is so many times less exact than the best.
void judge(const Scene& scene, const Request& request, Tally& tally) {
  CostMeter meter(scene, 1, threadTime);
  AdvicePlan plan;
  plan.request = request;
  for (const Method& method : methods()) plan.methods.push_back(&method);
  plan.cost = [&](const Scene& priced, int threads) { return meter.secondsPerUnit(priced, threads); };
  plan.clock = threadTime;
  const Advice advice = quickAdvice(scene, plan);
  const Reference reference = makeReference(scene, 1, [](double) { return true; });
  const bool byError = request.error > 0;
  std::printf("%s,%d,%d,%.3g,%s,%d,", scene.name.c_str(), scene.columns, scene.rows,
              byError ? request.error : request.budget, byError ? "m" : "s", advice.runs);
  if (!advice.met || !reference.usable()) {
    ++tally.cannot;
    std::printf(",,,,,,,%s\n", reference.usable() ? "cannot-be-met" : "no-reference");
    return;
  }
  const Trial& choice = *advice.promise;
  const SampledMotion run = sampledRun(choice.scene, findMethod(choice.scene.integrator), reference.motion.times);
  // Errors below what the reference is known to are all the same.
  const double floor = std::max(advice.knowable, 3 * reference.disagreement.back());
  const double achieved = std::max(motionError(run, reference.motion).rms, byError ? 0 : floor);
  const double budget = request.budget * scene.duration / kFrame, within = byError ? request.error : achieved;
  const std::vector<Outcome> outcomes =
      exhaustive(scene, reference, byError ? within : floor, byError ? choice.seconds : budget, plan.cost);
  const double ratio = choice.seconds / leastSeconds(outcomes, within, choice.seconds);
  const double errorRatio = byError ? 1 : achieved / std::max(leastError(outcomes, achieved), floor);
  const bool held = byError ? achieved <= request.error : choice.seconds <= budget;
  ++tally.asked;
  tally.held += held ? 1 : 0;
  tally.near += ratio <= 1.5 ? 1 : 0;
  tally.ratios.push_back(ratio), tally.errorRatios.push_back(errorRatio);
  std::printf("%s,%s,%.4g,%.3g,%.4g,%.3f,%.3f,%s\n", choice.scene.integrator.c_str(), nameOf(choice.scene.precision),
              findMethod(choice.scene.integrator).adaptive ? choice.scene.tolerance : choice.scene.dt, achieved,
              choice.seconds, ratio, errorRatio, held ? "held" : "missed");
  std::fflush(stdout);
}

/// Between what the cheapest stable run costs, about, and a hundred times as much.
Request randomBudget(const Scene& scene, Numbers& numbers) {
  CostMeter meter(scene, 1, threadTime);
  Scene cheap = scene;
  cheap.integrator = "leapfrog", cheap.precision = Precision::Float;
  cheap.dt = kShareOfLimit * restLatticeLimit(scene, findMethod("leapfrog"));
  const double least = meter.secondsPerUnit(cheap, 1) * scene.duration / cheap.dt;
  return {.error = 0, .budget = frameSeconds(least * powerOfTen(numbers, 0.1, 2), scene.duration)};
}

void report(const char* what, Tally& tally, bool byError) {
  const auto middle = [](std::vector<double>& values) {
    std::ranges::sort(values);
    return values.empty() ? 1 : values[values.size() / 2];
  };
  const auto worst = [](const std::vector<double>& values) { return values.empty() ? 1 : std::ranges::max(values); };
  std::printf(
      "%s: the promise held in %d of %d cases; the cost within 1.5 times the best for %s in %d (middle %.2f, "
      "worst %.2f); %d could not be met\n",
      what, tally.held, tally.asked, byError ? "that error" : "what it achieves", tally.near, middle(tally.ratios),
      worst(tally.ratios), tally.cannot);
  if (byError) return;
  const auto near = std::ranges::count_if(tally.errorRatios, [](double ratio) { return ratio <= 1.5; });
  std::printf("%s: its error within 1.5 times the least for that budget in %d of %d (middle %.2f, worst %.2f)\n", what,
              int(near), tally.asked, middle(tally.errorRatios), worst(tally.errorRatios));
}

}  // namespace
}  // namespace tyg::test

int main(int count, char** words) {
  using namespace tyg::test;
  const int random = count > 1 ? std::atoi(words[1]) : 40;
  const bool builtin = count <= 2 || std::atoi(words[2]) != 0;
  std::puts(
      "scene,columns,rows,asked,unit,runs,integrator,precision,parameter,achieved_m,seconds,cost_ratio,error_ratio,"
      "status");
  Tally errors, budgets, errorsOfBuiltin, budgetsOfBuiltin;
  for (int seed = 1; seed <= random; ++seed) {
    const tyg::Scene scene = randomCloth(unsigned(seed));
    Numbers numbers(1000U + unsigned(seed));
    judge(scene, {.error = powerOfTen(numbers, -6, -1.5) * tyg::makeSheet(scene).size()}, errors);
    judge(scene, randomBudget(scene, numbers), budgets);
  }
  for (const tyg::BuiltinScene& scene : tyg::builtinScenes()) {
    if (!builtin || scene.name.starts_with("fail-")) continue;
    const tyg::Scene loaded = tyg::loadScene(std::string(scene.name));
    for (const double ofSize : {1e-2, 1e-4}) {
      judge(loaded, {.error = ofSize * tyg::makeSheet(loaded).size()}, errorsOfBuiltin);
    }
    for (const double budget : {50e-6, 1e-3}) judge(loaded, {.budget = budget}, budgetsOfBuiltin);
  }
  report("random scenes, errors", errors, true);
  report("random scenes, budgets", budgets, false);
  if (!builtin) return 0;
  report("built-in scenes, errors", errorsOfBuiltin, true);
  report("built-in scenes, budgets", budgetsOfBuiltin, false);
  return 0;
}
