// Best-first search: of all methods, the one whose next run is expected to cost least, or to be most exact, is run
// next, until nothing that has not been tried is expected to be better than the best that has.
#include "study/advice/setting_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "study/diet/diet_changes.h"
#include "study/motion/error.h"
#include "tyg/methods.h"

namespace tyg {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// A gain in cost below this is not worth another run.
constexpr double kWorthwhile = 0.93;
/// Costs this close are the same: of such settings the most exact one is taken.
constexpr double kSameCost = 1.1;
/// What is expected to cost so many times too much in the end is given up; below that the guess may be wrong.
constexpr double kHopeless = 4;
/// What is expected to be so many times less exact than the best is not tried; below that the guess may be wrong.
constexpr double kDoubt = 20;
/// What is likely to be within the error comes first, as if it cost this fraction of its price.
constexpr double kLikely = 0.1;
constexpr int kMostTries = 14;  // of one method in one precision and one search

template <class Value>
std::size_t leastOf(const std::vector<SettingCandidate>& candidates, const Value& value, double& least) {
  std::size_t best = 0;
  least = kInfinity;
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    const double here = value(k);
    if (here < least) least = here, best = k;
  }
  return best;
}

}  // namespace

SettingSearch::SettingSearch(const Scene& scene, SearchPlan plan) : scene_(scene), plan_(std::move(plan)) {
  gatherCandidates();
}

void SettingSearch::measureAgainst(const SampledMotion& truth, double unsure) {
  truth_ = &truth;
  for (SettingCandidate& candidate : candidates_) candidate.forgetBelow(unsure);
}

void SettingSearch::gatherCandidates() {
  constexpr double kOfTheCheapest = 4;
  const double interval = sampleTimes(scene_).front();
  double cheapest = 0;
  for (const Method* method : plan_.methods) {
    if (!method->advisable || !takes(*method, scene_)) continue;
    for (const Precision precision : plan_.precisions) {
      SettingCandidate& candidate = candidates_.emplace_back(scene_, *method, precision, interval);
      if (method->adaptive) continue;
      const double unit = priceOf(candidate.at(candidate.loosest())).seconds;
      candidate.priceStep(unit * std::max(method->evaluationsPerStep, 1));
      const double seconds = candidate.expectedAt(candidate.loosest());
      if (cheapest == 0 || seconds < cheapest) cheapest = seconds;
      if (plan_.observer && !plan_.observer(runs_)) {
        stopped_ = true;
        return;
      }
    }
  }
  mostSeconds_ = std::max({plan_.mostSeconds, scene_.duration, kOfTheCheapest * cheapest});
}

double SettingSearch::allSeconds() const {
  constexpr double kDearestRuns = 3;
  return std::max(plan_.allSeconds, kDearestRuns * mostSeconds_);
}

void SettingSearch::tryOut(SettingCandidate& candidate, double parameter, double most) {
  const Scene scene = candidate.at(parameter);
  const Method& method = candidate.method();
  const Price price = priceOf(scene);
  const auto observer = [&](double) {
    stopped_ = stopped_ || (plan_.observer && !plan_.observer(runs_));
    return !stopped_;
  };
  constexpr double kSlack = 1.05;  // evaluations at starts and jumps of the force are not part of the guess
  const auto mostEvaluations = static_cast<std::int64_t>(std::fmin(std::ceil(kSlack * most / price.seconds), 1e18));
  SamplingOptions options{.threads = plan_.threads, .observer = observer, .device = price.device};
  options.mostEvaluations = mostEvaluations;
  const SampledMotion run = sampledRun(scene, method, truth_->times, options);
  Trial trial{.scene = scene, .status = run.status, .work = workOf(method, run)};
  trial.seconds = static_cast<double>(trial.work) * price.seconds;
  trial.device = price.device, trial.elsewhere = static_cast<double>(trial.work) * price.elsewhere;
  trial.wholeSeconds = trial.seconds;
  if (run.stopped) {
    trial.cutShort = true;
    const double samples = static_cast<double>(run.times.size()) + 0.5;  // it ended somewhere in the next one
    trial.wholeSeconds *= std::max(1.0, static_cast<double>(truth_->times.size()) / samples);
  } else if (run.status == Status::Ok) {
    trial.error = motionError(run, *truth_).rms;
  }
  ++runs_;
  spent_ += trial.seconds;
  if (!stopped_) candidate.learn(parameter, trial);
}

