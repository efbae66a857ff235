// A scene's pushes begin and end at times, those made by hand at ticks; both do work while they act.
#include "core/simulation/pushes.h"

#include <algorithm>
#include <cmath>

#include "core/forces/term.h"

namespace tyg {
namespace {

double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

bool isPinned(const Sheet& sheet, int particle) { return std::ranges::binary_search(sheet.pins, particle); }

}  // namespace

bool Pushes::Push::actsAt(const Instant& now) const {
  if (const auto* ticks = std::get_if<Ticks>(&when)) return ticks->first <= now.tick && now.tick < ticks->end;
  const auto& times = std::get<Times>(when);
  return now.isWithin(times.begin, times.end - times.begin);
}

double Pushes::Push::workUpTo(const Vec3& here) const {
  if (isIgnored) return 0;
  return dot(force, {here.x - from.x, here.y - from.y, here.z - from.z});
}

Pushes::Pushes(const Scene& scene, const Sheet& sheet) {
  for (const tyg::Push& push : scene.pushes) {
    const int particle = particleAt(sheet, push.particle);
    pushes_.push_back({.particle = particle,
                       .force = push.force,
                       .when = Times{push.at, push.at + push.duration},
                       .isIgnored = isPinned(sheet, particle)});
  }
}

void Pushes::add(const Sheet& sheet, int particle, const Vec3& force, std::int64_t firstTick, std::int64_t endTick) {
  pushes_.push_back({.particle = particle,
                     .force = force,
                     .when = Ticks{firstTick, endTick},
                     .isIgnored = isPinned(sheet, particle)});
}

bool Pushes::switchAt(const Instant& now, const Backend& backend) {
  bool jump = false;
  for (Push& push : pushes_) {
    if (push.actsAt(now) == push.acting) continue;
    jump = true;
    const Vec3 here = backend.position(push.particle);
    if (push.acting) finishedWork_ += push.workUpTo(here);
    push.from = here;
    push.acting = !push.acting;
  }
  if (!jump) return false;
  std::erase_if(pushes_, [&](const Push& push) {
    const auto* ticks = std::get_if<Ticks>(&push.when);
    return ticks != nullptr && ticks->end <= now.tick;
  });
  return true;
}

void Pushes::applyTo(Backend& backend) const {
  backend.clearPushes();
  for (const Push& push : pushes_) {
    if (push.acting) backend.addPush(push.particle, push.force);
  }
}

double Pushes::forcing(const Scene& scene, const Sheet& sheet) const {
  const double mass = sheet.particleMass;
  const Vec3 steady = steadyForce(scene);
  double root = std::sqrt(sheet.count() * dot(steady, steady) / mass);
  for (const Push& push : pushes_) {
    if (push.acting) root += std::sqrt(dot(push.force, push.force) / mass);  // a sum is no longer than its vectors
  }
  return root * root;
}

double Pushes::work(const Backend& backend) const {
  double sum = finishedWork_;
  for (const Push& push : pushes_) {
    if (push.acting) sum += push.workUpTo(backend.position(push.particle));
  }
  return sum;
}

double Pushes::nextEdge(const Instant& now, double end) const {
  double next = end;
  for (const Push& push : pushes_) {
    const auto* times = std::get_if<Times>(&push.when);
    if (times == nullptr) continue;
    for (const double edge : {times->begin, times->end}) {
      if (edge > now.time + now.sameTime && edge < next - now.sameTime) next = edge;
    }
  }
  return next;
}

std::int64_t Pushes::ticksToEdge(std::int64_t tick, std::int64_t most) const {
  for (const Push& push : pushes_) {
    const auto* ticks = std::get_if<Ticks>(&push.when);
    if (ticks == nullptr) continue;
    for (const std::int64_t edge : {ticks->first, ticks->end}) {
      if (edge > tick) most = std::min(most, edge - tick);
    }
  }
  return most;
}

}  // namespace tyg
