// Every method in turn, with the scene's damping and without: its limit is computed first, and is where the search for
// the measured one begins.
#include "study/limits/stability_study.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/forces/term.h"
#include "study/limits/measured_limit.h"
#include "tyg/methods.h"

namespace tyg {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// Where the search begins: at the prediction, or where nothing is stable at a step that certainly fails.
double firstTrial(const Scene& scene, const StepLimit& limit) {
  return limit.predicted > 0 ? limit.predicted : restLatticeLimit(scene, findMethod("symplectic-euler"));
}

void measure(StabilityCase& entry, const Scene& scene, const StabilityPlan& plan,
             const std::function<bool()>& observer) {
  entry.atRest = entry.inMotion = kUnknown;
  const double begin = firstTrial(scene, entry.limit);
  if (std::isnan(entry.limit.predicted) || !(begin > 0)) return;
  MeasurePlan tries;
  tries.begin = begin;
  tries.threads = plan.threads;
  tries.observer = observer;
  // Where no step is stable, how long the run lasts decides, and digits mean nothing.
  constexpr double kCoarse = 0.05, kInMotion = 0.005;
  tries.resolution = entry.limit.predicted > 0 ? tries.resolution : kCoarse;
  tries.steps = StabilityPlan::kSteps;
  entry.atRest = measuredAtRest(scene, *entry.method, tries);
  tries.resolution = entry.limit.predicted > 0 ? kInMotion : kCoarse;
  tries.steps = 0;
  entry.inMotion = measuredLimit(scene, *entry.method, tries);
}

}  // namespace

StabilityStudy studyStability(const Scene& scene, const StabilityPlan& plan) {
  StabilityStudy study;
  study.scene = scene;
  std::vector<bool> dampings{false};
  if (isDamped(scene)) dampings.insert(dampings.begin(), true);
  const auto parts = double(plan.methods.size() * dampings.size());
  double done = 0;
  const auto observer = [&] {
    study.stopped = study.stopped || (plan.observer && !plan.observer(done / parts));
    return !study.stopped;
  };
  for (const Method* method : plan.methods) {
    for (const bool damped : dampings) {
      if (!observer()) return study;
      StabilityCase entry;
      entry.method = method;
      entry.damped = damped;
      const Scene chosen = damped ? scene : withoutDamping(scene);
      try {
        refuseUnfit(*method, chosen);
        entry.limit = stepLimit(chosen, *method);
        measure(entry, chosen, plan, observer);
        study.cases.push_back(entry);
      } catch (const InputError& refusal) {
        if (std::ranges::find(study.refusals, refusal.what()) == study.refusals.end()) {
          study.refusals.emplace_back(refusal.what());
        }
      }
      ++done;
    }
  }
  return study;
}

}  // namespace tyg
