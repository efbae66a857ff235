// A scene is refined once in each direction: in time, and on the sheet.
#include "study/diet/model_needs.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include "core/scene/bodies.h"
#include "study/motion/progress.h"
#include "study/motion/resampled.h"
#include "tyg/methods.h"

namespace tyg {
namespace {

constexpr double kTolerance = 1e-6;  // of the size: far below any change of the model, and cheap
/// Shares of the whole work: the finer sheet has four times the particles and twice the steps.
constexpr double kStepShare = 0.1, kSheetShare = 0.9;

/// What every comparison of one scene needs.
struct Search {
  const Scene& scene;
  const Reference& reference;
  double upTo;  // s
  int threads;
  Progress progress;
};

/// A finer version of the scene, and what it costs as a share of the whole work.
struct Finer {
  Need::Kind kind;
  std::string words;
  Scene scene;
  double share;
};

SampledMotion run(const Scene& scene, double share, Search& search) {
  const double done = search.progress.fraction();
  const auto observer = [&](double time) { return search.progress.reach(done + share * time / scene.duration); };
  SampledMotion motion = sampledRun(scene, findMethod(scene.integrator), search.reference.motion.times,
                                    {.threads = search.threads, .observer = observer});
  search.progress.advanceTo(done + share);
  return motion;
}

/// How far the finer version is from `with`; nothing where somebody said stop.
std::optional<Need> compared(const Finer& finer, const SampledMotion& with, Search& search) {
  if (search.progress.stopped()) return std::nullopt;
  const SampledMotion motion = run(finer.scene, finer.share, search);
  if (search.progress.stopped()) return std::nullopt;
  Need need{finer.kind, finer.words, {}, with.ledger.maxStretch, motion.ledger.maxStretch};
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  const bool whole = motion.status == Status::Ok && with.status == Status::Ok;
  need.change =
      whole ? motionError(upTo(search.upTo, resampled(motion, finer.scene, search.scene)), upTo(search.upTo, with))
            : Distance{kUnknown, kUnknown};
  return need;
}

Finer withHalfTheStep(Scene scene) {
  const bool adaptive = findMethod(scene.integrator).adaptive;
  adaptive ? scene.tolerance /= 10 : scene.dt /= 2;
  std::string words =
      adaptive ? fmt::format("tolerance {:.3g} m", scene.tolerance) : fmt::format("step {:.3g} ms", 1000 * scene.dt);
  return {Need::Kind::Step, std::move(words), std::move(scene), kStepShare / 2};
}

/// On twice as fine a sheet, by an exact method; nothing for a sheet of one row or column, and where that would be too
/// large.
std::optional<Finer> onAFinerSheet(const Scene& scene, double size) {
  const int columns = 2 * scene.columns - 1, rows = 2 * scene.rows - 1;
  if (scene.columns == 1 || scene.rows == 1 || std::max(columns, rows) > kLargestCount) return std::nullopt;
  Scene finer = withSheet(scene, columns, rows);
  finer.integrator = "dopri54";
  finer.precision = Precision::Double;
  finer.tolerance = std::min(kTolerance * size, largestTolerance(finer));
  return Finer{Need::Kind::Sheet, fmt::format("sheet {}x{}", columns, rows), std::move(finer), kSheetShare};
}

/// The up to eight particles around one.
std::vector<int> neighbours(const Sheet& sheet, int particle) {
  const int column = particle % sheet.columns, row = particle / sheet.columns;
  std::vector<int> around;
  for (int r = std::max(row - 1, 0); r <= std::min(row + 1, sheet.rows - 1); ++r) {
    for (int c = std::max(column - 1, 0); c <= std::min(column + 1, sheet.columns - 1); ++c) {
      if (c != column || r != row) around.push_back(r * sheet.columns + c);
    }
  }
  return around;
}

}  // namespace

std::optional<FirstCrossing> firstCrossingOf(const Scene& scene, const SampledMotion& motion, double upTo) {
  Sheet sheet = makeSheet(scene);
  for (std::size_t k = 0; k < motion.positions.size() && motion.times[k] <= upTo; ++k) {
    if (k < motion.missing.size()) sheet.missing = motion.missing[k];
    if (const auto cells = firstCrossing(sheet, motion.positions[k])) return FirstCrossing{motion.times[k], *cells};
  }
  return std::nullopt;
}

bool hangsByPoints(const Scene& scene) {
  const Sheet sheet = makeSheet(scene);
  if (sheet.columns == 1 || sheet.rows == 1) return false;
  return std::ranges::any_of(sheet.pins, [&](int pin) {
    const auto isPinned = [&](int particle) { return std::ranges::binary_search(sheet.pins, particle); };
    return std::ranges::none_of(neighbours(sheet, pin), isPinned);
  });
}

std::vector<Need> needsOf(const Scene& scene, const Reference& reference, double upTo, int threads,
                          const std::function<bool(double)>& observer) {
  Search search{scene, reference, upTo, threads, Progress(observer)};
  std::vector<Need> needs;
  const auto add = [&](const std::optional<Need>& need) {
    if (need) needs.push_back(*need);
  };
  // The scene's own step is compared with half of it, everything else with the exact motion of the scene.
  const SampledMotion written = run(scene, kStepShare / 2, search);
  add(compared(withHalfTheStep(scene), written, search));
  if (const auto finer = onAFinerSheet(scene, reference.size)) add(compared(*finer, reference.motion, search));
  return needs;
}

}  // namespace tyg
