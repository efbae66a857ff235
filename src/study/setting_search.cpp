// Best-first search: of all methods, the one whose next run is expected to cost least is run next, until nothing that
// has not been tried is expected to be cheaper than the best that has.
#include "study/setting_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "study/diet_changes.h"
#include "study/error.h"
#include "study/stability.h"
#include "tyg/methods.h"
#include "tyg/sheet.h"

namespace tyg {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Of the error asked for, where the next guess aims: guesses are rough.
constexpr double kAim = 0.8;
/// A gain in cost below this is not worth another run.
constexpr double kWorthwhile = 0.93;
/// Costs this close are the same: of such settings the most exact one is taken.
constexpr double kSameCost = 1.1;
constexpr int kMostTries = 14;  // of one method in one precision

}  // namespace

/// A method in a precision, its knob (a step in s or a tolerance in m), and what is known of it so far.
struct SettingSearch::Candidate {
  const Method* method;
  Scene scene;
  double loosest = 0;   ///< knob
  double interval = 0;  ///< s between samples: fixed steps divide it, so that sampling changes none of them
  double perStep = 0;   ///< s that a step costs, about; adaptive methods: 0 until known
  double next = 0;      ///< knob of the next run; 0: closed
  double expected = 0;  ///< s that it will cost, about
  std::optional<std::pair<double, Trial>>
      good = std::nullopt,
      bad = std::nullopt;  ///< the loosest knob within the error, the tightest outside
  int tries = 0;

  [[nodiscard]] double divided(double step) const {
    return method->adaptive ? step : interval / std::ceil(interval / step - 1e-9);
  }
  /// How E follows the knob: E ~ knob^exponent.
  [[nodiscard]] double exponent() const { return method->adaptive ? 1 : method->order; }

  /// What a step costs; of a run that failed only what is known before it.
  void learn(double knob, const Trial& trial) {
    if (!std::isfinite(trial.error)) return;
    if (method->adaptive) {
      perStep = trial.seconds * std::pow(knob, 1.0 / method->order);
    } else {
      perStep = trial.seconds * knob / scene.duration;
    }
  }
  [[nodiscard]] double expectedAt(double knob) const {
    return method->adaptive ? perStep * std::pow(knob, -1.0 / method->order) : perStep * scene.duration / knob;
  }

  void aim(double knob) {
    knob = divided(std::min(knob, loosest));
    const bool known = (good && knob <= good->first * 1.001) || (bad && knob >= bad->first * 0.999);
    next = known || tries >= kMostTries ? 0 : knob;
    expected = next > 0 ? expectedAt(next) : kInfinity;
  }

  /// After a run: where to look next for the loosest knob within `error`.
  void judge(double knob, const Trial& trial, double error) {
    ++tries;
    learn(knob, trial);
    const bool gainsNothing = bad && trial.error > 0.9 * bad->second.error && std::isfinite(trial.error) &&
                              knob < 0.6 * bad->first && trial.error < 1e-3 * makeSheet(scene).size();
    if (trial.error <= error) {
      if (!good || knob > good->first) good = {knob, trial};
    } else if (!bad || knob < bad->first) {
      bad = {knob, trial};
    }
    if (gainsNothing && !good) {  // rounding, not the method, is what is left
      next = 0, expected = kInfinity;
      return;
    }
    aim(guess(error));
  }

 private:
  [[nodiscard]] double guess(double error) const {
    constexpr double kTightest = 1.0 / 16, kLoosest = 16;
    if (!bad) return good->first * std::clamp(factor(good->second, error), 1.5, kLoosest);
    const double wanted =
        bad->first * (std::isfinite(bad->second.error) ? std::clamp(factor(bad->second, error), kTightest, 0.9) : 0.5);
    if (!good) return wanted;
    constexpr double kApart = 1.08;
    if (bad->first < kApart * kApart * good->first) return 0.5 * good->first;  // close enough: known, so it ends
    return std::clamp(wanted, kApart * good->first, bad->first / kApart);
  }
  [[nodiscard]] double factor(const Trial& trial, double error) const {
    return std::pow(kAim * error / trial.error, 1 / exponent());
  }
};

SettingSearch::SettingSearch(const Scene& scene, const SampledMotion& truth, SearchPlan plan)
    : scene_(scene), truth_(truth), plan_(std::move(plan)) {}
SettingSearch::~SettingSearch() = default;

std::vector<SettingSearch::Candidate> SettingSearch::candidates() const {
  std::vector<Candidate> all;
  for (const Method* method : plan_.methods) {
    if (!advisable(*method) || !takes(*method, scene_)) continue;
    for (const Precision precision : plan_.precisions) {
      Candidate& candidate = all.emplace_back(Candidate{method, scene_});
      candidate.scene.integrator = method->name;
      candidate.scene.precision = precision;
      candidate.interval = truth_.times.front();
      if (method->adaptive) {
        constexpr double kLoosestOfSize = 0.02;
        candidate.loosest = kLoosestOfSize * makeSheet(scene_).size();
        continue;
      }
      double limit = restLatticeLimit(scene_, *method);
      // No stable step: a run of a given length still survives with small ones.
      if (limit == 0) limit = restLatticeLimit(scene_, findMethod("symplectic-euler"));
      candidate.loosest =
          candidate.divided(limit > 0 ? std::min(kShareOfLimit * limit, candidate.interval) : candidate.interval);
      Scene atIt = candidate.scene;
      atIt.dt = candidate.loosest;
      candidate.perStep = plan_.cost(atIt, plan_.threads) * std::max(method->evaluationsPerStep, 1);
    }
  }
  return all;
}

