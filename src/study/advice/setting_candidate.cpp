// Guesses by the method's order, and bounds on them.
#include "study/advice/setting_candidate.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "study/diet/diet_changes.h"
#include "study/limits/stability.h"
#include "tyg/methods.h"
#include "tyg/sheet.h"

namespace tyg {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Of the error asked for, where the next guess aims: guesses are rough.
constexpr double kAim = 0.8;
// Knobs closer than this fraction are one; a tenth of a tolerance is some hundredths of the cost.
constexpr double kSameStep = 1e-3, kSameTolerance = 0.1;
constexpr double kFirstTolerance = 5e-3;  // of the loosest: a first run that tells what tighter ones will cost

double epsilonOf(Precision precision) {
  return precision == Precision::Float ? double(std::numeric_limits<float>::epsilon())
                                       : std::numeric_limits<double>::epsilon();
}

}  // namespace

SettingCandidate::SettingCandidate(const Scene& scene, const Method& method, Precision precision, double interval)
    : method_(&method), scene_(scene), interval_(interval) {
  scene_.integrator = method.name;
  scene_.precision = precision;
  if (method.adaptive) {
    constexpr double kLoosestOfSize = 0.02;
    const double size = makeSheet(scene).size();
    loosest_ = kLoosestOfSize * size;
    tightest_ = epsilonOf(precision) * size;  // of less a step's own rounding makes a lie
    return;
  }
  double limit = restLatticeLimit(scene, method);
  // No stable step: a run of a given length still survives with small ones.
  if (limit == 0) limit = restLatticeLimit(scene, findMethod("symplectic-euler"));
  loosest_ = limit > 0 ? std::min(kShareOfLimit * limit, interval) : interval;
  loosest_ = divided(loosest_);
}

Scene SettingCandidate::at(double knob) const {
  Scene scene = scene_;
  (method_->adaptive ? scene.tolerance : scene.dt) = knob;
  return scene;
}

const SettingCandidate::Run* SettingCandidate::known(double knob) const {
  const auto found =
      std::ranges::find_if(runs_, [&](const Run& run) { return std::abs(run.knob - knob) < sameKnob() * knob; });
  return found == runs_.end() ? nullptr : &*found;
}

void SettingCandidate::learn(double knob, const Trial& trial) {
  std::erase_if(runs_, [&](const Run& run) { return std::abs(run.knob - knob) < sameKnob() * knob; });
  runs_.push_back({knob, trial});
  std::ranges::sort(runs_, std::greater{}, &Run::knob);
  // A run that failed early says nothing of what one to the end costs.
  if (trial.status == Status::Ok) perStep_ = trial.wholeSeconds * knob / scene_.duration;
}

void SettingCandidate::forgetBelow(double error) {
  std::erase_if(runs_, [&](const Run& run) { return run.trial.error < error; });
}

/// The two tightest that came to an end; where none did, of those that were cut short.
SettingCandidate::TwoRuns SettingCandidate::tightestRuns() const {
  TwoRuns two;
  for (const bool cutShort : {false, true}) {
    for (const Run& run : runs_) {
      if (run.trial.status == Status::Ok && run.trial.cutShort == cutShort) two.before = std::exchange(two.last, &run);
    }
    if (two.last != nullptr) break;
  }
  return two;
}

/// How the cost of an adaptive method goes with its tolerance: as two runs say, but never more than its order does. A
/// single run may have been held back by the method's limit, not by its tolerance.
double SettingCandidate::costExponent(const TwoRuns& runs) const {
  const double most = 1.0 / method_->order;
  if (runs.before == nullptr) return most / 2;
  const double slope = std::log(runs.last->trial.wholeSeconds / runs.before->trial.wholeSeconds) /
                       std::log(runs.before->knob / runs.last->knob);
  return std::clamp(slope, most / 4, most);
}

double SettingCandidate::expectedAt(double knob) const {
  if (!method_->adaptive) return perStep_ * scene_.duration / knob;
  const TwoRuns runs = tightestRuns();
  if (runs.last == nullptr) return 0;
  return runs.last->trial.wholeSeconds * std::pow(runs.last->knob / knob, costExponent(runs));
}

