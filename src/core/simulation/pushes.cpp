// A scene's pushes begin and end at times, those made by hand at ticks; both do work while they act. A scene may have
// many of them: their edges are sorted once and passed one by one, so that only those that act cost anything.
#include "core/simulation/pushes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/forces/term.h"

namespace tyg {
namespace {

double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

bool isPinned(const Sheet& sheet, int particle) { return std::ranges::binary_search(sheet.pins, particle); }

}  // namespace

bool Pushes::ScenePush::actsAt(const Instant& now) const {
  const double soon = now.time + now.sameTime;
  return begin <= soon && soon < end;
}

double Pushes::Push::workUpTo(const Vec3& here) const {
  if (isIgnored) return 0;
  return dot(force, {here.x - from.x, here.y - from.y, here.z - from.z});
}

Pushes::Pushes(const Scene& scene, const Sheet& sheet) {
  std::vector<Edge> edges;
  for (const tyg::Push& push : scene.pushes) {
    const int index = int(ofScene_.size());
    ScenePush& own = ofScene_.emplace_back();
    own.particle = particleAt(sheet, push.particle);
    own.force = push.force;
    own.isIgnored = isPinned(sheet, own.particle);
    own.begin = push.at, own.end = push.at + push.duration;
    edges.push_back({own.begin, index});
    edges.push_back({own.end, index});
  }
  std::ranges::stable_sort(edges, {}, &Edge::time);
  edges_ = std::make_shared<const std::vector<Edge>>(std::move(edges));
}

void Pushes::add(const Sheet& sheet, int particle, const Vec3& force, std::int64_t firstTick, std::int64_t endTick) {
  HandPush& push = byHand_.emplace_back();
  push.particle = particle;
  push.force = force;
  push.isIgnored = isPinned(sheet, particle);
  push.first = firstTick, push.end = endTick;
}

void Pushes::useSheet(const Sheet& sheet, const Backend& backend) {
  const auto look = [&](Push& push) {
    const bool isIgnored = isPinned(sheet, push.particle);
    if (isIgnored == push.isIgnored) return;
    if (push.acting) turn(push, backend), push.acting = true;
    push.isIgnored = isIgnored;
  };
  std::ranges::for_each(ofScene_, look);
  std::ranges::for_each(byHand_, look);
}

void Pushes::turn(Push& push, const Backend& backend) {
  const Vec3 here = backend.particle(push.particle).position;
  if (push.acting) finishedWork_ += push.workUpTo(here);
  push.from = here;
  push.acting = !push.acting;
}

bool Pushes::switchOfScene(const Instant& now, const Backend& backend) {
  bool jump = false;
  for (; passed_ < edges_->size() && (*edges_)[passed_].time <= now.time + now.sameTime; ++passed_) {
    const int index = (*edges_)[passed_].push;
    ScenePush& push = ofScene_[std::size_t(index)];
    if (push.actsAt(now) == push.acting) continue;
    jump = true;
    turn(push, backend);
    const auto place = std::ranges::lower_bound(acting_, std::pair(push.particle, index), {}, [this](int acting) {
      return std::pair(ofScene_[std::size_t(acting)].particle, acting);
    });
    push.acting ? acting_.insert(place, index) : acting_.erase(place);
  }
  return jump;
}

bool Pushes::switchByHand(const Instant& now, const Backend& backend) {
  bool jump = false;
  for (HandPush& push : byHand_) {
    if (push.actsAt(now) == push.acting) continue;
    jump = true;
    turn(push, backend);
  }
  if (jump) std::erase_if(byHand_, [&](const HandPush& push) { return push.end <= now.tick; });
  return jump;
}

bool Pushes::switchAt(const Instant& now, const Backend& backend) {
  const bool ofScene = switchOfScene(now, backend), byHand = switchByHand(now, backend);
  return ofScene || byHand;
}

template <class Visit>
void Pushes::forActing(const Visit& visit) const {
  for (const int index : acting_) visit(ofScene_[std::size_t(index)]);
  for (const HandPush& push : byHand_) {
    if (push.acting) visit(push);
  }
}

/// In the order of their particles, in which the backend keeps them; those of one particle stay in theirs. Those of the
/// scene are kept so: a sort at each of many edges would take longer than the steps between them.
void Pushes::applyTo(Backend& backend) const {
  std::vector<const Push*> acting;
  forActing([&](const Push& push) { acting.push_back(&push); });
  if (!std::ranges::is_sorted(acting, {}, &Push::particle)) std::ranges::stable_sort(acting, {}, &Push::particle);
  backend.clearPushes();
  for (const Push* push : acting) backend.addPush(push->particle, push->force);
}

double Pushes::forcing(const Scene& scene, const Sheet& sheet) const {
  const double mass = sheet.particleMass;
  const Vec3 steady = steadyForce(scene);
  double root = std::sqrt(sheet.count() * dot(steady, steady) / mass);
  forActing([&](const Push& push) {
    root += std::sqrt(dot(push.force, push.force) / mass);  // a sum is no longer than its vectors
  });
  return root * root;
}

double Pushes::largestForce(const Scene& scene) const {
  const Vec3 steady = steadyForce(scene);
  double sum = std::sqrt(dot(steady, steady));
  forActing([&](const Push& push) { sum += std::sqrt(dot(push.force, push.force)); });
  return sum;
}

double Pushes::work(const Backend& backend) const {
  double sum = finishedWork_;
  forActing([&](const Push& push) { sum += push.workUpTo(backend.particle(push.particle).position); });
  return sum;
}

double Pushes::nextEdge(const Instant& now, double end) const {
  const auto next = std::ranges::upper_bound(*edges_, now.time + now.sameTime, {}, &Edge::time);
  return next != edges_->end() && next->time < end - now.sameTime ? next->time : end;
}

std::int64_t Pushes::ticksToEdge(std::int64_t tick, std::int64_t most) const {
  for (const HandPush& push : byHand_) {
    for (const std::int64_t edge : {push.first, push.end}) {
      if (edge > tick) most = std::min(most, edge - tick);
    }
  }
  return most;
}

}  // namespace tyg
