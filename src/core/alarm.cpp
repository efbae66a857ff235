// See alarm.h.
#include "core/alarm.h"

#include <algorithm>
#include <cmath>

namespace tyg {
namespace {

/// Sum over springs of ks (0.01 L0)^2 / 2: the energy of a sheet stretched by a hundredth.
double hundredthStretch(const Scene& scene, const Sheet& sheet) {
  const auto ofFamily = [&](const SpringFamily& springs, Family family) {
    const double elongation = 0.01 * restLength(sheet, family);
    return double(springCount(sheet, family)) * springs.ks * elongation * elongation / 2;
  };
  return ofFamily(scene.structural, Family::Structural) + ofFamily(scene.shear, Family::Shear) +
         ofFamily(scene.bend, Family::Bend);
}

/// A first-order method in free fall is ahead of the truth by n/2 of these after n steps, with nothing else to compare
/// it to while n is small: five of them keep the alarm quiet over the first steps, and are nothing later.
double firstSteps(const Scene& scene, const Sheet& sheet) {
  const Vec3& g = scene.gravity;
  return 5 * sheet.count() * sheet.particleMass * (g.x * g.x + g.y * g.y + g.z * g.z) * scene.dt * scene.dt;
}

}  // namespace

void Alarm::lose(double power, double time) {
  lost_ = lost_ * (1 - 1 / kMemory) + std::min(power, lastPower_) * (time - lastTime_);
  lastPower_ = power, lastTime_ = time;
  lossIsPresent_ = true;
}

void Alarm::Sum::take(double value, double scale, bool first) {
  lowest = first ? value : std::min(lowest, value);
  largestRise = std::max(largestRise, (value - lowest) / scale);
}

Status Alarm::look(const StoredEnergy& energy, double work) {
  const double stored = energy.kinetic + energy.elastic + energy.gravitational - work;
  if (!std::isfinite(stored + lost_)) return Status::NotFinite;
  largest_ = std::max({largest_, std::abs(energy.gravitational), std::abs(work)});
  stored_.take(stored, scale(), !looked_);
  if (lossIsPresent_) balance_.take(stored + lost_, scale(), !looked_);
  looked_ = true, lossIsPresent_ = false;
  return std::max(storedRise(), balanceRise()) > kThreshold ? Status::Unstable : Status::Ok;
}

Alarm makeAlarm(const Scene& scene, const Sheet& sheet, const StoredEnergy& start) {
  return {hundredthStretch(scene, sheet) + firstSteps(scene, sheet), start.kinetic + start.elastic};
}

}  // namespace tyg
