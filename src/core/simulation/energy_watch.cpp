// A status only ever gets worse, and the time at which it first did is kept.
#include "core/simulation/energy_watch.h"

#include <algorithm>
#include <numeric>

#include "core/forces/term.h"

namespace tyg {
namespace {

/// J, brought by terms and pins.
double flowing(const Power& passed) { return std::reduce(passed.supplied.begin(), passed.supplied.end(), passed.pins); }

}  // namespace

void EnergyWatch::turn(Status status, double time) {
  if (status != Status::Ok && status_ == Status::Ok) alarmTime_ = time;
  status_ = std::max(status_, status);
}

void EnergyWatch::check(const EnergySample& sample) {
  const StoredEnergy energy = sample.stored.since(start_);
  maxStretch_ = std::max(maxStretch_, energy.maxStretch);
  kinetic_ = energy.kinetic;
  const double flow = flowing(sample.judged);
  turn(alarm_.check(energy, sample.pushes + flow, flow), sample.time);
}

double EnergyWatch::sum(const EnergySample& sample) const {
  return mechanical(sample.stored) + sample.passed.lost - sample.pushes - flowing(sample.passed);
}

Ledger EnergyWatch::ledger(const EnergySample& sample) {
  check(sample);
  Ledger ledger{.kinetic = sample.stored.kinetic,
                .dissipated = sample.passed.lost,
                .scale = alarm_.scale(),
                .storedRise = alarm_.storedRise(),
                .balanceRise = alarm_.balanceRise(),
                .maxStretch = maxStretch_};
  const StoredEnergy energy = sample.stored.since(start_);
  for (std::size_t k = 0; k < kStores.count; ++k) {
    if (named_.stores[k] || energy.stored[k] != 0) ledger.stored.add(kStores.list[k].name, energy.stored[k]);
  }
  ledger.work.add("pushes", sample.pushes);
  for (std::size_t k = 0; k < kSupplies.size(); ++k) {
    if (named_.supplies[k] || sample.passed.supplied[k] != 0) ledger.work.add(kSupplies[k], sample.passed.supplied[k]);
  }
  if (named_.pins || sample.passed.pins != 0) ledger.work.add("pins", sample.passed.pins);
  if (followsLedger_ && ledger.scale > 0) ledger.drift = (sum(sample) - startSum_) / ledger.scale;
  return ledger;
}

void EnergyWatch::followLedger(bool on, const EnergySample& sample) {
  if (followsLedger_ == on) return;
  startSum_ = sum(sample);
  followsLedger_ = on;
}

EnergyWatch::Named EnergyWatch::namedIn(const Scene& scene) {
  Named named;
  for (std::size_t k = 0; k < kStores.count; ++k) named.stores[k] = storesIn(scene, k);
  for (std::size_t k = 0; k < kSupplies.size(); ++k) named.supplies[k] = canSupply(scene, k);
  named.pins = std::ranges::any_of(scene.moves, [](const Move& move) { return move.body.empty(); });
  return named;
}

void EnergyWatch::begin(const Scene& scene, const Sheet& sheet, const StoredEnergy& start, const StoredEnergy& now) {
  start_ = start;
  named_ = namedIn(scene);
  alarm_ = makeAlarm(scene, sheet, now, alarm_.order());
}

void EnergyWatch::giveUp(double time) {
  turn(Status::NotFinite, time);
  gaveUp_ = true;
}

}  // namespace tyg