double SettingCandidate::payable(double seconds) const {
  if (method_->adaptive) {
    constexpr double kSurely = 0.97;  // what it costs is only known afterwards
    const TwoRuns runs = tightestRuns();
    if (runs.last == nullptr) return loosest_;
    const double ratio = runs.last->trial.wholeSeconds / (kSurely * seconds);
    double knob = std::clamp(runs.last->knob * std::pow(ratio, 1 / costExponent(runs)), tightest_, loosest_);
    for (const Run& run : runs_) {  // half way, in powers, to what cost too much
      const bool tooDear = run.trial.cutShort && run.trial.seconds >= seconds && run.knob < runs.last->knob;
      if (tooDear && knob < run.knob * 2) knob = std::sqrt(run.knob * runs.last->knob);
    }
    return knob;
  }
  const double steps = std::floor(interval_ * seconds / (perStep_ * scene_.duration) + kSameStep);
  return std::min(interval_ / std::max(steps, 1.0), loosest_);
}

double SettingCandidate::errorAt(double knob) const {
  if (gainsNothing()) return kInfinity;
  const Run* tightest = nullptr;
  for (const Run& run : runs_) {
    if (std::isfinite(run.trial.error)) tightest = &run;
  }
  if (tightest == nullptr) return 0;
  return std::max(leastError(), tightest->trial.error * std::pow(knob / tightest->knob, exponent()));
}

/// m: rounding alone makes more than this of almost every run.
double SettingCandidate::leastError() const {
  constexpr double kOfTheRounding = 0.01;
  return kOfTheRounding * epsilonOf(scene_.precision) * makeSheet(scene_).size();
}

SettingCandidate::Next SettingCandidate::next(double error) const {
  if (error < leastError()) return {};
  if (runs_.empty()) {
    const double first = method_->adaptive ? std::clamp(error, kFirstTolerance * loosest_, loosest_) : loosest_;
    return {first, expectedAt(first)};
  }
  const Run *good = nullptr, *bad = nullptr;  // the loosest within; the tightest of those outside that are looser
  for (const Run& run : runs_) {
    if (run.trial.error <= error) {
      good = &run;
      break;
    }
    bad = &run;
  }
  if (good == nullptr && gainsNothing()) return {};
  const double knob = divided(guess(good, bad, error));
  const bool between = (good == nullptr || knob > good->knob * (1 + sameKnob())) &&
                       (bad == nullptr || knob < bad->knob * (1 - sameKnob()));
  if (!between) return {};
  Next next{knob, expectedAt(knob)};
  if (good == nullptr && std::isfinite(bad->trial.error)) {
    next.inTheEnd = expectedAt(std::min(bad->knob, bad->knob * factor(bad->trial, error)));
  }
  return next;
}

double SettingCandidate::divided(double knob) const {
  knob = std::clamp(knob, tightest_, loosest_);
  return method_->adaptive ? knob : interval_ / std::ceil(interval_ / knob - 1e-9);
}

bool SettingCandidate::gainsNothing() const {
  constexpr double kNoGain = 0.9, kTighter = 0.6, kSmallOfSize = 1e-3;
  if (runs_.size() < 2) return false;
  const Run &last = runs_.back(), &before = runs_[runs_.size() - 2];
  return std::isfinite(last.trial.error) && last.trial.error > kNoGain * before.trial.error &&
         last.knob < kTighter * before.knob && last.trial.error < kSmallOfSize * makeSheet(scene_).size();
}

double SettingCandidate::guess(const Run* good, const Run* bad, double error) const {
  constexpr double kLoosest = 16;
  const double apart = method_->adaptive ? 1.25 : 1.08;
  const double tightest = method_->adaptive ? 1e-5 : 1.0 / 16, afterFailure = method_->adaptive ? 0.1 : 0.5;
  if (good == nullptr && bad == nullptr) return loosest_;
  if (bad == nullptr) return good->knob * std::clamp(factor(good->trial, error), 1.5, kLoosest);
  const double wanted =
      bad->knob *
      (std::isfinite(bad->trial.error) ? std::clamp(factor(bad->trial, error), tightest, 0.9) : afterFailure);
  if (good == nullptr) return wanted;
  if (bad->knob < apart * apart * good->knob) return good->knob;  // close enough
  return std::clamp(wanted, apart * good->knob, bad->knob / apart);
}

double SettingCandidate::factor(const Trial& trial, double error) const {
  return std::pow(kAim * error / trial.error, 1 / exponent());
}

double SettingCandidate::sameKnob() const { return method_->adaptive ? kSameTolerance : kSameStep; }

double SettingCandidate::exponent() const { return method_->adaptive ? 1 : method_->order; }

}  // namespace tyg
