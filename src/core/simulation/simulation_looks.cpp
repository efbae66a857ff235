// What a simulation accounts for as it goes: steps, energies, the ledger, the alarm.
#include <algorithm>

#include "core/simulation/simulation_body.h"

namespace tyg {
namespace {

/// Of fast waves, about. A method that holds whatever the damping takes less.
bool takesWhatDampingTakes(const Method& method) {
  return method.stableStep != nullptr && std::isfinite(method.stableStep(0, 1));
}

}  // namespace

StoredEnergy Simulation::Body::look() {
  StoredEnergy energy = moving->energy();
  energy.gravitational -= run.startHeight;
  run.maxStretch = std::max(run.maxStretch, energy.maxStretch);
  const Status now = run.alarm.look(energy, work());
  if (now != Status::Ok && run.status == Status::Ok) run.alarmTime = run.time;
  run.status = std::max(run.status, now);
  return energy;
}

double Simulation::Body::ledgerSum(const StoredEnergy& energy) const {
  return energy.kinetic + energy.elastic + energy.gravitational + moving->dissipated() - work();
}

void Simulation::Body::followLedger(bool on) {
  settings.ledger = on;
  moving->trackDissipation(on);
  if (run.ledger == on) return;
  run.startSum = ledgerSum(look());
  run.ledger = on;
}

void Simulation::Body::count(double h, int steps, double timeAfter) {
  run.time = timeAfter;
  run.largestStep = std::max(run.largestStep, h);
  run.steps += steps;
  run.alarm.expect(forcing, h);
  if (run.steps % kStepsBetweenLooks == 0) {
    // Steps of a method's own choice let fast waves jitter within the tolerance.
    const bool keepsTheBalance = !stepsFreely() && takesWhatDampingTakes(*run.method);
    run.alarm.lose(keepsTheBalance ? moving->lossPower() : 0, run.time);
    look();
    if (observer && !observer()) stopAsked = true;
  }
}

Ledger Simulation::ledger() {
  const StoredEnergy energy = body_->look();
  const Run& run = body_->run;
  Ledger ledger;
  ledger.kinetic = energy.kinetic;
  ledger.elastic = energy.elastic;
  ledger.gravitational = energy.gravitational;
  ledger.work = body_->work();
  ledger.dissipated = body_->moving->dissipated();
  ledger.scale = run.alarm.scale();
  ledger.storedRise = run.alarm.storedRise();
  ledger.balanceRise = run.alarm.balanceRise();
  ledger.maxStretch = run.maxStretch;
  if (run.ledger && ledger.scale > 0) ledger.drift = (body_->ledgerSum(energy) - run.startSum) / ledger.scale;
  return ledger;
}

Status Simulation::check() {
  body_->look();
  return status();
}

void Simulation::followLedger(bool on) { body_->followLedger(on); }

}  // namespace tyg
