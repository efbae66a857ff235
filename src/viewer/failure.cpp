// The limit that explains a failure is the last one that was measured before it.
#include "viewer/failure.h"

#include <cmath>
#include <utility>

#include "study/limits/stability.h"
#include "tyg/methods.h"

namespace tyg {

namespace {

/// Where the step is past the limit.
std::optional<FailingMotion> failingMotion(const Simulation& simulation, const Margin& margin) {
  if (margin.band() != MarginBand::Past) return std::nullopt;
  const Scene& scene = simulation.scene();
  const StepLimit limit = stepLimit(scene, simulation.method());
  if (!std::isfinite(limit.predicted)) return std::nullopt;
  if (limit.byContact) return FailingMotion{.name = appearanceOf(scene, limit)};
  return FailingMotion{appearanceOf(scene, limit), limit.qx, limit.qy, scene.columns, scene.rows};
}

}  // namespace

void Failure::restart() {
  thaw();
  motion_.reset();
  lastGood_.reset();
  runsOn_ = false;
  margin_.restart();
}

void Failure::thaw() {
  message_.clear();
  cure_.reset();
}

void Failure::freeze(std::string message) {
  cure_.reset();
  message_ = std::move(message);
}

void Failure::freezeOnAlarm(Simulation& simulation, const ShownState& shown) {
  margin_.keep(simulation);
  if (!runsOn_ && (!lastGood_ || simulation.alarmTime() != alarmTime_)) {  // else it is the same one, reached again
    lastGood_.reset();
    alarmTime_ = simulation.alarmTime();
    motion_ = failingMotion(simulation, margin());
  }
  if (!runsOn_ || told_.method != &simulation.method() || told_.step != simulation.dt()) {
    const Cure cure = findCure(simulation, margin().limit);
    told_ = {describeFailure(simulation, alarmTime_, margin().limit, cure), cure, &simulation.method(),
             simulation.dt()};
  }
  freezeWith(told_.message, told_.cure, shown);
}

void Failure::freezeOnStall(Simulation& simulation, const ShownState& shown, double seconds) {
  updateMargin(simulation);
  const Cure cure = findCure(simulation, margin().limit);
  freezeWith(describeStall(simulation, seconds, cure), cure, shown);
}

void Failure::freezeWith(std::string message, const Cure& cure, const ShownState& shown) {
  freeze(std::move(message));
  cure_ = cure;
  if (!lastGood_) lastGood_ = {shown.tick(), shown.time()};
}

void Failure::passed(std::int64_t tick) {
  if (lastGood_ && tick > lastGood_->tick) lastGood_.reset(), motion_.reset();
}

void Failure::fitCure(const Simulation& simulation, const Scene& chosen) {
  if (!cure_) return;
  previewMargin(chosen);
  if (margin().band() == MarginBand::Past) {
    cure_->step = safeStep(margin().limit);
  } else if (&findMethod(chosen.integrator) == &simulation.method() && chosen.dt == simulation.dt()) {
    cure_->step = findCure(simulation, margin().limit).step;
  } else {
    cure_->step = chosen.dt;
  }
}

}  // namespace tyg
