// A copy of the simulation is kept every quarter of a second; between two copies the ticks are computed again.
#include "viewer/history.h"

#include <algorithm>
#include <cmath>

#include "tyg/methods.h"

namespace tyg {
namespace {

/// Simulated seconds from one copy to the next, where there is room for as many.
constexpr double kSpacing = 0.25;

}  // namespace

void History::begin(const Simulation& simulation) {
  copies_.clear();
  copies_.push_back(simulation.save());
  past_ = false;
}

void History::recall(const Simulation& simulation, EventLog log) {
  begin(simulation);
  newest_ = {.ticks = log.ticks};
  double dt = log.dt;
  std::int64_t since = 0;
  for (const Event& event : log.events) {
    const auto* change = std::get_if<StepEvent>(&event.action);
    if (change == nullptr || event.tick > log.ticks) continue;
    newest_.time += double(event.tick - since) * dt;
    dt = change->dt, since = event.tick;
  }
  newest_.time += double(log.ticks - since) * dt;
  whole_ = std::move(log);
  past_ = whole_.ticks > 0;
}

void History::follow(const Simulation& simulation) {
  const double now = simulation.time();
  const double room = double(mostBytes_) / std::max(1.0, double(copies_.back().bytes()));
  const double spacing = std::max(kSpacing, kSeconds / std::max(1.0, std::floor(room) - 2));
  if (simulation.status() != Status::Ok || now < copies_.back().time() + spacing) return;
  copies_.push_back(simulation.save());
  while (copies_[1].time() <= now - kSeconds) copies_.pop_front();
}

/// Lets the events before the next tick happen again that have not yet done so.
void History::repeatEvents(Simulation& simulation) const {
  for (std::size_t next = simulation.log().events.size();
       next < whole_.events.size() && whole_.events[next].tick <= simulation.ticks(); ++next) {
    simulation.apply(whole_.events[next], methods());
  }
}

void History::tick(Simulation& simulation, std::int64_t count) {
  const std::int64_t end = simulation.ticks() + count;
  while (past_ && simulation.ticks() < end) {
    repeatEvents(simulation);
    std::int64_t stop = std::min(end, newest_.ticks);
    const std::size_t next = simulation.log().events.size();
    if (next < whole_.events.size()) stop = std::min(stop, whole_.events[next].tick);
    const std::int64_t before = simulation.ticks();
    simulation.tick(stop - before);
    if (simulation.ticks() == before) return;
    follow(simulation);
    arrive(simulation);
  }
  if (simulation.ticks() >= end) return;
  simulation.tick(end - simulation.ticks());
  follow(simulation);
}

/// At the newest moment every event has happened again, and the past ends.
void History::arrive(Simulation& simulation) {
  if (simulation.ticks() < newest_.ticks) return;
  repeatEvents(simulation);
  cut(simulation);
}

void History::turnTo(Simulation& simulation, std::int64_t tick) {
  if (!past_) {
    whole_ = record(simulation);
    newest_ = {simulation.ticks(), simulation.time()};
    past_ = true;
  }
  target_ = std::clamp(tick, first().ticks, newest_.ticks);
  const auto after = std::ranges::upper_bound(copies_, target_, {}, &Snapshot::ticks);
  const Snapshot& nearest = *std::prev(after);
  if (simulation.ticks() > target_ || simulation.ticks() < nearest.ticks()) simulation.restore(nearest);
  arrive(simulation);
}

void History::cut(const Simulation& simulation) {
  while (copies_.back().ticks() > simulation.ticks()) copies_.pop_back();
  past_ = false;
  whole_ = {};
}

History::TimePoint History::newest(const Simulation& simulation) const {
  return past_ ? newest_ : TimePoint{simulation.ticks(), simulation.time()};
}

std::int64_t History::tickAt(double time, const Simulation& simulation) const {
  const auto next = std::ranges::upper_bound(copies_, time, {}, &Snapshot::time);
  if (next == copies_.begin()) return first().ticks;
  const Snapshot& before = *std::prev(next);
  const TimePoint after = next == copies_.end() ? newest(simulation) : TimePoint{next->ticks(), next->time()};
  if (!(after.time > before.time())) return after.ticks;
  const double share = std::clamp((time - before.time()) / (after.time - before.time()), 0.0, 1.0);
  return before.ticks() + std::llround(share * double(after.ticks - before.ticks()));
}

EventLog History::record(const Simulation& simulation) const { return past_ ? whole_ : recordTo(simulation); }

EventLog History::recordTo(const Simulation& simulation) {
  EventLog log = simulation.log();
  log.ticks = simulation.ticks();
  log.hash = hashText(simulation);
  return log;
}

std::size_t History::bytes() const {
  std::size_t sum = 0;
  for (const Snapshot& copy : copies_) sum += copy.bytes();
  return sum;
}

}  // namespace tyg
