// SUNDIALS' CVODE with the list of springs: Adams methods with fixed-point iteration, and BDF with Newton and GMRES,
// each at the loosest tolerance (of halvings) that comes within the wanted error of the reference.
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_spgmr.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <stdexcept>

#include "peers.h"

namespace tyg::peers {
namespace {

enum class Family { Adams, Bdf };

void must(int result, const char* what) {
  if (result < 0) throw std::runtime_error(std::string("CVODE: ") + what);
}

int derivative(realtype /*t*/, N_Vector y, N_Vector dy, void* springs) {
  (*static_cast<const SpringList*>(springs))(N_VGetArrayPointer(y), N_VGetArrayPointer(dy));
  return 0;
}

/// A scene with at most one push, stepped by CVODE.
class Cvode {
 public:
  Cvode(const Scene& scene, Family family, double tolerance)
      : scene_(scene), springs_(scene), start_(springs_.start()) {
    must(SUNContext_Create(nullptr, &context_), "context");
    y_ = N_VMake_Serial(sunindextype(start_.size()), start_.data(), context_);
    memory_ = CVodeCreate(family == Family::Adams ? CV_ADAMS : CV_BDF, context_);
    must(CVodeInit(memory_, derivative, 0, y_), "start");
    must(CVodeSStolerances(memory_, tolerance, tolerance), "tolerances");
    must(CVodeSetUserData(memory_, &springs_), "springs");
    must(CVodeSetMaxNumSteps(memory_, 10000000), "steps");
    if (family == Family::Adams) {
      fixedPoint_ = SUNNonlinSol_FixedPoint(y_, 0, context_);
      must(CVodeSetNonlinearSolver(memory_, fixedPoint_), "fixed point");
    } else {
      gmres_ = SUNLinSol_SPGMR(y_, SUN_PREC_NONE, 0, context_);
      must(CVodeSetLinearSolver(memory_, gmres_, nullptr), "GMRES");
    }
  }
  ~Cvode() {
    CVodeFree(&memory_);
    if (fixedPoint_ != nullptr) SUNNonlinSolFree(fixedPoint_);
    if (gmres_ != nullptr) SUNLinSolFree(gmres_);
    N_VDestroy(y_);
    SUNContext_Free(&context_);
  }
  Cvode(const Cvode&) = delete;
  Cvode& operator=(const Cvode&) = delete;

  /// Goes to `time` (s), starting anew wherever the push begins or ends before it. Steps do not depend on how often
  /// this is called.
  void advanceTo(double time) {
    for (const Push& push : scene_.pushes) {
      for (const double edge : {push.at, push.at + push.duration}) {
        if (edge <= time_ || edge > time) continue;
        stepTo(edge);
        if (edge == push.at) springs_.push(particleAt(makeSheet(scene_), push.particle), push.force);
        if (edge != push.at) springs_.clearPush();
        must(CVodeReInit(memory_, time_, y_), "restart");
      }
    }
    if (time_ < time) stepTo(time);
  }
  [[nodiscard]] std::vector<Vec3> positions() const { return SpringList::positionsOf(start_); }
  [[nodiscard]] double evaluations() const {
    long own = 0, ofGmres = 0;
    CVodeGetNumRhsEvals(memory_, &own);
    if (gmres_ != nullptr) CVodeGetNumLinRhsEvals(memory_, &ofGmres);
    return double(own + ofGmres);
  }

 private:
  [[nodiscard]] double nextEdgeAfter(double time) const {
    for (const Push& push : scene_.pushes) {
      for (const double edge : {push.at, push.at + push.duration}) {
        if (edge >= time) return edge;
      }
    }
    return scene_.duration;
  }
  void stepTo(double time) {
    must(CVodeSetStopTime(memory_, nextEdgeAfter(time)), "stop time");
    must(CVode(memory_, time, y_, &time_, CV_NORMAL), "a step failed");
  }

  const Scene& scene_;
  SpringList springs_;
  std::vector<double> start_;  // the storage of y_
  SUNContext context_ = nullptr;
  N_Vector y_ = nullptr;
  void* memory_ = nullptr;
  SUNNonlinearSolver fixedPoint_ = nullptr;
  SUNLinearSolver gmres_ = nullptr;
  double time_ = 0;
};

struct Found {
  double tolerance = 0, error = 0, evaluations = 0;
};

Found loosestTolerance(Family family) {
  const TwoSeconds& wanted = twoSeconds();
  Found found{.tolerance = 1e-4, .error = 1};
  while (!(found.error <= TwoSeconds::kWanted) && found.tolerance > 1e-12) {
    found.tolerance /= 2;
    Cvode cvode(wanted.scene, family, found.tolerance);
    SampledMotion motion;
    for (const double time : wanted.times) {
      cvode.advanceTo(time);
      motion.positions.push_back(cvode.positions());
    }
    found.error = wanted.errorOf(motion);
    found.evaluations = cvode.evaluations();
  }
  return found;
}

template <Family family>
void twoSecondRun(benchmark::State& state) {
  static const Found kFound = loosestTolerance(family);
  const Scene& scene = twoSeconds().scene;
  for (auto _ : state) {
    state.PauseTiming();
    Cvode cvode(scene, family, kFound.tolerance);
    state.ResumeTiming();
    cvode.advanceTo(scene.duration);
  }
  state.counters["error"] = kFound.error;
  state.counters["tolerance"] = kFound.tolerance;
  state.counters["evaluations"] = kFound.evaluations;
}

}  // namespace

void addCvode() {
  const auto add = [](const char* name, void (*run)(benchmark::State&)) {
    benchmark::RegisterBenchmark(name, run)->Unit(benchmark::kMillisecond);
    comparisons().push_back({name, "tyg/leapfrog/two_seconds", 50});
  };
  add("cvode/adams/two_seconds", twoSecondRun<Family::Adams>);
  add("cvode/bdf_gmres/two_seconds", twoSecondRun<Family::Bdf>);
}

}  // namespace tyg::peers
