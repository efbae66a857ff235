// How often the advice of `tyg advise` keeps its promise, and how far its choice is from the cheapest one that an
// exhaustive search finds: over the built-in scenes and over random ones of fixed seeds. Costs are work times its
// calibrated cost, in the processor's own time of this thread. Usage: advice_statistics [random scenes = 40] [built-in
// scenes too: 0 or 1 = 1]. Prints a CSV row for each case as it comes, then both figures.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>

#include "../test_systems.h"
#include "study/advice.h"
#include "study/diet_changes.h"
#include "study/error.h"
#include "study/stability.h"
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

/// The least cost of all settings on fine ladders whose error is within, none dearer than `most` s being tried.
double exhaustive(const Scene& scene, const Reference& reference, double error, double most, const UnitCost& cost) {
  constexpr double kFiner = 1.15, kLoosestOfLimit = 1.02;
  double best = most;
  for (const Method& method : methods()) {
    if (!advisable(method) || !takes(method, scene)) continue;
    for (const Precision precision : {Precision::Double, Precision::Float}) {
      Scene setting = scene;
      setting.integrator = method.name, setting.precision = precision;
      double limit = restLatticeLimit(scene, method);
      if (limit == 0) limit = restLatticeLimit(scene, findMethod("symplectic-euler"));
      const double interval = reference.motion.times.front();
      double knob =
          method.adaptive ? 0.02 * reference.size : std::min(interval, limit > 0 ? kLoosestOfLimit * limit : interval);
      for (int rung = 0; rung < 200; ++rung, knob /= method.adaptive ? 2 : kFiner) {
        const double step = interval / std::ceil(interval / knob - 1e-9);
        (method.adaptive ? setting.tolerance : setting.dt) = method.adaptive ? knob : step;
        const SampledMotion run = sampledRun(setting, method, reference.motion.times);
        if (run.status != Status::Ok) continue;
        const double seconds = double(workOf(method, run)) * cost(setting, 1);
        if (seconds >= best) break;
        if (motionError(run, reference.motion).rms <= error) {
          best = seconds;
          break;
        }
      }
    }
  }
  return best;
}

struct Tally {
  int asked = 0, held = 0, near = 0, cannot = 0;
  double worst = 1;
};

void judge(const Scene& scene, double ofSize, Tally& tally) {
  CostMeter meter(scene, 1, threadTime);
  AdvicePlan plan;
  plan.request.error = ofSize * makeSheet(scene).size();
  for (const Method& method : methods()) plan.methods.push_back(&method);
  plan.cost = [&](const Scene& priced, int threads) { return meter.secondsPerUnit(priced, threads); };
  plan.clock = threadTime;
  const Advice advice = quickAdvice(scene, plan);
  const Reference reference = makeReference(scene, 1, [](double) { return true; });
  std::printf("%s,%d,%d,%.3g,", scene.name.c_str(), scene.columns, scene.rows, plan.request.error);
  if (!advice.met || !reference.usable()) {
    ++tally.cannot;
    std::printf(",,,,,,%s\n", reference.usable() ? "cannot-be-met" : "no-reference");
    return;
  }
  const Trial& choice = *advice.promise;
  const double achieved =
      motionError(sampledRun(choice.scene, findMethod(choice.scene.integrator), reference.motion.times),
                  reference.motion)
          .rms;
  const double best = exhaustive(scene, reference, plan.request.error, choice.seconds, plan.cost);
  const double ratio = choice.seconds / best;
  const bool held = achieved <= plan.request.error;
  ++tally.asked;
  tally.held += held ? 1 : 0;
  tally.near += ratio <= 1.5 ? 1 : 0;
  tally.worst = std::max(tally.worst, ratio);
  std::printf("%s,%s,%.4g,%.3g,%.4g,%.3f,%s\n", choice.scene.integrator.c_str(), nameOf(choice.scene.precision),
              choice.scene.dt, achieved, choice.seconds, ratio, held ? "held" : "missed");
  std::fflush(stdout);
}

void report(const char* what, const Tally& tally) {
  std::printf(
      "%s: the promise held in %d of %d cases; the choice within 1.5 times the best in %d (worst %.2f); %d could "
      "not be met\n",
      what, tally.held, tally.asked, tally.near, tally.worst, tally.cannot);
}

}  // namespace
}  // namespace tyg::test

int main(int count, char** words) {
  using namespace tyg::test;
  const int random = count > 1 ? std::atoi(words[1]) : 40;
  const bool builtin = count <= 2 || std::atoi(words[2]) != 0;
  std::puts("scene,columns,rows,asked_m,integrator,precision,dt,achieved_m,seconds,ratio_to_best,status");
  Tally ofRandom, ofBuiltin;
  for (int seed = 1; seed <= random; ++seed) {
    Numbers numbers(1000U + unsigned(seed));
    judge(randomCloth(unsigned(seed)), powerOfTen(numbers, -6, -1.5), ofRandom);
  }
  for (const tyg::BuiltinScene& scene : tyg::builtinScenes()) {
    if (!builtin || scene.name.starts_with("fail-")) continue;
    for (const double ofSize : {1e-2, 1e-4}) judge(tyg::loadScene(std::string(scene.name)), ofSize, ofBuiltin);
  }
  report("random scenes", ofRandom);
  if (builtin) report("built-in scenes", ofBuiltin);
  return 0;
}
