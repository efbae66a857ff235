// Refining a scene once, in each direction.
#include "study/diet/model_needs.h"

#include <algorithm>
#include <limits>

#include <fmt/core.h>

#include "study/motion/resampled.h"
#include "tyg/methods.h"

namespace tyg {
namespace {

constexpr double kTolerance = 1e-6;  // of the size: far below any change of the model, and cheap
/// Shares of the whole work: the finer sheet has four times the particles and twice the steps.
constexpr double kStepShare = 0.1, kSheetShare = 0.9;

class NeedFinder {
 public:
  NeedFinder(const Scene& scene, const Reference& reference, double upTo, int threads,
             const std::function<bool(double)>& observer)
      : scene_(scene), reference_(reference), upTo_(upTo), threads_(threads), observer_(observer) {}

  std::vector<Need> find() {
    // The scene's own step is compared with half of it, everything else with the exact motion of the scene.
    const SampledMotion written = run(scene_, findMethod(scene_.integrator), kStepShare / 2);
    compare(Need::Kind::Step, halfStepWords(), halfStep(), findMethod(scene_.integrator), kStepShare / 2, written);
    if (scene_.columns > 1 && scene_.rows > 1) {
      const int columns = 2 * scene_.columns - 1, rows = 2 * scene_.rows - 1;
      if (std::max(columns, rows) <= kLargestCount) {
        compare(Need::Kind::Sheet, fmt::format("sheet {}x{}", columns, rows), exactly(withSheet(scene_, columns, rows)),
                findMethod("dopri54"), kSheetShare, reference_.motion);
      }
    }
    return std::move(needs_);
  }

 private:
  [[nodiscard]] Scene exactly(Scene scene) const {
    scene.precision = Precision::Double;
    scene.tolerance = kTolerance * reference_.size;
    return scene;
  }

  [[nodiscard]] Scene halfStep() const {
    Scene scene = scene_;
    findMethod(scene.integrator).adaptive ? scene.tolerance /= 10 : scene.dt /= 2;
    return scene;
  }

  [[nodiscard]] std::string halfStepWords() const {
    const Scene half = halfStep();
    return findMethod(half.integrator).adaptive ? fmt::format("tolerance {:.3g} m", half.tolerance)
                                                : fmt::format("step {:.3g} ms", 1000 * half.dt);
  }

  SampledMotion run(const Scene& scene, const Method& method, double share) {
    const auto observer = [&](double time) {
      stopped_ = stopped_ || !observer_(done_ + share * time / scene.duration);
      return !stopped_;
    };
    SampledMotion motion =
        sampledRun(scene, method, reference_.motion.times, {.threads = threads_, .observer = observer});
    done_ += share;
    return motion;
  }

  void compare(Need::Kind kind, const std::string& words, const Scene& finer, const Method& method, double share,
               const SampledMotion& with) {
    if (stopped_) return;
    const SampledMotion motion = run(finer, method, share);
    if (stopped_) return;
    Need need{kind, words, {}, with.ledger.maxStretch, motion.ledger.maxStretch};
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    const bool whole = motion.status == Status::Ok && with.status == Status::Ok;
    need.change = whole ? motionError(upTo(upTo_, resampled(motion, finer, scene_)), upTo(upTo_, with))
                        : Distance{kUnknown, kUnknown};
    needs_.push_back(need);
  }

  const Scene& scene_;
  const Reference& reference_;
  double upTo_;
  int threads_;
  const std::function<bool(double)>& observer_;
  std::vector<Need> needs_;
  bool stopped_ = false;
  double done_ = 0;
};

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
  return NeedFinder(scene, reference, upTo, threads, observer).find();
}

}  // namespace tyg
