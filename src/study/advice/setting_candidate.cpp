// What a run at another step or tolerance will cost and lose is guessed from the runs so far by the method's order,
// within bounds, because such guesses are rough.
#include "study/advice/setting_candidate.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/scene/bodies.h"
#include "study/diet/diet_changes.h"
#include "study/limits/stability.h"
#include "tyg/methods.h"
#include "tyg/sheet.h"

namespace tyg {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// The next guess aims at this fraction of the error that is asked for, because guesses are rough.
constexpr double kAim = 0.8;
// Parameters that differ by less than this fraction count as the same; a tenth of a tolerance changes the cost by some
// hundredths.
constexpr double kSameStep = 1e-3, kSameTolerance = 0.1;
constexpr double kFirstTolerance = 5e-3;  // of the loosest one: the first run is to tell what tighter ones will cost

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
    loosest_ = std::min(kLoosestOfSize * size, largestTolerance(scene));
    tightest_ = epsilonOf(precision) * size;  // rounding within a single step is larger than anything less
    return;
  }
  double limit = restLatticeLimit(scene, method);
  // No stable step: a run of a given length still survives with small ones.
  if (limit == 0) limit = restLatticeLimit(scene, findMethod("symplectic-euler"));
  loosest_ = limit > 0 ? std::min(kShareOfLimit * limit, interval) : interval;
  loosest_ = divided(loosest_);
}

Scene SettingCandidate::at(double parameter) const {
  Scene scene = scene_;
  (method_->adaptive ? scene.tolerance : scene.dt) = parameter;
  return scene;
}

const SettingCandidate::Run* SettingCandidate::known(double parameter) const {
  const auto found = std::ranges::find_if(
      runs_, [&](const Run& run) { return std::abs(run.parameter - parameter) < sameParameter() * parameter; });
  return found == runs_.end() ? nullptr : &*found;
}

void SettingCandidate::learn(double parameter, const Trial& trial) {
  std::erase_if(runs_,
                [&](const Run& run) { return std::abs(run.parameter - parameter) < sameParameter() * parameter; });
  runs_.push_back({parameter, trial});
  std::ranges::sort(runs_, std::greater{}, &Run::parameter);
  // A run that failed early says nothing of what one to the end costs.
  if (trial.status == Status::Ok) perStep_ = trial.wholeSeconds * parameter / scene_.duration;
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
                       std::log(runs.before->parameter / runs.last->parameter);
  return std::clamp(slope, most / 4, most);
}

double SettingCandidate::expectedAt(double parameter) const {
  if (!method_->adaptive) return perStep_ * scene_.duration / parameter;
  const TwoRuns runs = tightestRuns();
  if (runs.last == nullptr) return 0;
  return runs.last->trial.wholeSeconds * std::pow(runs.last->parameter / parameter, costExponent(runs));
}

double SettingCandidate::payable(double seconds) const {
  if (method_->adaptive) {
    constexpr double kSurely = 0.97;  // what it costs is only known afterwards
    const TwoRuns runs = tightestRuns();
    if (runs.last == nullptr) return loosest_;
    const double ratio = runs.last->trial.wholeSeconds / (kSurely * seconds);
    double parameter = std::clamp(runs.last->parameter * std::pow(ratio, 1 / costExponent(runs)), tightest_, loosest_);
    for (const Run& run : runs_) {  // half way, in powers, to what cost too much
      const bool tooDear = run.trial.cutShort && run.trial.seconds >= seconds && run.parameter < runs.last->parameter;
      if (tooDear && parameter < run.parameter * 2) parameter = std::sqrt(run.parameter * runs.last->parameter);
    }
    return parameter;
  }
  const double steps = std::floor(interval_ * seconds / (perStep_ * scene_.duration) + kSameStep);
  return std::min(interval_ / std::max(steps, 1.0), loosest_);
}

double SettingCandidate::errorAt(double parameter) const {
  if (gainsNothing()) return kInfinity;
  const Run* tightest = nullptr;
  for (const Run& run : runs_) {
    if (std::isfinite(run.trial.error)) tightest = &run;
  }
  if (tightest == nullptr) return 0;
  return std::max(leastError(), tightest->trial.error * std::pow(parameter / tightest->parameter, exponent()));
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
  const double parameter = divided(guess(good, bad, error));
  const bool between = (good == nullptr || parameter > good->parameter * (1 + sameParameter())) &&
                       (bad == nullptr || parameter < bad->parameter * (1 - sameParameter()));
  if (!between) return {};
  Next next{parameter, expectedAt(parameter)};
  if (good == nullptr && std::isfinite(bad->trial.error)) {
    next.inTheEnd = expectedAt(std::min(bad->parameter, bad->parameter * factor(bad->trial, error)));
  }
  return next;
}

double SettingCandidate::divided(double parameter) const {
  parameter = std::clamp(parameter, tightest_, loosest_);
  return method_->adaptive ? parameter : interval_ / std::ceil(interval_ / parameter - 1e-9);
}

bool SettingCandidate::gainsNothing() const {
  constexpr double kNoGain = 0.9, kTighter = 0.6, kSmallOfSize = 1e-3;
  if (runs_.size() < 2) return false;
  const Run &last = runs_.back(), &before = runs_[runs_.size() - 2];
  return std::isfinite(last.trial.error) && last.trial.error > kNoGain * before.trial.error &&
         last.parameter < kTighter * before.parameter && last.trial.error < kSmallOfSize * makeSheet(scene_).size();
}

double SettingCandidate::guess(const Run* good, const Run* bad, double error) const {
  constexpr double kLoosest = 16;
  const double apart = method_->adaptive ? 1.25 : 1.08;
  const double tightest = method_->adaptive ? 1e-5 : 1.0 / 16, afterFailure = method_->adaptive ? 0.1 : 0.5;
  if (good == nullptr && bad == nullptr) return loosest_;
  if (bad == nullptr) return good->parameter * std::clamp(factor(good->trial, error), 1.5, kLoosest);
  const double wanted =
      bad->parameter *
      (std::isfinite(bad->trial.error) ? std::clamp(factor(bad->trial, error), tightest, 0.9) : afterFailure);
  if (good == nullptr) return wanted;
  if (bad->parameter < apart * apart * good->parameter) return good->parameter;  // close enough
  return std::clamp(wanted, apart * good->parameter, bad->parameter / apart);
}

double SettingCandidate::factor(const Trial& trial, double error) const {
  return std::pow(kAim * error / trial.error, 1 / exponent());
}

double SettingCandidate::sameParameter() const { return method_->adaptive ? kSameTolerance : kSameStep; }

double SettingCandidate::exponent() const { return method_->adaptive ? 1 : method_->order; }

}  // namespace tyg
