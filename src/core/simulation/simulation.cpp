// What callers ask of a simulation that stands still, and its snapshots. How it walks is in simulation_walk.cpp, what
// it accounts for in simulation_looks.cpp, what is done to it in simulation_edits.cpp.
#include "tyg/simulation.h"

#include "core/simulation/simulation_body.h"
#include "util/text.h"

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

Simulation::Body::Body(Scene wanted, const Method& method, const Settings& asked)
    : scene(std::move(wanted)),
      started(scene),
      sheet(makeSheet(scene)),
      settings(asked),
      workers(asked.threads > 0 ? asked.threads : defaultThreads(sheet.count())),
      moving(makeMovingSheet(scene, sheet, method, workers, asked.ledger)),
      run(scene, sheet, method, moving->energy(), asked.ledger) {
  applyPushes();
  look();
}

void Simulation::Body::restore(const Saved& saved) {
  if (saved.world != worldOf(scene)) {
    setWorld(scene, saved.world);
    moving->useWorld();
  }
  run = saved.run;
  moving->restore(*saved.moment);
  applyPushes();
  if (run.ledger != settings.ledger) followLedger(settings.ledger);
}

Simulation::Simulation(const Scene& scene, const Method& method, const Settings& settings)
    : body_(std::make_unique<Body>(scene, method, settings)) {}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

void Simulation::observe(std::function<bool()> observer) { body_->observer = std::move(observer); }

void Simulation::keepGoing(bool yes) { body_->settings.keepGoing = yes; }

double Simulation::time() const { return body_->run.time; }
std::int64_t Simulation::ticks() const { return body_->run.ticks; }
double Simulation::dt() const { return body_->run.dt; }
double Simulation::largestStep() const { return body_->run.largestStep; }
std::int64_t Simulation::steps() const { return body_->run.steps; }
std::int64_t Simulation::forceEvaluations() const { return body_->moving->evaluations(); }
int Simulation::threads() const { return body_->workers.threads(); }
const Scene& Simulation::scene() const { return body_->scene; }
const Scene& Simulation::startScene() const { return body_->started; }
const Sheet& Simulation::sheet() const { return body_->sheet; }
const Method& Simulation::method() const { return *body_->run.method; }
const PushLog& Simulation::log() const { return body_->run.log; }
Vec3 Simulation::position(int particle) const { return body_->moving->position(particle); }
Vec3 Simulation::velocity(int particle) const { return body_->moving->velocity(particle); }
void Simulation::copyPositions(std::span<float> xyz) const { body_->moving->copyPositions(xyz); }
std::uint64_t Simulation::hash() const { return body_->moving->hash(); }
Status Simulation::status() const { return body_->run.status; }
double Simulation::liveStableStep() { return body_->moving->liveStableStep(method()); }
double Simulation::alarmTime() const { return body_->run.alarmTime; }

Snapshot Simulation::save() const {
  auto saved = std::make_shared<const Body::Saved>(body_->save());
  Snapshot snapshot;
  snapshot.time_ = time();
  snapshot.ticks_ = ticks();
  const Run& run = saved->run;
  snapshot.bytes_ = saved->moment->bytes() + run.log.sceneText.size() + run.pushes.bytes() +
                    (run.log.events.size() + run.script.size()) * sizeof(LogEvent);
  snapshot.body_ = std::move(saved);
  return snapshot;
}

void Simulation::restore(const Snapshot& snapshot) {
  body_->restore(*static_cast<const Body::Saved*>(snapshot.body_.get()));
}

std::string hashText(const Simulation& simulation) {
  return formatted("%016llx", static_cast<unsigned long long>(simulation.hash()));
}

}  // namespace tyg
