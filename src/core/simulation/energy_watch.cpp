// A status only ever gets worse, and the time at which it first did is kept.
#include "core/simulation/energy_watch.h"

#include <algorithm>

namespace tyg {

void EnergyWatch::turn(Status status, double time) {
  if (status != Status::Ok && status_ == Status::Ok) alarmTime_ = time;
  status_ = std::max(status_, status);
}

void EnergyWatch::check(const EnergySample& sample) {
  StoredEnergy energy = sample.stored;
  energy.gravitational -= startHeight_;
  maxStretch_ = std::max(maxStretch_, energy.maxStretch);
  turn(alarm_.check(energy, sample.work), sample.time);
}

double EnergyWatch::sum(const EnergySample& sample) const {
  return sample.stored.kinetic + sample.stored.elastic + (sample.stored.gravitational - startHeight_) +
         sample.dissipated - sample.work;
}

Ledger EnergyWatch::ledger(const EnergySample& sample) {
  check(sample);
  Ledger ledger{.kinetic = sample.stored.kinetic,
                .elastic = sample.stored.elastic,
                .gravitational = sample.stored.gravitational - startHeight_,
                .work = sample.work,
                .dissipated = sample.dissipated,
                .scale = alarm_.scale(),
                .storedRise = alarm_.storedRise(),
                .balanceRise = alarm_.balanceRise(),
                .maxStretch = maxStretch_};
  if (followsLedger_ && ledger.scale > 0) ledger.drift = (sum(sample) - startSum_) / ledger.scale;
  return ledger;
}

void EnergyWatch::followLedger(bool on, const EnergySample& sample) {
  if (followsLedger_ == on) return;
  check(sample);
  startSum_ = sum(sample);
  followsLedger_ = on;
}

void EnergyWatch::begin(const Scene& scene, const Sheet& sheet, double startHeight, const StoredEnergy& now) {
  startHeight_ = startHeight;
  alarm_ = makeAlarm(scene, sheet, now);
}

void EnergyWatch::giveUp(double time) {
  turn(Status::NotFinite, time);
  gaveUp_ = true;
}

}  // namespace tyg
