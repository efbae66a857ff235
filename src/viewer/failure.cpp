// The limit that explains a failure is the one in use at that time, so it is measured anew when the alarm goes.
#include "viewer/failure.h"

#include <utility>

#include "tyg/methods.h"

namespace tyg {

void Failure::restart() {
  thaw();
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
  updateMargin(simulation);
  const Cure cure = findCure(simulation, margin().limit);
  freezeWith(describeFailure(simulation, margin().limit, cure), cure, shown);
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
  if (lastGood_ && tick > lastGood_->tick) lastGood_.reset();
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
