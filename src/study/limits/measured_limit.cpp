// Tries one step after another: outward from where it is told to begin, then by bisection.
#include "study/limits/measured_limit.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "tyg/simulation.h"
#include "util/noise.h"

namespace tyg {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

enum class Outcome { Held, Failed, Unknown };

class Trials {
 public:
  Trials(Scene scene, const Method& method, const MeasurePlan& plan)
      : scene_(std::move(scene)), method_(method), plan_(plan) {
    scene_.tolerance = 0;  // adaptive methods take the step they are given
  }

  Outcome with(double step) {
    const double steps = plan_.steps > 0 ? double(plan_.steps) : std::ceil(scene_.duration / step);
    constexpr int kManyStages = 20;  // of a method that takes as many as it needs
    const int evaluations = method_.evaluationsPerStep < 0 ? kManyStages : method_.evaluationsPerStep + 1;
    if (stopped_ || steps * evaluations * scene_.columns * scene_.rows > plan_.mostWork) return Outcome::Unknown;
    Scene timed = scene_;
    timed.dt = step;
    timed.duration = steps * step;
    Simulation simulation(timed, method_, {.threads = plan_.threads});
    simulation.observe([&] {
      stopped_ = stopped_ || (plan_.observer && !plan_.observer());
      return !stopped_;
    });
    simulation.advanceTo(timed.duration);
    if (stopped_) return Outcome::Unknown;
    return simulation.status() == Status::Ok ? Outcome::Held : Outcome::Failed;
  }

 private:
  Scene scene_;
  const Method& method_;
  const MeasurePlan& plan_;
  bool stopped_ = false;
};

}  // namespace

Scene linearRegime(Scene scene) {
  scene.gravity = {};
  scene.pushes.clear();
  scene.displacements.clear();
  scene.precision = Precision::Double;
  std::uint32_t seed = 1;
  const auto some = [&] { return 1e-4 * scene.spacing * noise(seed); };
  const Sheet sheet = makeSheet(scene);
  for (int particle = 0; particle < sheet.count(); ++particle) {
    const double x = some(), y = some(), z = some();
    scene.displacements.push_back({{"", particle % scene.columns, particle / scene.columns}, {x, y, z}});
  }
  return scene;
}

double measuredLimit(const Scene& scene, const Method& method, const MeasurePlan& plan) {
  Trials trials(scene, method, plan);
  double held = 0, failed = 0;
  const auto note = [&](double step, Outcome outcome) { (outcome == Outcome::Held ? held : failed) = step; };
  Outcome outcome = trials.with(plan.begin);
  note(plan.begin, outcome);
  // Outward in growing strides from what is expected, downward or upward.
  for (double factor = 1.02; outcome != Outcome::Unknown && (held == 0 || failed == 0);
       factor = std::min(factor * factor, 2.0)) {
    const double step = held > 0 ? held * factor : failed / factor;
    if (step > 8 * plan.begin) return std::numeric_limits<double>::infinity();
    if (step < 1e-6 * plan.begin) return kUnknown;
    note(step, outcome = trials.with(step));
  }
  while (outcome != Outcome::Unknown && failed > (1 + plan.resolution) * held) {
    const double step = (held + failed) / 2;
    note(step, outcome = trials.with(step));
  }
  return outcome == Outcome::Unknown ? kUnknown : held;
}

}  // namespace tyg
