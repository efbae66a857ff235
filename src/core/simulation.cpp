// What callers see of a simulation; its inside is in simulation_body.h.
#include "tyg/simulation.h"

#include "core/simulation_body.h"

namespace tyg {

std::string_view nameOf(Status status) {
  switch (status) {
    case Status::Ok:
      return "ok";
    case Status::Unstable:
      return "unstable";
    default:
      return "not-finite";
  }
}

Simulation::Simulation(const Scene& scene, const Method& method, const Settings& settings)
    : body_(std::make_unique<Body>(scene, method, settings)) {}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

void Simulation::advanceTo(double time) {
  body_->stopAsked = false;
  body_->advance(time);
  body_->look();
  Run& run = body_->run();
  run.tickBaseTime = run.time, run.tickBase = run.ticks;
}

void Simulation::tick(std::int64_t count) {
  body_->stopAsked = false;
  body_->tick(count);
}

void Simulation::observe(std::function<bool()> observer) { body_->observer = std::move(observer); }

void Simulation::push(int particle, const Vec3& force, int ticks) {
  if (particle < 0 || particle >= body_->sheet.count() || ticks < 1) {
    throw InputError("push: found particle " + std::to_string(particle) + " for " + std::to_string(ticks) +
                     " ticks, allowed: particle 0 to " + std::to_string(body_->sheet.count() - 1) +
                     ", at least one tick");
  }
  body_->push(particle, force, ticks);
}

void Simulation::useMethod(const Method& method) { body_->useMethod(method); }

void Simulation::useStep(double dt) {
  if (!(dt > 0) || !std::isfinite(dt)) throw InputError("dt: found " + std::to_string(dt) + ", allowed: above 0");
  body_->useStep(dt);
}

void Simulation::useWorld(const Scene& scene) {
  for (const LogEvent& event : changesBetween(worldOf(body_->scene), worldOf(scene))) body_->changeWorld(event);
}

void Simulation::keepGoing(bool yes) { body_->settings.keepGoing = yes; }

void Simulation::apply(const LogEvent& event, std::span<const Method> methods) {
  body_->replayMethods = methods;
  body_->play(event);
}

void Simulation::followLedger(bool on) { body_->followLedger(on); }

void Simulation::replay(const PushLog& log, std::span<const Method> methods) {
  refuseUnfitLog(log, body_->run().log);
  body_->replayMethods = methods;
  for (const LogEvent& event : log.events) {
    if (event.kind == LogEvent::Kind::Method) (void)body_->replayMethod(event.method);
  }
  body_->run().script = log.events;
  body_->run().scriptNext = 0;
}

double Simulation::time() const { return body_->run().time; }
std::int64_t Simulation::ticks() const { return body_->run().ticks; }
double Simulation::dt() const { return body_->run().dt; }
double Simulation::largestStep() const { return body_->run().largestStep; }
std::int64_t Simulation::steps() const { return body_->run().steps; }
std::int64_t Simulation::forceEvaluations() const { return body_->moving->evaluations(); }
int Simulation::threads() const { return body_->workers.threads(); }
const Scene& Simulation::scene() const { return body_->scene; }
const Scene& Simulation::startScene() const { return body_->started; }
const Sheet& Simulation::sheet() const { return body_->sheet; }
const Method& Simulation::method() const { return *body_->run().method; }
const PushLog& Simulation::log() const { return body_->run().log; }
Vec3 Simulation::position(int particle) const { return body_->moving->position(particle); }
Vec3 Simulation::velocity(int particle) const { return body_->moving->velocity(particle); }
void Simulation::copyPositions(std::span<float> xyz) const { body_->moving->copyPositions(xyz); }
std::uint64_t Simulation::hash() const { return body_->moving->hash(); }
Status Simulation::status() const { return body_->run().status; }
double Simulation::liveStableStep() { return body_->moving->liveStableStep(method()); }
double Simulation::alarmTime() const { return body_->run().alarmTime; }

Ledger Simulation::ledger() {
  const StoredEnergy energy = body_->look();
  const Run& run = body_->run();
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

Snapshot Simulation::save() const {
  auto saved = std::make_shared<const Body::Saved>(body_->save());
  Snapshot snapshot;
  snapshot.time_ = time();
  snapshot.ticks_ = ticks();
  const Run& run = saved->run;
  snapshot.bytes_ = saved->moment->bytes() + run.log.sceneText.size() + run.pushes.size() * sizeof(TimedPush) +
                    (run.log.events.size() + run.script.size()) * sizeof(LogEvent);
  snapshot.body_ = std::move(saved);
  return snapshot;
}

void Simulation::restore(const Snapshot& snapshot) {
  body_->restore(*static_cast<const Body::Saved*>(snapshot.body_.get()));
}

}  // namespace tyg