/// s that a run within the error will cost in the end; of a method that has not run in this precision what the other
/// says.
double SettingSearch::endOf(std::size_t k, const std::vector<SettingCandidate::Next>& next) const {
  if (!candidates_[k].runs().empty()) return next[k].inTheEnd;
  double end = 0;
  for (std::size_t other = 0; other < candidates_.size(); ++other) {
    if (&candidates_[other].method() == &candidates_[k].method()) end = std::max(end, next[other].inTheEnd);
  }
  return end;
}

std::optional<Trial> SettingSearch::cheapestWithin(double error, double seconds) {
  std::vector<SettingCandidate::Next> next;
  for (const SettingCandidate& candidate : candidates_) next.push_back(candidate.next(error));
  std::vector<int> tries(candidates_.size(), 0);
  const double enough = spent_ + allSeconds();
  double expected = 0;
  gaveUp_ = false;
  while (!stopped_) {
    const double least = leastSeconds(error), most = std::min({seconds, mostSeconds_, kSameCost * least});
    const auto worth = [&](std::size_t k) {
      const bool fresh = candidates_[k].runs().empty(), likely = next[k].inTheEnd > 0 && next[k].inTheEnd <= most;
      const bool closed = next[k].parameter == 0 || tries[k] >= kMostTries || next[k].seconds > most;
      const bool refined = !fresh && next[k].seconds > kWorthwhile * least;
      if (closed || refined || endOf(k, next) > kHopeless * most) return kInfinity;
      // What is likely to be within comes first: it tells what costs too much.
      return likely && std::isinf(least) ? kLikely * next[k].seconds : next[k].seconds;
    };
    const std::size_t k = leastOf(candidates_, worth, expected);
    if (!std::isfinite(expected)) break;
    if (spent_ > enough) {
      gaveUp_ = true;
      break;
    }
    tryOut(candidates_[k], next[k].parameter, most);
    next[k] = candidates_[k].next(error);
    ++tries[k];
  }
  return bestWithin(error, std::min(seconds, kSameCost * leastSeconds(error)));
}

std::optional<Trial> SettingSearch::mostExactWithin(double seconds, double floor) {
  if (std::optional<Trial> exact = cheapestWithin(floor, seconds)) return exact;
  const double most = std::min(seconds, mostSeconds_);
  std::vector<int> tries(candidates_.size(), 0);
  const double enough = spent_ + allSeconds();
  double expected = 0;
  gaveUp_ = false;
  while (!stopped_) {
    const std::optional<Trial> best = bestFor(seconds);
    const auto promised = [&](std::size_t k) {
      const SettingCandidate& candidate = candidates_[k];
      const double parameter = candidate.payable(most);
      const bool open =
          tries[k] < kMostTries && candidate.known(parameter) == nullptr && candidate.expectedAt(parameter) <= most;
      return open ? candidate.errorAt(parameter) : kInfinity;
    };
    const std::size_t k = leastOf(candidates_, promised, expected);
    if (!std::isfinite(expected) || (best && expected > kDoubt * best->error)) break;
    if (spent_ > enough) {
      gaveUp_ = true;
      break;
    }
    tryOut(candidates_[k], candidates_[k].payable(most), most);
    ++tries[k];
  }
  return bestFor(seconds);
}

double SettingSearch::leastSeconds(double error) const {
  double least = kInfinity;
  for (const SettingCandidate& candidate : candidates_) {
    for (const SettingCandidate::Run& run : candidate.runs()) {
      if (run.trial.error <= error) least = std::min(least, run.trial.seconds);
    }
  }
  return least;
}

std::optional<Trial> SettingSearch::bestWithin(double error, double seconds) const {
  std::optional<Trial> best = bestFor(seconds);
  return best && best->error <= error ? best : std::nullopt;
}

std::optional<Trial> SettingSearch::bestFor(double seconds) const {
  std::optional<Trial> best;
  for (const SettingCandidate& candidate : candidates_) {
    for (const auto& [parameter, trial] : candidate.runs()) {
      const bool counts = trial.seconds <= seconds && std::isfinite(trial.error);
      if (counts && (!best || trial.error < best->error)) best = trial;
    }
  }
  return best;
}

std::optional<Trial> SettingSearch::leastError() const { return bestFor(kInfinity); }

std::optional<Trial> SettingSearch::cheapest() const {
  std::optional<Trial> cheapest;
  for (const SettingCandidate& candidate : candidates_) {
    for (const auto& [parameter, trial] : candidate.runs()) {
      if (std::isfinite(trial.error) && (!cheapest || trial.seconds < cheapest->seconds)) cheapest = trial;
    }
  }
  return cheapest;
}

}  // namespace tyg
