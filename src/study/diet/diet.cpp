// First every change alone, then greedily together: those that are within the tolerance alone, the one that saves most
// first, each on top of those that were kept before it.
#include "study/diet/diet.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "study/motion/progress.h"
#include "study/motion/resampled.h"
#include "tyg/methods.h"

namespace tyg {
namespace {

constexpr double kAloneShare = 0.6;  // of the whole work, about as measured
/// Costs that differ by less than this fraction count as the same.
constexpr double kSameCost = 0.1;

/// What a unit of a scene's work costs, counted: the machine's noise must not decide. Solves are priced by the clock,
/// in force evaluations of the same scene.
double countedUnit(const Scene& scene, const DietPlan& plan) {
  if (!findMethod(scene.integrator).solves) return countedCost(scene);
  Scene explicitly = scene;
  explicitly.integrator = "symplectic-euler";
  return countedCost(scene) * plan.cost(scene, plan.threads) / plan.cost(explicitly, plan.threads);
}

double sagOf(const std::vector<Vec3>& positions) {
  const auto [lowest, highest] = std::ranges::minmax(positions, {}, &Vec3::y);
  return highest.y - lowest.y;
}

/// Runs one scene and measures it as a row against the full model's reference; `judgedUpTo` as in Diet. A sheet of
/// another grid is compared at the positions of the reference's particles.
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
  row.counted = static_cast<double>(row.work) * countedUnit(changed.scene, plan);
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
  row.energy = motion.ledger.mechanical();
  return row;
}

/// What every row of one diet is measured with.
struct Measures {
  const Reference& reference;
  DietPlan plan;              // its observer tells `progress`
  double judgedUpTo = 0;      // s, as Diet::judgedUpTo
  double writtenSeconds = 0;  // of the scene as written
  Progress& progress;
};

DietRow rowOf(const Changed& changed, const Measures& measures) {
  DietRow row = dietRow(changed, measures.reference, measures.judgedUpTo, measures.plan);
  row.saved = 1 - row.seconds / measures.writtenSeconds;
  return row;
}

/// What a run costs at least, counted, known before it is made: methods that cost too much need not be run to be left
/// out.
double leastCost(const Scene& scene, const DietPlan& plan) {
  const int perStep = std::max(findMethod(scene.integrator).evaluationsPerStep, 1);
  return scene.duration / scene.dt * perStep * countedUnit(scene, plan);
}

bool better(const DietRow& a, const DietRow& b) {
  if (a.within != b.within) return a.within;
  const bool sameCost = std::abs(a.counted - b.counted) < kSameCost * std::min(a.counted, b.counted);
  if (a.within && !sameCost) return a.counted < b.counted;
  return a.lost.rms < b.lost.rms || (std::isnan(b.lost.rms) && !std::isnan(a.lost.rms));
}

/// The row of a change on top of `base`: of several ways the cheapest within the tolerance, or where there is none
/// the one that loses least. Nothing where the change does not apply.
std::optional<DietRow> bestOf(const Change& change, const DietRow& base, const Measures& measures) {
  std::optional<DietRow> best;
  for (const Changed& changed : changesOf(base.scene, change)) {
    if (change.kind == Change::Method && leastCost(changed.scene, measures.plan) > base.counted) continue;
    const DietRow next = rowOf(changed, measures);
    if (measures.progress.stopped()) return std::nullopt;
    if (change.kind == Change::Method && !(next.counted < (1 - kSameCost) * base.counted)) continue;
    if (!best || better(next, *best)) best = next;
    if (change.kind == Change::Step && !next.within) break;
  }
  return best;
}

using ChangeRow = std::pair<Change, DietRow>;

/// Every change that applies, alone.
std::vector<ChangeRow> aloneOn(const DietRow& written, const Measures& measures) {
  std::vector<ChangeRow> alone;
  const std::vector<Change> changes = allChanges(written.scene);
  for (std::size_t k = 0; k < changes.size() && !measures.progress.stopped(); ++k) {
    measures.progress.advanceTo(kAloneShare * static_cast<double>(k) / static_cast<double>(changes.size()));
    if (std::optional<DietRow> best = bestOf(changes[k], written, measures)) {
      alone.emplace_back(changes[k], std::move(*best));
    }
  }
  return alone;
}

/// The changes that are within the tolerance alone, the one that saves most first.
std::vector<Change> worthKeeping(std::vector<ChangeRow> alone) {
  std::ranges::stable_sort(alone, [](const auto& a, const auto& b) { return a.second.counted < b.second.counted; });
  std::vector<Change> changes;
  for (const auto& [change, row] : alone) {
    if (row.within) changes.push_back(change);
  }
  return changes;
}

/// Whether a change pays: it saves, or it costs the same and loses nothing more.
bool pays(const DietRow& next, const DietRow& base) {
  if (next.counted < (1 - kSameCost) * base.counted) return true;
  return next.counted < (1 + kSameCost) * base.counted && next.lost.rms <= base.lost.rms;
}

/// Makes one change after the other, and keeps those that pay and with which the scene still is within the tolerance.
std::vector<DietRow> togetherOn(const DietRow& written, std::vector<Change> open, const Measures& measures) {
  std::vector<DietRow> together;
  const double all = static_cast<double>(open.size()) + 1;
  while (!open.empty() && !measures.progress.stopped()) {
    measures.progress.advanceTo(1 - (1 - kAloneShare) * static_cast<double>(open.size()) / all);
    const Change change = open.front();
    open.erase(open.begin());
    const DietRow& base = together.empty() ? written : together.back();
    std::optional<DietRow> next = bestOf(change, base, measures);
    if (!next || !next->within || !pays(*next, base)) continue;
    together.push_back(std::move(*next));
    if (repeats(change)) open.push_back(change);
  }
  return together;
}

}  // namespace

Diet dietOf(const Scene& scene, const Reference& reference, const DietPlan& plan) {
  Progress progress(plan.observer);
  Diet diet;
  diet.within = plan.within;
  diet.judgedUpTo = reference.horizonOf(plan.within, Precision::Double);
  Measures measures{.reference = reference, .plan = plan, .judgedUpTo = diet.judgedUpTo, .progress = progress};
  measures.plan.observer = [&](double) { return progress.goesOn(); };
  diet.written = dietRow({DietRow{}.words, scene}, reference, diet.judgedUpTo, measures.plan);
  measures.writtenSeconds = diet.written.seconds;
  const std::vector<ChangeRow> alone = aloneOn(diet.written, measures);
  for (const auto& [change, row] : alone) diet.alone.push_back(row);
  if (diet.written.within) diet.together = togetherOn(diet.written, worthKeeping(alone), measures);
  diet.stopped = progress.stopped();
  return diet;
}

}  // namespace tyg
