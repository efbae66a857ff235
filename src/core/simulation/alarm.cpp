// What sets the alarm off, and the scale that rises and losses are compared with.
#include "core/simulation/alarm.h"

#include <algorithm>
#include <cmath>

#include "core/forces/terms/springs.h"

namespace tyg {
namespace {

/// Sum over springs of ks (0.01 L0)^2 / 2: the energy of a sheet stretched by a hundredth.
double hundredthStretch(const Scene& scene, const Sheet& sheet) {
  double sum = 0;
  for (const Family family : kFamilies) {
    const double elongation = 0.01 * restLength(sheet, family);
    sum += double(springCount(sheet, family)) * familyOf(scene, family).ks * elongation * elongation / 2;
  }
  return sum;
}

}  // namespace

void Alarm::useOrder(int order) {
  order_ = order;
  stored_.lowest = std::numeric_limits<double>::infinity();
  storedBefore_.fill(kUnknown);
}

void Alarm::lose(double power, double time, Taken taken) {
  const double explained = std::max(0.0, flowedBefore_), span = time - lastTime_;
  isSampled_ = samples_ > 0, takesLess_ = taken == Taken::Less;
  takenSince_ = taken == Taken::Unknown ? 0 : power * span;
  lostSince_ = taken == Taken::Unknown ? kUnknown : isSampled_ ? span * sampled_ / samples_ : takenSince_;
  if (taken != Taken::AsMuch) power = 0;
  lost_ -= std::max(0.0, lost_ - explained) / kMemory;
  isSure_ = suspects_ && sampled_ >= kConfirmed * estimated_ * samples_;
  estimated_ = std::min(power, lastPower_);
  if (suspects_ && !isSure_) {
    balance_.lowest = std::numeric_limits<double>::infinity();
    estimated_ = power = 0;
  }
  lost_ += estimated_ * span;
  flowedLately_ *= 1 - 1 / kMemory;
  lastPower_ = power, lastTime_ = time, sampled_ = samples_ = 0;
  suspects_ = false, lossIsPresent_ = true;
}

void Alarm::expect(double forcing, double h) { firstSteps_ = std::max(firstSteps_, 5 * forcing * h * h); }

double Alarm::Sum::riseTo(double value, double large) {
  lowest = std::min(lowest, value);
  const double rise = (value - lowest) / large;
  largestRise = std::max(largestRise, rise);
  return rise;
}

/// What is not known does not rise. The first rise is an estimate, after which the power of every step is asked for.
bool Alarm::risesSteadily(double stored, double large) {
  const double rise = (stored + lostSince_ - storedBefore_.front()) / large;
  const double least = takesLess_ ? std::max(kSteadyRiseOfLess, kSurplus * lostSince_ / large) : kSteadyRise;
  seesRise_ = order_ >= 2 && rise > least && rise < kThreshold;
  steadyRises_ = seesRise_ && isSampled_ ? steadyRises_ + 1 : 0;
  return steadyRises_ >= kSteadyChecks;
}

/// Whether what damping took is not missing from what is stored.
bool Alarm::keepsWhatIsLost(double stored, double large) {
  const bool isLost = takenSince_ > (order_ >= 3 ? kLeastLoss : kLeastLossOfLowOrder) * large;
  const bool counts = isLost && (order_ >= 2 || stored >= storedBefore_.front());
  keptLosses_ = counts ? keptLosses_ + 1 : 0;
  return keptLosses_ >= kSteadyChecks && stored >= storedBefore_.back();
}

/// The rules of steady changes, at a regular check.
bool Alarm::changesSteadily(double stored, double large) {
  const bool rises = risesSteadily(stored, large), keeps = keepsWhatIsLost(stored, large);
  std::rotate(storedBefore_.begin(), storedBefore_.end() - 1, storedBefore_.end());
  storedBefore_.front() = stored;
  return rises || keeps;
}

Status Alarm::check(const StoredEnergy& energy, double work, double flowing) {
  const double stored = energy.sum() - work;
  if (!std::isfinite(stored + lost_)) return Status::NotFinite;
  if (checked_) flowedLately_ += std::abs(flowing - flowedBefore_);
  flowedBefore_ = flowing;
  largest_ = std::max({largest_, energy.sizeSinceStart(), std::abs(work - flowing), flowedLately_});
  const double large = scale() + firstSteps_;
  bool rises = stored_.riseTo(stored, large) > (order_ >= 3 ? kThresholdOfHighOrder : kThreshold);
  if (lossIsPresent_ && changesSteadily(stored, large)) rises = true;
  if (lossIsPresent_ && balance_.riseTo(stored + lost_, large) > kThreshold) {
    rises = rises || isSure_;
    suspects_ = !isSure_;
  }
  checked_ = true, lossIsPresent_ = false;
  return rises ? Status::Unstable : Status::Ok;
}

Alarm makeAlarm(const Scene& scene, const Sheet& sheet, const StoredEnergy& start, int order) {
  return {hundredthStretch(scene, sheet), start.withNaturalZero(), order};
}

}  // namespace tyg
