// A pin's place is a start plus a velocity times a duration, for each of its motions, never a sum of steps.
#include "core/simulation/pin_motion.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace tyg {
namespace {

double squared(const Vec3& v) { return v.x * v.x + v.y * v.y + v.z * v.z; }

std::vector<int> eachOnce(std::vector<int> particles) {
  std::ranges::sort(particles);
  particles.erase(std::unique(particles.begin(), particles.end()), particles.end());
  return particles;
}

std::vector<int> particlesOf(const Move& move, const Sheet& sheet) {
  std::vector<int> particles;
  for (const Place& place : move.what) {
    const std::vector<int> named = particlesAt(sheet, place);
    particles.insert(particles.end(), named.begin(), named.end());
  }
  return eachOnce(std::move(particles));
}

}  // namespace

PinMotion::PinMotion(const Scene& scene, const Sheet& sheet) {
  std::vector<int> all;
  for (const Move& move : scene.moves) {
    for (const int particle : particlesOf(move, sheet)) {
      if (!std::ranges::binary_search(sheet.pins, particle)) {
        throw InputError(fmt::format("move: found particle [{}, {}], which is not pinned; allowed are pins",
                                     particle % sheet.columns, particle / sheet.columns));
      }
      all.push_back(particle);
    }
  }
  for (const int particle : eachOnce(std::move(all)))
    pins_.push_back({.particle = particle, .velocity = {}, .since = 0, .from = {}});
}

void PinMotion::hold(int particle, const Vec3& velocity) {
  auto pin = std::ranges::lower_bound(pins_, particle, {}, &Pin::particle);
  if (pin == pins_.end() || pin->particle != particle) {
    pin = pins_.insert(pin, {.particle = particle, .velocity = {}, .since = 0, .from = {}});
    pin->isNew = true;
  }
  pin->byHand = velocity;
}

void PinMotion::release(int particle) {
  const auto pin = std::ranges::lower_bound(pins_, particle, {}, &Pin::particle);
  if (pin != pins_.end() && pin->particle == particle) pin->byHand.reset();
}

void PinMotion::stop(int particle, const Sheet& sheet, Backend& backend) {
  const ParticleState before = backend.particle(particle);
  work_ -= sheet.particleMass / 2 * squared(before.velocity);
  backend.placePin(particle, {before.position, {}});
}

/// The velocity of each of the pins from now on.
std::vector<Vec3> PinMotion::wantedAt(const Scene& scene, const Sheet& sheet, const Instant& now) const {
  std::vector<Vec3> wanted(pins_.size());
  for (const Move& move : scene.moves) {
    if (!now.isWithin(move.at, move.duration)) continue;
    for (const int particle : particlesOf(move, sheet)) {
      const auto pin = std::ranges::lower_bound(pins_, particle, {}, &Pin::particle);
      if (pin == pins_.end() || pin->particle != particle) continue;  // freed by hand
      Vec3& velocity = wanted[std::size_t(pin - pins_.begin())];
      velocity = {velocity.x + move.velocity.x, velocity.y + move.velocity.y, velocity.z + move.velocity.z};
    }
  }
  for (std::size_t k = 0; k < pins_.size(); ++k) wanted[k] = pins_[k].byHand.value_or(wanted[k]);
  return wanted;
}

bool PinMotion::switchAt(const Scene& scene, const Sheet& sheet, const Instant& now, Backend& backend) {
  // What was freed moves as it likes.
  std::erase_if(pins_, [&](const Pin& pin) { return !std::ranges::binary_search(sheet.pins, pin.particle); });
  const std::vector<Vec3> wanted = wantedAt(scene, sheet, now);
  bool changed = false;
  for (std::size_t k = 0; k < pins_.size(); ++k) {
    Pin& pin = pins_[k];
    if (pin.velocity == wanted[k] && !pin.isNew) continue;
    changed = true;
    const ParticleState before = backend.particle(pin.particle);
    if (pin.velocity == Vec3{}) {
      pin.from = before.position;
    } else {
      const double seconds = now.time - pin.since;
      pin.from = {pin.from.x + seconds * pin.velocity.x, pin.from.y + seconds * pin.velocity.y,
                  pin.from.z + seconds * pin.velocity.z};
    }
    work_ += sheet.particleMass / 2 * (squared(wanted[k]) - squared(before.velocity));
    pin.velocity = wanted[k];
    pin.since = now.time;
    pin.isNew = false;
    backend.placePin(pin.particle, {pin.from, pin.velocity});
  }
  return changed;
}

std::vector<int> PinMotion::moving() const {
  std::vector<int> particles;
  for (const Pin& pin : pins_) {
    if (pin.velocity != Vec3{}) particles.push_back(pin.particle);
  }
  return particles;
}

}  // namespace tyg
