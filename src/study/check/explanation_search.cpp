// Most tries end after the first times, at which two different programs are already apart. What is left is run to the
// end, with a twin beside it where rounding errors may have grown.
#include "study/check/explanation_search.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "study/motion/error.h"
#include "tyg/methods.h"

namespace tyg {
namespace {

constexpr double kSame = 1e-9;       // of the size: two programs that do the same are as near as this ...
constexpr double kRounding = 1e-13;  // ... but for their rounding errors, of the size, times the amplification
constexpr double kLost = 1e6;        // an amplification past which nothing can be told
constexpr double kNear = kRounding * kLost * 10;  // of the size
constexpr double kMostEffort = 2e9;               // evaluations of one spring, a few ns each
constexpr double kAsWell = 10;         // two programs that are both exact and differ by so many times may be the same
constexpr double kFar = 5;             // an accurate model so many times as far away as the truth explains nothing
constexpr double kDearlyRanked = 3e7;  // so much a single run may cost that only gives an order
constexpr std::size_t kMostToTheEnd = 10, kMostAimed = 50, kKept = 4;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

ExplanationSearch::ExplanationSearch(const Scene& scene, const GivenMotion& motion, std::optional<double> step,
                                     int threads, std::function<bool(double)> goesOn)
    : motion_(motion), threads_(threads, std::move(goesOn)), size_(makeSheet(scene).size()) {
  plain_.scene = scene;
  first_ = firstSamples(motion, scene);
  constexpr double kUsualCount = 400, kMostTimes = 8;
  most_ = kMostEffort * std::clamp(double(scene.columns) * scene.rows / kUsualCount, 1.0, kMostTimes);
  if (step) {
    if (!stepCounts(motion, *step).empty()) all_ = likely_ = {*step};
    return;
  }
  Steps usual{scene.dt};
  for (const double decade : {1e-4, 1e-3, 1e-2}) {
    for (const double factor : {1.0, 2.0, 2.5, 4.0, 5.0}) usual.push_back(factor * decade);
  }
  // `tyg run` cuts its steps so that they end on the samples.
  if (const double gap = motion.times.back() / double(motion.times.size()); gap > scene.dt) {
    usual.push_back(gap / std::ceil(gap / scene.dt - 1e-9));
  }
  constexpr double kLikely = 0.02;
  all_ = stepsOnto(motion, usual);
  for (const double dt : all_) {
    const bool everyStepWritten = likely_.empty() && others_.empty() && dt <= kLikely;
    (everyStepWritten || std::abs(dt - scene.dt) <= 1e-9 * dt ? likely_ : others_).push_back(dt);
  }
}

bool ExplanationSearch::spend(double cost) {
  spent_ += cost;
  threads_.reach(std::min(1.0, spent_ / most_));
  return threads_.goesOn() && !isOver();
}

/// Runs tries ahead. Those that are begun after the effort has been spent are left out: what they come to would not be
/// taken anyway, because those before them have spent at least as much by then.
std::vector<ExplanationSearch::Run> ExplanationSearch::runAll(std::span<const Trial> trials, double enough) {
  std::vector<Run> runs(trials.size(), {kInfinity, 0});
  constexpr double kRoundingOfSums = 1e-9;
  std::atomic<double> spent{spent_};
  threads_.forEach(trials.size(), [&](std::size_t k) {
    if (!threads_.goesOn() || spent > most_ * (1 + kRoundingOfSums)) return;
    const Fit fit = fitOf(trials[k], motion_,
                          {.samples = first_, .enough = enough, .goesOn = [this] { return threads_.goesOn(); }});
    runs[k] = {fit.upTo(first_), fit.distances.size()};
    if (!fit.distances.empty()) spent += costOf(trials[k], motion_, fit.distances.size());
  });
  return runs;
}

/// The distance of a try that has been run, as far as the effort reaches.
double ExplanationSearch::accounted(const Trial& trial, const Run& run) {
  if (!spend(0)) return kInfinity;
  if (run.sampled > 0) spend(costOf(trial, motion_, run.sampled));
  return run.distance;
}

void ExplanationSearch::tryAll(std::span<const Trial> trials, double enough, std::vector<Tried>& tried) {
  const std::vector<Run> runs = runAll(trials, enough);
  for (std::size_t k = 0; k < trials.size(); ++k) {
    const double distance = accounted(trials[k], runs[k]);
    if (std::isfinite(distance)) tried.push_back({trials[k], distance});
  }
}

/// m: how far two programs that do the same may be apart where nothing is amplified.
double ExplanationSearch::unamplified(std::size_t sample) const {
  return std::max(kSame * size_, motion_.rounding[sample]);
}

/// m: what is further away at the first times is something else.
double ExplanationSearch::near() const { return std::max(kNear * size_, 2 * unamplified(first_ - 1)); }

/// A try whose own error is small beside what mistakes do.
std::optional<Trial> ExplanationSearch::accurate(const Model& model) const {
  const Method& rk4 = findMethod("rk4");
  const double limit = moderateStep(model.scene);
  double best = 0, least = kInfinity;
  for (const double dt : all_) {
    least = std::min(least, dt);
    if (!(dt > limit)) best = std::max(best, dt);
  }
  if (std::isinf(least)) return std::nullopt;
  if (best == 0) best = least / std::ceil(least / limit);  // a whole part of a step that fits
  Way way{&rk4, nullptr};
  if (!model.isScene()) {
    way = {nullptr, &*std::ranges::find(studentMethods(), "rk4", &StudentMethod::name)};
  }
  return Trial{&model, way, best};
}

std::vector<Trial> ExplanationSearch::trialsOf(const Model& model, Breadth breadth, const Steps& steps) const {
  constexpr double kDear = 1.5e8;
  std::vector<Trial> trials;
  for (const double dt : steps) {
    for (const Way& way : waysOf(model, breadth)) {
      const Trial trial{&model, way, dt};
      if (all_.size() == 1 || costOf(trial, motion_, first_) <= kDear) trials.push_back(trial);
    }
  }
  return trials;
}

/// Runs a try to the end, with a twin where it drifts away by little.
ExplanationSearch::Judgement ExplanationSearch::judged(const Trial& trial) {
  const std::size_t all = motion_.times.size();
  Judgement judgement{.of = {.model = *trial.model, .way = trial.way, .dt = trial.dt}};
  Explanation& of = judgement.of;
  const auto runs = [&](bool twin) {
    judgement.cost += (twin ? 2 : 1) * costOf(trial, motion_, all);
    return fitOf(trial, motion_, {.samples = all, .twin = twin, .goesOn = [this] { return threads_.goesOn(); }});
  };
  const auto judge = [&](const Fit& fit) {
    std::size_t k = 0;
    of.exact = true, of.distance = 0;
    for (; k < fit.distances.size(); ++k) {
      const double amplification = fit.amplification.empty() ? 0 : fit.amplification[k];
      if (amplification > kLost && k >= first_) break;
      of.distance = std::max(of.distance, fit.distances[k]);
      of.exact = of.exact && fit.distances[k] <= std::max(unamplified(k), kRounding * size_ * amplification);
    }
    of.exact = of.exact && k >= first_;
    of.judgedUpTo = k > 0 ? motion_.times[k - 1] : 0;
    if (k == 0 || (fit.amplification.empty() && k < all)) of.distance = kInfinity, of.exact = false;
  };
  const Fit alone = runs(false);
  judge(alone);
  const bool startsWell =
      alone.upTo(std::min(first_, alone.distances.size())) <= 1e-6 * size_ + unamplified(first_ - 1);
  if (of.exact || !startsWell || threads_.stopped()) return judgement;
  const double distance = of.distance;
  judge(runs(true));
  if (!of.exact) of.distance = distance, of.judgedUpTo = motion_.times.back();
  return judgement;
}

std::vector<Explanation> ExplanationSearch::judgedFirst(std::span<const Tried> tried, std::size_t count) {
  std::vector<Judgement> judgements(std::min(count, tried.size()));
  threads_.forEach(judgements.size(), [&](std::size_t k) { judgements[k] = judged(tried[k].trial); });
  std::vector<Explanation> found;
  for (Judgement& judgement : judgements) {
    spend(judgement.cost);
    found.push_back(std::move(judgement.of));
  }
  return found;
}

/// Of those that are near at the first times, the nearest that stays so.
std::optional<Explanation> ExplanationSearch::exactOf(std::vector<Tried>& tried) {
  std::ranges::stable_sort(tried, {}, &Tried::distance);
  const auto nearOnes = std::size_t(std::ranges::upper_bound(tried, near(), {}, &Tried::distance) - tried.begin());
  std::optional<Explanation> best;
  for (const Explanation& of : judgedFirst(tried, std::min(nearOnes, kMostToTheEnd))) {
    if (of.exact && (!best || of.distance < best->distance)) best = of;
  }
  return best;
}

std::optional<Explanation> ExplanationSearch::nearestOf(std::vector<Tried>& tried) {
  std::ranges::stable_sort(tried, {}, &Tried::distance);
  std::optional<Explanation> nearest;
  for (const Explanation& of : judgedFirst(tried, kKept)) {
    if (!nearest || of.distance < nearest->distance) nearest = of;
  }
  return nearest;
}

std::optional<Explanation> ExplanationSearch::right() {
  std::vector<Tried> tried;
  std::vector<Trial> trials;
  for (const Method& method : methods()) {
    if (method.adaptive) trials.push_back({&plain_, {&method, nullptr}, 0});
  }
  std::ranges::copy(trialsOf(plain_, Breadth::All, likely_), std::back_inserter(trials));
  tryAll(trials, kInfinity, tried);
  tryAll(trialsAround(aims(std::span(&plain_, 1))), kInfinity, tried);
  std::optional<Explanation> found = exactOf(tried);
  if (stopped()) return found;
  return found ? nearestStep(*found) : nearestOf(tried);
}

/// Exact methods are the same as any fine step of theirs: the step is the one that fits best.
Explanation ExplanationSearch::nearestStep(const Explanation& found) {
  if (found.dt == 0 || found.distance <= kRounding * size_) return found;
  std::vector<Tried> tried;
  std::vector<Trial> trials;
  for (const double dt : all_) {
    if (dt < found.dt) trials.push_back({&plain_, found.way, dt});
  }
  tryAll(trials, near(), tried);
  const std::optional<Explanation> other = exactOf(tried);
  return other && other->distance < found.distance ? *other : found;
}

std::optional<Explanation> ExplanationSearch::rightAtAnyStep() {
  std::vector<Tried> tried;
  tryAll(trialsOf(plain_, Breadth::Students, others_), near(), tried);
  std::optional<Explanation> found = exactOf(tried);
  if (found || stopped()) return found;
  tryAll(trialsOf(plain_, Breadth::All, others_), near(), tried);
  return exactOf(tried);
}

/// The models by how near they are when they are run accurately, without those that are further away than `atMost`.
std::vector<Model> ExplanationSearch::ranked(std::vector<Model> models, double atMost) {
  std::vector<Trial> trials;
  std::vector<std::size_t> cheap;  // what would take too long is kept, as the last one
  for (std::size_t k = 0; k < models.size(); ++k) {
    const std::optional<Trial> trial = accurate(models[k]);
    if (trial && costOf(*trial, motion_, first_) <= kDearlyRanked) trials.push_back(*trial), cheap.push_back(k);
  }
  const std::vector<Run> runs = runAll(trials, kInfinity);
  std::vector<double> distances(models.size(), atMost);
  for (std::size_t k = 0; k < trials.size(); ++k) distances[cheap[k]] = accounted(trials[k], runs[k]);
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t k = 0; k < models.size(); ++k) {
    const bool dependsOnStep = std::ranges::any_of(models[k].made, [](const Mistake* one) {
      return one->kind == Mistake::Kind::Pins || one->kind == Mistake::Kind::Order;
    });
    if (distances[k] <= atMost || dependsOnStep) order.emplace_back(distances[k], k);
  }
  std::ranges::sort(order);
  std::vector<Model> sorted;
  sorted.reserve(order.size());
  for (const auto& [distance, k] : order) sorted.push_back(std::move(models[k]));
  return sorted;
}

std::vector<Model> ExplanationSearch::pairs() const {
  std::vector<Model> pairs;
  for (const Mistake& one : mistakes()) {
    for (const Mistake& two : mistakes()) {
      if (&two <= &one || one.kind == two.kind) continue;
      Model pair = withMistake(withMistake(plain_, one), two);
      if (pair.made.size() == 2) pairs.push_back(std::move(pair));
    }
  }
  return pairs;
}

/// The models one after the other; on several threads the tries of some are run ahead together.
std::optional<Explanation> ExplanationSearch::search(const std::vector<Model>& models, const Steps& steps) {
  const std::size_t atOnce = threads_.threads() == 1 ? 1 : 16 * std::size_t(threads_.threads());
  for (std::size_t begin = 0; begin < models.size();) {
    std::vector<Trial> trials;
    std::vector<std::size_t> ends;
    for (std::size_t k = begin; k < models.size() && trials.size() < atOnce; ++k) {
      std::ranges::copy(trialsOf(models[k], Breadth::Students, steps), std::back_inserter(trials));
      ends.push_back(trials.size());
    }
    const std::vector<Run> runs = runAll(trials, near());
    std::size_t next = 0;
    for (const std::size_t end : ends) {
      std::vector<Tried> tried;
      for (; next < end; ++next) {
        const double distance = accounted(trials[next], runs[next]);
        if (std::isfinite(distance)) tried.push_back({trials[next], distance});
      }
      if (isOver()) return std::nullopt;
      if (std::optional<Explanation> found = exactOf(tried)) return found;
    }
    begin += ends.size();
  }
  return std::nullopt;
}

std::vector<StepAim> ExplanationSearch::aims(std::span<const Model> models) {
  std::vector<AimTrials> trials;
  for (const Model& model : models) {
    for (const Way& way : waysOf(model, Breadth::Students)) {
      const std::optional<AimTrials> both = aimTrials(model, way, all_);
      if (!both) continue;
      const double longer = costOf(both->longer, motion_, first_), shorter = costOf(both->shorter, motion_, first_);
      if (std::max(longer, shorter) > kDearlyRanked || !spend(longer + shorter)) continue;
      trials.push_back(*both);
    }
  }
  std::vector<std::optional<StepAim>> found(trials.size());
  const AimTarget target{.motion = &motion_, .samples = first_, .least = unamplified(first_ - 1), .goesOn = [this] {
                           return threads_.goesOn();
                         }};
  threads_.forEach(trials.size(), [&](std::size_t k) {
    if (threads_.goesOn()) found[k] = aimed(trials[k], target);
  });
  std::vector<StepAim> aims;
  for (const std::optional<StepAim>& aim : found) {
    if (aim) aims.push_back(*aim);
  }
  return aims;
}

std::vector<Trial> ExplanationSearch::trialsAround(std::span<const StepAim> aims) const {
  constexpr double kAside = 1.7;  // times as long or short as the step aimed at
  std::vector<Trial> trials;
  for (const StepAim& aim : aims) {
    for (const double dt : all_) {
      if (dt <= kAside * aim.dt && dt >= aim.dt / kAside) trials.push_back({aim.model, aim.way, dt});
    }
  }
  return trials;
}

std::optional<Explanation> ExplanationSearch::searchByAim(std::span<const Model> models) {
  constexpr std::size_t kMostAims = 40;
  std::vector<StepAim> best = aims(models);
  if (stopped()) return std::nullopt;
  std::ranges::stable_sort(best, {}, &StepAim::missed);
  if (best.size() > kMostAims) best.resize(kMostAims);
  std::vector<Tried> tried;
  tryAll(trialsAround(best), near(), tried);
  return exactOf(tried);
}

/// Without a mistake, or with one of two alone, where that fits as well: what is left out then makes no difference.
Explanation ExplanationSearch::simplest(const Explanation& found) {
  std::vector<Model> simpler{plain_};
  for (const Mistake* mistake : found.model.made) simpler.push_back(withMistake(plain_, *mistake));
  const double asWell = std::max({kAsWell * found.distance, kRounding * size_, std::ranges::max(motion_.rounding)});
  for (const Model& model : simpler) {
    const Tried tried{.trial = {&model, found.way, found.dt}};
    Explanation of = judgedFirst(std::span(&tried, 1), 1).front();
    if (of.exact && of.distance <= asWell) return of;
  }
  return found;
}

std::optional<Explanation> ExplanationSearch::mistaken(double fromTruth) {
  std::vector<Model> models;
  for (const Mistake& mistake : mistakes()) {
    Model model = withMistake(plain_, mistake);
    if (!model.made.empty()) models.push_back(std::move(model));
  }
  const double atMost = kFar * std::max(fromTruth, unamplified(first_ - 1));
  singles_ = ranked(std::move(models), atMost);
  std::optional<Explanation> found = search(singles_, likely_);
  if (!found && !stopped()) found = searchByAim(singles_);
  if (!found && !stopped()) {
    pairs_ = ranked(pairs(), atMost);
    found = search(pairs_, likely_);
    if (!found && !stopped()) found = searchByAim(std::span(pairs_).first(std::min(pairs_.size(), kMostAimed)));
  }
  if (!found && !stopped()) found = search(singles_, others_);
  if (!found && !stopped()) found = search(pairs_, others_);
  if (found) return simplest(*found);
  if (stopped()) return found;
  // No program in double does that: for want of better the nearest one.
  std::vector<Tried> tried;
  for (const std::vector<Model>* list : {&singles_, &pairs_}) {
    for (std::size_t k = 0; k < std::min(list->size(), kKept) && !stopped(); ++k) {
      tryAll(trialsOf((*list)[k], Breadth::Students, likely_.empty() ? others_ : likely_), kInfinity, tried);
    }
  }
  return nearestOf(tried);
}

std::vector<double> ExplanationSearch::distances(const Model& model, const Explanation& of) {
  const Trial trial{&model, of.way, of.dt};
  return fitOf(trial, motion_, {.samples = motion_.times.size(), .goesOn = [this] { return threads_.goesOn(); }})
      .distances;
}

double ExplanationSearch::withoutMistake(const Explanation& of) {
  const std::vector<double> apart = distances(plain_, of);
  double largest = 0;
  for (std::size_t k = 0; k < apart.size() && motion_.times[k] <= of.judgedUpTo; ++k) {
    largest = std::max(largest, apart[k]);
  }
  return largest;
}

}  // namespace tyg
