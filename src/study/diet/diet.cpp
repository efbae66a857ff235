// One change at a time, then greedily together.
#include "study/diet/diet.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "study/motion/resampled.h"
#include "tyg/methods.h"

namespace tyg {
namespace {

constexpr double kAloneShare = 0.6;  // of the whole work, about as measured
/// Costs closer than this are not told apart: no verdict shall hang on a machine's noise.
constexpr double kSameCost = 0.1;

class DietMaker {
 public:
  DietMaker(const Scene& scene, const Reference& reference, const DietPlan& plan)
      : scene_(scene), reference_(reference), plan_(plan) {
    plan_.observer = [this, &plan](double) {
      if (plan.observer && !plan.observer(fraction_)) diet_.stopped = true;
      return !diet_.stopped;
    };
    diet_.within = plan.within;
    diet_.judgedUpTo = reference.horizonOf(plan.within, Precision::Double);
  }

  Diet make() {
    diet_.written = row({DietRow{}.words, scene_});
    diet_.written.saved = 0;
    const std::vector<Change> changes = allChanges();
    for (std::size_t k = 0; k < changes.size() && !diet_.stopped; ++k) {
      fraction_ = kAloneShare * static_cast<double>(k) / static_cast<double>(changes.size());
      if (std::optional<DietRow> best = bestOf(changes[k], diet_.written)) {
        alone_.emplace_back(changes[k], *best);
        diet_.alone.push_back(std::move(*best));
      }
    }
    if (!diet_.stopped && diet_.written.within) keepTogether();
    return std::move(diet_);
  }

 private:
  DietRow row(const Changed& changed) {
    DietRow row = dietRow(changed, reference_, diet_.judgedUpTo, plan_);
    row.saved = 1 - row.seconds / diet_.written.seconds;
    return row;
  }

  /// The row of a change on top of `base`: of several ways the cheapest within the tolerance, or where there is none
  /// the one that loses least. Nothing where the change does not apply.
  std::optional<DietRow> bestOf(const Change& change, const DietRow& base) {
    std::optional<DietRow> best;
    for (const Changed& changed : changesOf(base.scene, change)) {
      if (change.kind == Change::Method && leastSeconds(changed.scene) > base.seconds) continue;
      const DietRow next = row(changed);
      if (diet_.stopped) return std::nullopt;
      if (change.kind == Change::Method && !(next.seconds < (1 - kSameCost) * base.seconds)) continue;
      if (!best || better(next, *best)) best = next;
      if (change.kind == Change::Step && !next.within) break;
    }
    return best;
  }

  /// What a run takes at least, known before it: dear methods need not be run to be left out.
  [[nodiscard]] double leastSeconds(const Scene& scene) const {
    const int perStep = std::max(findMethod(scene.integrator).evaluationsPerStep, 1);
    return scene.duration / scene.dt * perStep * plan_.cost(scene, plan_.threads);
  }

  static bool better(const DietRow& a, const DietRow& b) {
    if (a.within != b.within) return a.within;
    const bool sameCost = std::abs(a.seconds - b.seconds) < kSameCost * std::min(a.seconds, b.seconds);
    if (a.within && !sameCost) return a.seconds < b.seconds;
    return a.lost.rms < b.lost.rms || (std::isnan(b.lost.rms) && !std::isnan(a.lost.rms));
  }

  void keepTogether() {
    std::ranges::stable_sort(alone_, [](const auto& a, const auto& b) { return a.second.saved > b.second.saved; });
    std::vector<Change> open;
    for (const auto& [change, row] : alone_) {
      if (row.within) open.push_back(change);
    }
    const double all = static_cast<double>(open.size()) + 1;
    while (!open.empty() && !diet_.stopped) {
      fraction_ = std::max(fraction_, 1 - (1 - kAloneShare) * static_cast<double>(open.size()) / all);
      const Change change = open.front();
      open.erase(open.begin());
      const std::optional<DietRow> next = bestOf(change, diet_.leanest());
      if (!next || !next->within || next->seconds > (1 + kSameCost) * diet_.leanest().seconds) continue;
      diet_.together.push_back(*next);
      if (repeats(change)) open.push_back(change);
    }
  }

  const Scene& scene_;
  const Reference& reference_;
  DietPlan plan_;
  Diet diet_;
  std::vector<std::pair<Change, DietRow>> alone_;
  double fraction_ = 0;
};

double sagOf(const std::vector<Vec3>& positions) {
  const auto [lowest, highest] = std::ranges::minmax(positions, {}, &Vec3::y);
  return highest.y - lowest.y;
}

}  // namespace

DietRow dietRow(const Changed& changed, const Reference& reference, double judgedUpTo, const DietPlan& plan) {
  DietRow row;
  row.words = changed.words;
  row.scene = changed.scene;
  const Method& method = findMethod(changed.scene.integrator);
  const std::vector<double>& times = reference.motion.times;
  const SampledMotion motion =
      sampledRun(changed.scene, method, times, {.threads = plan.threads, .observer = plan.observer});
  row.work = workOf(method, motion);
  row.seconds = static_cast<double>(row.work) * plan.cost(changed.scene, plan.threads);
  const auto judged = static_cast<std::size_t>(std::ranges::upper_bound(times, judgedUpTo) - times.begin());
  if (judged > 0) row.floor = reference.floorAt(judged - 1, changed.scene.precision);
  if (motion.stopped || motion.status != Status::Ok) {
    row.status = motion.stopped                      ? RowStatus::TooSlow
                 : motion.status == Status::Unstable ? RowStatus::Unstable
                                                     : RowStatus::NotFinite;
    return row;
  }
  const SampledMotion here = upTo(judgedUpTo, resampled(motion, changed.scene, reference.scene));
  row.lost = motionError(here, upTo(judgedUpTo, reference.motion));
  for (std::size_t k = 0; k < judged; ++k) {
    if (distanceBetween(here.positions[k], reference.motion.positions[k]).rms == row.lost.rms) row.worstAt = times[k];
  }
  row.horizon = reference.horizonOf(row.lost.rms, changed.scene.precision);
  row.within = judged > 0 && row.lost.rms <= plan.within;
  row.maxStretch = motion.ledger.maxStretch;
  row.sag = sagOf(motion.positions.back());
  row.energy = motion.ledger.kinetic + motion.ledger.elastic + motion.ledger.gravitational;
  return row;
}

Diet dietOf(const Scene& scene, const Reference& reference, const DietPlan& plan) {
  return DietMaker(scene, reference, plan).make();
}

}  // namespace tyg
