// The public face of a simulation: each function asks one part of the inside. How it steps is in simulation_steps.cpp,
// what happens to it in simulation_events.cpp.
#include "tyg/simulation.h"

#include <fmt/core.h>

#include <algorithm>

#include "core/forces/term.h"
#include "core/scene/bodies.h"
#include "core/scene/scene_range.h"
#include "core/simulation/live_parameters.h"
#include "core/simulation/simulation_impl.h"

namespace tyg {
namespace {

Scene withinRange(Scene scene) {
  refuseExtremes(scene);
  refuseUnfitBodies(scene);
  return scene;
}

}  // namespace

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

Simulation::Impl::Impl(Scene wanted, const Method& method, const Settings& asked)
    : scene(withinRange(std::move(wanted))),
      startScene(scene),
      sheet(makeSheet(scene)),
      settings(asked),
      workers(asked.threads > 0 ? asked.threads : defaultThreads(sheet.count())),
      backend(makeBackend(scene, sheet, method, workers, settings)),
      run(scene, sheet, method, backend->energy(0), asked.ledger),
      timetable(scene),
      addsUpPower(asked.ledger) {
  applyPushes();
  applyTimetable();
  run.supply.follow(settings.ledger, powerToSupply(), 0, backend->energyOfPower());
  run.judged.follow(false, powerToSupply(), 0, backend->energyOfPower());
  followPower();
  checkEnergies();
}

Simulation::Impl::Checkpoint Simulation::Impl::checkpoint() const { return {run, liveValues(scene), backend->save()}; }

void Simulation::Impl::goBackTo(const Checkpoint& checkpoint) {
  if (checkpoint.liveValues != liveValues(scene)) {
    setLiveValues(scene, checkpoint.liveValues);
    backend->useLiveParameters();
  }
  run = checkpoint.run;
  if (run.changes.sheet() != sheet) {
    sheet = run.changes.sheet();
    backend->useSheet(*run.method);
  }
  backend->restore(*checkpoint.moved);
  applyPushes();
  applyTimetable();
  followPower();
  if (run.energies.followsLedger() != settings.ledger) run.energies.followLedger(settings.ledger, sample());
}

EnergySample Simulation::Impl::sample(const Power& power) const {
  const double time = run.clock.time();
  Power passed = backend->energyOfPower(), judged = passed;
  passed.supplied = run.supply.upTo(power, time, passed);
  judged.supplied = run.judged.upTo(power, time, judged);
  passed.pins += run.pins.work();
  judged.pins = passed.pins;
  passed.lost += run.cutAway;
  return {backend->energy(time), run.pushes.work(*backend), passed, judged, time};
}

void Simulation::Impl::checkEnergies() {
  run.largestSpeed = std::max(run.largestSpeed, approach());
  run.energies.check(sample());
}

Power Simulation::Impl::powerToSupply() const {
  for (std::size_t k = 0; k < kSupplies.size(); ++k) {
    if (canSupply(scene, k)) return backend->power(run.clock.time());
  }
  return {};
}

void Simulation::Impl::checkSupply(const Power& power) {
  for (Supply* supply : {&run.supply, &run.judged}) {
    supply->check(power, run.clock.time(), backend->energyOfPower());
  }
}

void Simulation::Impl::trackDissipation(bool on) {
  settings.ledger = on;
  followPower();
  run.energies.followLedger(on, sample());
}

void Simulation::Impl::followPower() {
  const bool bodies = bodiesMove(), exactly = settings.ledger || bodies, changes = exactly != run.supply.isExact();
  const auto follow = [&](Supply& supply, bool on) {
    if (supply.isExact() != on) supply.follow(on, powerToSupply(), run.clock.time(), backend->energyOfPower());
  };
  follow(run.supply, exactly), follow(run.judged, bodies);
  if (changes || exactly != addsUpPower) backend->trackDissipation(exactly, run.clock.time());
  addsUpPower = exactly;
}

Simulation::Simulation(const Scene& scene, const Method& method, const Settings& settings)
    : impl_(std::make_unique<Impl>(scene, method, settings)) {}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

void Simulation::advanceTo(double time) {
  impl_->stopAsked = false;
  impl_->runTo(time);
  check();
  impl_->run.clock.startTicksHere();
}
void Simulation::tick(std::int64_t count) { impl_->runTicks(count); }
void Simulation::observe(std::function<bool()> observer) { impl_->observer = std::move(observer); }

void Simulation::push(int particle, const Vec3& force, int ticks) {
  impl_->apply(PushEvent{particle, force, ticks}, {});
}
void Simulation::useMethod(const Method& method) {
  impl_->apply(MethodEvent{std::string(method.name)}, std::span(&method, 1));
}
void Simulation::useStep(double dt) { impl_->apply(StepEvent{dt}, {}); }
void Simulation::useLiveParameters(const Scene& scene) { impl_->useLiveParameters(scene); }
void Simulation::pin(int particle, bool pinned) { impl_->apply(PinEvent{particle, pinned}, {}); }
void Simulation::grab(int particle, const Vec3& velocity) { impl_->apply(GrabEvent{particle, velocity}, {}); }
void Simulation::release(int particle) { impl_->apply(ReleaseEvent{particle}, {}); }
void Simulation::cut(const CutLine& line) { impl_->apply(CutEvent{line}, {}); }
void Simulation::mend(int cuts) { impl_->apply(MendEvent{cuts}, {}); }
void Simulation::apply(const Event& event, std::span<const Method> methods) { impl_->apply(event.action, methods); }
void Simulation::replay(const EventLog& log, std::span<const Method> methods) {
  refuseUnfitLog(log, impl_->run.log);
  impl_->run.replay = Replay(log.events, methods);
}
void Simulation::followLedger(bool on) { impl_->trackDissipation(on); }
void Simulation::keepGoing(bool yes) { impl_->settings.keepGoing = yes; }

double Simulation::time() const { return impl_->run.clock.time(); }
std::int64_t Simulation::ticks() const { return impl_->run.clock.ticks(); }
double Simulation::dt() const { return impl_->run.clock.dt(); }
double Simulation::largestStep() const { return impl_->run.largestStep; }
double Simulation::largestSpeed() const { return impl_->run.largestSpeed; }
std::int64_t Simulation::steps() const { return impl_->run.steps; }
std::int64_t Simulation::forceEvaluations() const { return impl_->backend->evaluations(); }
int Simulation::threads() const { return impl_->workers.threads(); }
bool Simulation::onDevice() const { return impl_->settings.device != nullptr; }
const Scene& Simulation::scene() const { return impl_->scene; }
const Scene& Simulation::startScene() const { return impl_->startScene; }
const Sheet& Simulation::sheet() const { return impl_->sheet; }
std::span<const int> Simulation::held() const { return impl_->run.changes.held(); }
int Simulation::cuts() const { return impl_->run.changes.cuts(); }
const Method& Simulation::method() const { return *impl_->run.method; }
const EventLog& Simulation::log() const { return impl_->run.log; }
Vec3 Simulation::position(int particle) const { return impl_->backend->position(particle); }
Vec3 Simulation::velocity(int particle) const { return impl_->backend->velocity(particle); }
void Simulation::copyPositions(std::span<float> xyz) const { impl_->backend->copyPositions(xyz); }
std::shared_ptr<const DevicePositions> Simulation::positionsOnDevice() const {
  return impl_->backend->positionsOnDevice();
}
std::uint64_t Simulation::hash() const { return impl_->sheet.missing.mixedInto(impl_->backend->hash()); }
Ledger Simulation::ledger() { return impl_->run.energies.ledger(impl_->sample()); }
Glance Simulation::glance() const {
  EnergyWatch energies = impl_->run.energies;
  Glance glance{.ledger = energies.ledger(impl_->sample())};
  glance.status = energies.status();
  return glance;
}
double Simulation::checkedKinetic() const { return impl_->run.energies.kinetic(); }
double Simulation::liveStableStep() { return impl_->backend->liveStableStep(method(), time()); }
Status Simulation::check() {
  impl_->checkEnergies();
  return status();
}
Status Simulation::status() const { return impl_->run.energies.status(); }
double Simulation::alarmTime() const { return impl_->run.energies.alarmTime(); }

Snapshot Simulation::save() const {
  auto saved = std::make_shared<const Impl::Checkpoint>(impl_->checkpoint());
  Snapshot snapshot;
  snapshot.time_ = time();
  snapshot.ticks_ = ticks();
  const Run& run = saved->run;
  snapshot.bytes_ =
      saved->moved->bytes() + run.log.sceneText.size() + run.pushes.bytes() + run.log.events.size() * sizeof(Event);
  snapshot.checkpoint_ = std::move(saved);
  return snapshot;
}
void Simulation::restore(const Snapshot& snapshot) {
  impl_->goBackTo(*static_cast<const Impl::Checkpoint*>(snapshot.checkpoint_.get()));
}

std::string hashText(const Simulation& simulation) { return fmt::format("{:016x}", simulation.hash()); }

}  // namespace tyg