double SettingSearch::mostSecondsFor(const std::vector<Candidate>& all) const {
  constexpr double kOfTheCheapest = 4;
  double cheapest = kInfinity;
  for (const Candidate& candidate : all) {
    if (candidate.perStep > 0) cheapest = std::min(cheapest, candidate.expectedAt(candidate.loosest));
  }
  return std::isfinite(cheapest) ? std::max(plan_.mostSeconds, kOfTheCheapest * cheapest) : plan_.mostSeconds;
}

const Trial& SettingSearch::tryOut(const Candidate& candidate, double knob) {
  const std::string key = std::string(candidate.method->name) +
                          (candidate.scene.precision == Precision::Float ? " float " : " double ") +
                          std::to_string(std::log(knob));
  const auto found = trials_.find(key);
  if (found != trials_.end()) return found->second;
  Trial trial;
  trial.scene = candidate.scene;
  (candidate.method->adaptive ? trial.scene.tolerance : trial.scene.dt) = knob;
  const auto observer = [&](double) {
    stopped_ = stopped_ || (plan_.observer && !plan_.observer());
    return !stopped_;
  };
  const SampledMotion run =
      sampledRun(trial.scene, *candidate.method, truth_.times, {.threads = plan_.threads, .observer = observer});
  trial.status = run.status;
  trial.work = workOf(*candidate.method, run);
  trial.seconds = static_cast<double>(trial.work) * plan_.cost(trial.scene, plan_.threads);
  if (run.status == Status::Ok && !run.stopped) {
    trial.error = motionError(run, truth_).rms;
  }
  return trials_[key] = trial;
}

std::optional<Trial> SettingSearch::cheapestWithin(double error) {
  std::vector<Candidate> all = candidates();
  for (Candidate& candidate : all) {
    candidate.aim(candidate.method->adaptive ? error : candidate.loosest);
    if (candidate.method->adaptive) candidate.expected = 0;  // unknown until its first run
  }
  double least = kInfinity, spent = 0;  // s: the cheapest so far, all so far
  const double mostSeconds = mostSecondsFor(all), allSeconds = std::max(plan_.allSeconds, 6 * mostSeconds);
  while (!all.empty() && !stopped_ && spent < allSeconds) {
    Candidate& candidate = *std::ranges::min_element(all, {}, &Candidate::expected);
    if (candidate.next == 0 || candidate.expected > std::min(mostSeconds, kSameCost * least)) break;
    if (candidate.tries > 0 && candidate.expected > kWorthwhile * least) {
      candidate.expected = kInfinity;
      continue;
    }
    const double knob = candidate.next;
    const Trial& trial = tryOut(candidate, knob);
    if (stopped_) break;
    spent += trial.seconds;
    if (trial.error <= error) least = std::min(least, trial.seconds);
    candidate.judge(knob, trial, error);
  }
  std::optional<Trial> best;
  for (const auto& [key, trial] : trials_) {
    const bool counts = trial.error <= error && trial.seconds <= kSameCost * least;
    if (counts && (!best || trial.error < best->error)) best = trial;
  }
  return best;
}

std::optional<Trial> SettingSearch::mostExactWithin(double seconds) {
  constexpr double kScreen = 16;  // a first run of each costs this much less
  constexpr std::size_t kFinalists = 4;
  std::vector<Candidate> all = candidates();
  const double mostSeconds = mostSecondsFor(all);
  std::optional<Trial> best;
  const auto judge = [&](const Trial& trial) {
    const bool counts = trial.seconds <= seconds && std::isfinite(trial.error);
    if (counts && (!best || trial.error < best->error)) best = trial;
  };
  // The tightest knob that so much time can pay for, up to the loosest there is.
  const auto payable = [](const Candidate& candidate, double most) {
    const double knob =
        candidate.perStep == 0 ? candidate.loosest
        : candidate.method->adaptive
            ? std::pow(candidate.perStep / most, candidate.method->order)
            : candidate.interval /
                  std::max(std::floor(candidate.interval * most / (candidate.perStep * candidate.scene.duration)), 1.0);
    return std::min(knob, candidate.loosest);
  };
  for (Candidate& candidate : all) {
    const double knob = payable(candidate, seconds / kScreen);
    if (candidate.expectedAt(knob) > mostSeconds) continue;
    const Trial& trial = tryOut(candidate, knob);
    if (stopped_) return best;
    candidate.learn(knob, trial);
    judge(trial);
    const double tighter = payable(candidate, seconds) / knob;
    candidate.expected = std::isfinite(trial.error) ? trial.error * std::pow(tighter, candidate.exponent()) : kInfinity;
  }
  std::ranges::stable_sort(all, {}, &Candidate::expected);
  for (std::size_t k = 0; k < std::min(kFinalists, all.size()); ++k) {
    constexpr int kRefinements = 2;  // an adaptive method's cost is only known afterwards
    for (int turn = 0; turn < kRefinements; ++turn) {
      const double knob = payable(all[k], std::min(seconds, mostSeconds));
      const Trial& trial = tryOut(all[k], knob);
      if (stopped_) return best;
      all[k].learn(knob, trial);
      judge(trial);
    }
  }
  return best;
}

std::optional<Trial> SettingSearch::leastError() const {
  std::optional<Trial> least;
  for (const auto& [key, trial] : trials_) {
    if (std::isfinite(trial.error) && (!least || trial.error < least->error)) least = trial;
  }
  return least;
}

std::optional<Trial> SettingSearch::cheapest() const {
  std::optional<Trial> cheapest;
  for (const auto& [key, trial] : trials_) {
    if (std::isfinite(trial.error) && (!cheapest || trial.seconds < cheapest->seconds)) cheapest = trial;
  }
  return cheapest;
}

}  // namespace tyg
