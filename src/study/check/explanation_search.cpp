// Most tries end after the first times, at which two different programs are already apart. What is left is run to the
// end, with a twin beside it where rounding errors may have grown.
#include "study/check/explanation_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "study/check/vectors.h"
#include "study/motion/error.h"
#include "tyg/methods.h"

namespace tyg {
namespace {

constexpr double kSame = 1e-9;       // of the size: two programs that do the same are as near as this ...
constexpr double kRounding = 1e-13;  // ... but for their rounding errors, of the size, times the amplification
constexpr double kLost = 1e6;        // an amplification past which nothing can be told
constexpr double kNear = kRounding * kLost * 10;  // of the size
constexpr double kMoved = 0.01;                   // of the size: so far the sheet has moved by the first times
constexpr double kMostEffort = 2e9;               // evaluations of one spring, a few ns each
constexpr double kFar = 5;             // an accurate model so many times as far away as the truth explains nothing
constexpr double kDearlyRanked = 3e7;  // so much a single run may cost that only gives an order
constexpr std::size_t kMostToTheEnd = 10, kMostAimed = 50, kKept = 4;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// s: symplectic Euler is stable below, and Runge-Kutta 4 exact enough to tell mistakes apart. Each of the twelve
/// springs of a particle adds at most twice its stiffness and its damping to the largest of all waves.
double moderateStep(const Scene& scene) {
  double stiffness = 0, damping = 0;
  for (const SpringFamily& family : {scene.structural, scene.shear, scene.bend}) {
    stiffness += 8 * family.ks, damping += 8 * family.kd;
  }
  const double w2 = stiffness / scene.particleMass, d = (damping + scene.drag) / scene.particleMass;
  if (w2 == 0) return d == 0 ? kInfinity : 2 / d;
  return (std::sqrt(d * d + 4 * w2) - d) / w2;
}

/// How many samples a try is run to at first: until the sheet has moved, and not more than a third of all.
std::size_t firstSamples(const GivenMotion& motion, const Scene& scene, double size) {
  const std::size_t least = motion.times.front() > 0 ? 1 : 2, all = motion.times.size();
  std::vector<Vec3> start;
  const Sheet sheet = makeSheet(scene);
  start.reserve(std::size_t(sheet.count()));
  for (int particle = 0; particle < sheet.count(); ++particle) start.push_back(sheet.startPosition(particle));
  std::size_t first = std::min(all, least);
  const auto moved = [&] { return distanceBetween(motion.positions[first - 1], start).rms; };
  while (first < std::max(least, all / 3) && moved() < kMoved * size) ++first;
  return std::min(first, all);
}

}  // namespace

ExplanationSearch::ExplanationSearch(const Scene& scene, const GivenMotion& motion, std::optional<double> step,
                                     std::function<bool(double)> goesOn)
    : motion_(motion), goesOn_(std::move(goesOn)), size_(makeSheet(scene).size()) {
  plain_.scene = scene;
  first_ = firstSamples(motion, scene, size_);
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
  if (goesOn_ && !goesOn_(std::min(1.0, spent_ / most_))) stopped_ = true;
  return !stopped_ && spent_ <= most_;
}

double ExplanationSearch::distanceOf(const Trial& trial, std::size_t samples, double enough) {
  if (!spend(0)) return kInfinity;
  const auto goesOn = [this] { return !goesOn_ || goesOn_(std::min(1.0, spent_ / most_)); };
  const Fit fit = fitOf(trial, motion_, {.samples = samples, .enough = enough, .goesOn = goesOn});
  stopped_ = stopped_ || fit.stopped;
  if (!fit.distances.empty()) spend(costOf(trial, motion_, fit.distances.size()));
  return fit.upTo(samples);
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

void ExplanationSearch::tryAll(const Model& model, Breadth breadth, const Steps& steps, double enough,
                               std::vector<Tried>& tried) {
  constexpr double kDear = 1.5e8;
  for (const double dt : steps) {
    for (const Way& way : waysOf(model, breadth)) {
      const Trial trial{&model, way, dt};
      if (all_.size() > 1 && costOf(trial, motion_, first_) > kDear) continue;
      const double distance = distanceOf(trial, first_, enough);
      if (stopped_) return;
      if (std::isfinite(distance)) tried.push_back({&model, trial, distance});
    }
  }
}

/// Runs a try to the end, with a twin where it drifts away by little.
Explanation ExplanationSearch::judged(const Trial& trial) {
  const std::size_t all = motion_.times.size();
  Explanation of{.model = *trial.model, .way = trial.way, .dt = trial.dt};
  const double cost = costOf(trial, motion_, all);
  const auto goesOn = [this] { return !goesOn_ || goesOn_(std::min(1.0, spent_ / most_)); };
  const auto runs = [&](bool twin) {
    spend(twin ? 2 * cost : cost);
    Fit fit = fitOf(trial, motion_, {.samples = all, .twin = twin, .goesOn = goesOn});
    stopped_ = stopped_ || fit.stopped;
    return fit;
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
  if (of.exact || !startsWell || stopped_) return of;
  const double distance = of.distance;
  judge(runs(true));
  if (!of.exact) of.distance = distance, of.judgedUpTo = motion_.times.back();
  return of;
}

/// Of those that are near at the first times, the nearest that stays so.
std::optional<Explanation> ExplanationSearch::exactOf(std::vector<Tried>& tried) {
  std::ranges::stable_sort(tried, {}, &Tried::distance);
  std::optional<Explanation> best;
  for (std::size_t k = 0; k < std::min(tried.size(), kMostToTheEnd) && !stopped_; ++k) {
    if (tried[k].distance > near()) break;
    const Explanation of = judged(tried[k].trial);
    if (of.exact && (!best || of.distance < best->distance)) best = of;
  }
  return best;
}

std::optional<Explanation> ExplanationSearch::nearestOf(std::vector<Tried>& tried) {
  std::ranges::stable_sort(tried, {}, &Tried::distance);
  std::optional<Explanation> nearest;
  for (std::size_t k = 0; k < std::min(tried.size(), kKept) && !stopped_; ++k) {
    const Explanation of = judged(tried[k].trial);
    if (!nearest || of.distance < nearest->distance) nearest = of;
  }
  return nearest;
}

std::optional<Explanation> ExplanationSearch::right() {
  std::vector<Tried> tried;
  for (const Method& method : methods()) {
    if (!method.adaptive) continue;
    const Trial trial{&plain_, {&method, nullptr}, 0};
    const double distance = distanceOf(trial, first_, kInfinity);
    if (std::isfinite(distance)) tried.push_back({&plain_, trial, distance});
  }
  tryAll(plain_, Breadth::All, likely_, kInfinity, tried);
  for (const Way& way : waysOf(plain_, Breadth::Students)) {
    const std::optional<Aim> aim = stopped_ ? std::nullopt : aimed(plain_, way);
    if (aim) tryAround(*aim, kInfinity, tried);
  }
  std::optional<Explanation> found = exactOf(tried);
  if (stopped_) return found;
  return found ? nearestStep(*found) : nearestOf(tried);
}

/// Exact methods are the same as any fine step of theirs: the step is the one that fits best.
Explanation ExplanationSearch::nearestStep(const Explanation& found) {
  if (found.dt == 0 || found.distance <= kRounding * size_) return found;
  std::vector<Tried> tried;
  for (const double dt : all_) {
    const Trial trial{&plain_, found.way, dt};
    const double distance = dt < found.dt && !stopped_ ? distanceOf(trial, first_, near()) : kInfinity;
    if (std::isfinite(distance)) tried.push_back({&plain_, trial, distance});
  }
  const std::optional<Explanation> other = exactOf(tried);
  return other && other->distance < found.distance ? *other : found;
}

std::optional<Explanation> ExplanationSearch::rightAtAnyStep() {
  std::vector<Tried> tried;
  tryAll(plain_, Breadth::Students, others_, near(), tried);
  std::optional<Explanation> found = exactOf(tried);
  if (found || stopped_) return found;
  tryAll(plain_, Breadth::All, others_, near(), tried);
  return exactOf(tried);
}

/// The models by how near they are when they are run accurately, without those that are further away than `atMost`.
std::vector<Model> ExplanationSearch::ranked(std::vector<Model> models, double atMost) {
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t k = 0; k < models.size() && !stopped_; ++k) {
    const std::optional<Trial> trial = accurate(models[k]);
    // What would take too long is kept, as the last one.
    const bool isCheap = trial && costOf(*trial, motion_, first_) <= kDearlyRanked;
    const double distance = isCheap ? distanceOf(*trial, first_, kInfinity) : atMost;
    const bool dependsOnStep = std::ranges::any_of(models[k].made, [](const Mistake* one) {
      return one->kind == Mistake::Kind::Pins || one->kind == Mistake::Kind::Order;
    });
    if (distance <= atMost || dependsOnStep) order.emplace_back(distance, k);
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

std::optional<Explanation> ExplanationSearch::search(const std::vector<Model>& models, const Steps& steps) {
  for (const Model& model : models) {
    std::vector<Tried> tried;
    tryAll(model, Breadth::Students, steps, near(), tried);
    if (stopped_ || spent_ > most_) return std::nullopt;
    if (std::optional<Explanation> found = exactOf(tried)) return found;
  }
  return std::nullopt;
}

/// Two steps of one method tell which third one would fit: how far a motion is from the given one is e + c h^p, of the
/// order p, and where the model is right e and c lie on one line.
std::optional<ExplanationSearch::Aim> ExplanationSearch::aimed(const Model& model, const Way& way) {
  const double limit = moderateStep(model.scene);
  double longer = 0, shorter = 0;
  for (const double dt : all_) {
    if (!(dt > limit)) longer = std::max(longer, dt);
  }
  for (const double dt : all_) {
    if (dt <= longer / 2) shorter = std::max(shorter, dt);
  }
  if (shorter == 0) return std::nullopt;
  const auto end = [&](double dt) {
    const Trial trial{&model, way, dt};
    const double cost = costOf(trial, motion_, first_);
    if (cost > kDearlyRanked || !spend(cost)) return std::vector<Vec3>{};
    return fitOf(trial, motion_, {.samples = first_, .goesOn = {}}).last;
  };
  const std::vector<Vec3> a = end(longer), b = end(shorter), &given = motion_.positions[first_ - 1];
  if (a.empty() || b.empty()) return std::nullopt;
  // With c as the difference of the two, the shorter one's distance is s c plus what no step takes away.
  double cc = 0, cb = 0, bb = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vec3 c = a[i] - b[i], r = b[i] - given[i];
    cc += dot(c, c), cb += dot(c, r), bb += dot(r, r);
  }
  if (!(cc > 0) || !std::isfinite(cb)) return std::nullopt;
  const double s = cb / cc;
  const int order = way.order();
  const double power = std::pow(shorter, order) - s * (std::pow(longer, order) - std::pow(shorter, order));
  const double left = std::sqrt(std::max(0.0, bb - cb * cb / cc) / double(a.size()));
  Aim aim{.model = &model, .way = way, .dt = power > 0 ? std::pow(power, 1.0 / order) : shorter, .missed = 0};
  aim.missed = left / std::max(std::sqrt(bb / double(a.size())), unamplified(first_ - 1));
  return aim;
}

std::optional<Explanation> ExplanationSearch::searchByAim(std::span<const Model> models) {
  constexpr std::size_t kMostAims = 40;
  std::vector<Aim> aims;
  for (const Model& model : models) {
    for (const Way& way : waysOf(model, Breadth::Students)) {
      if (stopped_) return std::nullopt;
      if (const std::optional<Aim> aim = aimed(model, way)) aims.push_back(*aim);
    }
  }
  std::ranges::stable_sort(aims, {}, &Aim::missed);
  if (aims.size() > kMostAims) aims.resize(kMostAims);
  std::vector<Tried> tried;
  for (const Aim& aim : aims) tryAround(aim, near(), tried);
  return exactOf(tried);
}

void ExplanationSearch::tryAround(const Aim& aim, double enough, std::vector<Tried>& tried) {
  constexpr double kAside = 1.7;  // times as long or short as the step aimed at
  for (const double dt : all_) {
    if (stopped_) return;
    if (dt > kAside * aim.dt || dt < aim.dt / kAside) continue;
    const Trial trial{aim.model, aim.way, dt};
    const double distance = distanceOf(trial, first_, enough);
    if (std::isfinite(distance)) tried.push_back({aim.model, trial, distance});
  }
}

/// One mistake alone where it fits as well: the other one then makes no difference.
Explanation ExplanationSearch::oneOfTwo(const Explanation& found) {
  for (const Mistake* mistake : found.model.made) {
    const Model single = withMistake(plain_, *mistake);
    Explanation of = judged({&single, found.way, found.dt});
    if (of.exact) return of;
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
  if (!found && !stopped_) found = searchByAim(singles_);
  if (!found && !stopped_) {
    pairs_ = ranked(pairs(), atMost);
    found = search(pairs_, likely_);
    if (!found && !stopped_) found = searchByAim(std::span(pairs_).first(std::min(pairs_.size(), kMostAimed)));
  }
  if (!found && !stopped_) found = search(singles_, others_);
  if (!found && !stopped_) found = search(pairs_, others_);
  if (found && found->model.made.size() == 2) return oneOfTwo(*found);
  if (found || stopped_) return found;
  // No program in double does that: for want of better the nearest one.
  std::vector<Tried> tried;
  for (const std::vector<Model>* list : {&singles_, &pairs_}) {
    for (std::size_t k = 0; k < std::min(list->size(), kKept) && !stopped_; ++k) {
      tryAll((*list)[k], Breadth::Students, likely_.empty() ? others_ : likely_, kInfinity, tried);
    }
  }
  return nearestOf(tried);
}

double ExplanationSearch::withoutMistake(const Explanation& of) {
  Trial trial{&plain_, of.way, of.dt};
  const Fit fit = fitOf(trial, motion_, {.samples = motion_.times.size(), .goesOn = {}});
  double largest = 0;
  for (std::size_t k = 0; k < fit.distances.size() && motion_.times[k] <= of.judgedUpTo; ++k) {
    largest = std::max(largest, fit.distances[k]);
  }
  return largest;
}

}  // namespace tyg
