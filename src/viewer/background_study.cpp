// The thread and what it hands over.
#include "viewer/background_study.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "study/motion/tearing.h"
#include "study/work/work_precision.h"

namespace tyg {
namespace {

using Stage = StudyProgress::Stage;

/// As `tyg chart --quick` does it.
constexpr double kRunBudget = 0.1, kRepeatSeconds = 0.03, kRoundsBudget = 5;  // s
constexpr int kFewestRepeats = 2;
/// So many rows of each method come first: down to half the stable limit, where most hold.
constexpr std::size_t kFirstRungs = 5;
constexpr double kReferenceShare = 0.1;  // of the whole, about as measured

StudyPlan planOf(const Scene& scene, const std::vector<const Method*>& methods, const BackgroundStudy::Clock& clock) {
  StudyPlan plan;
  plan.methods = methods;
  plan.precisions = {scene.precision};
  plan.runBudget = kRunBudget;
  plan.fewestRepeats = kFewestRepeats;
  plan.repeatSeconds = kRepeatSeconds;
  plan.roundsBudget = kRoundsBudget;
  plan.firstRungs = kFirstRungs;
  plan.threads = 1;
  plan.clock = clock;
  return plan;
}

/// Behind the others of its method.
void addRow(StudyProgress& told, const WorkRow& row) {
  const auto ofMethod = [&row](const WorkRow& other) { return other.integrator == row.integrator; };
  // A method gets more than the first rows only when all have had theirs.
  told.allMethods = told.allMethods || std::ranges::count_if(told.rows, ofMethod) >= std::ptrdiff_t{kFirstRungs};
  const auto last = std::ranges::find_if(told.rows.rbegin(), told.rows.rend(), ofMethod);
  told.rows.insert(last == told.rows.rend() ? told.rows.end() : last.base(), row);
}

std::string whyNoReference(const Reference& reference) {
  return "There is no reference to measure errors against: " + reference.whyUnusable() + ".";
}

}  // namespace

void BackgroundStudy::start(const Scene& scene, std::vector<const Method*> methods) {
  thread_.stop();
  forget(Stage::Reference);
  thread_.start([this, scene, methods = std::move(methods)](const BackgroundThread::GoesOn& goesOn) {
    const Job job{.scene = scene, .methods = methods, .goesOn = goesOn};
    try {
      study(job);
    } catch (const std::exception& error) {
      tell(job, [&](StudyProgress& told) { told.stage = Stage::Failed, told.problem = error.what(); });
    }
  });
}

void BackgroundStudy::stop() {
  thread_.stop();
  forget(Stage::Idle);
}

/// What is told from now on by a job that was stopped before is not taken.
void BackgroundStudy::forget(Stage stage) {
  const std::scoped_lock lock(mutex_);
  told_ = {};
  told_.stage = stage;
  fraction_ = 0;
  seen_ = told_;
  seenChanges_ = ++changes_;
}

const StudyProgress& BackgroundStudy::progress() {
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (lock.owns_lock() && seenChanges_ != changes_) {
    seen_ = told_;
    seenChanges_ = changes_;
  }
  if (running()) seen_.fraction = fraction_;
  return seen_;
}

bool BackgroundStudy::running() const { return seen_.stage == Stage::Reference || seen_.stage == Stage::Rows; }

/// Changes what is told, unless another job is wanted by now.
template <class Change>
void BackgroundStudy::tell(const Job& job, const Change& change) {
  const std::scoped_lock lock(mutex_);
  if (!job.goesOn()) return;
  change(told_);
  ++changes_;
}

/// True while the job is wanted.
bool BackgroundStudy::report(const Job& job, double fraction) {
  if (!job.goesOn()) return false;
  fraction_ = fraction;
  return true;
}

void BackgroundStudy::study(const Job& job) {
  const int particles = job.scene.columns * job.scene.rows;
  if (particles > kMostParticles) {
    throw std::runtime_error("A sheet of " + std::to_string(particles) +
                             " particles is too large to be studied beside the window (at most " +
                             std::to_string(kMostParticles) + "): tyg chart does it without one.");
  }
  const auto observer = [&](double fraction) { return report(job, kReferenceShare * fraction); };
  const Tearing tearing = untilTearsDiffer(job.scene, 1, [&](double) { return job.goesOn(); });
  Job certain = job;
  certain.scene = tearing.scene;
  const auto reference = std::make_shared<const Reference>(makeReference(certain.scene, 1, observer));
  if (!job.goesOn()) return;
  if (!reference->usable()) throw std::runtime_error(whyNoReference(*reference));
  tell(job, [&](StudyProgress& told) { told.stage = Stage::Rows, told.reference = reference; });
  rowsOf(certain, reference);
  if (tearing.differs) tell(job, [&](StudyProgress& told) { told.refusals.push_back(tearing.words()); });
}

void BackgroundStudy::rowsOf(const Job& job, const std::shared_ptr<const Reference>& reference) {
  StudyPlan plan = planOf(job.scene, job.methods, clock_);
  plan.observer = [&](double fraction) { return report(job, kReferenceShare + (1 - kReferenceShare) * fraction); };
  plan.rowObserver = [&](const WorkRow& row) { tell(job, [&](StudyProgress& told) { addRow(told, row); }); };
  Study study = workPrecision(job.scene, *reference, plan);
  tell(job, [&](StudyProgress& told) {
    told.rows = std::move(study.rows);
    told.refusals = std::move(study.refusals);
    told.allMethods = true;
    told.fraction = 1;
    told.stage = Stage::Done;
  });
}

}  // namespace tyg
