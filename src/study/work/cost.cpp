// The same scene and the yardstick are stepped in short bursts that take turns; the ratio of their fastest bursts is
// the price.
#include "study/work/cost.h"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "core/forces/term.h"
#include "core/forces/terms/contact.h"
#include "core/forces/terms/springs.h"
#include "tyg/methods.h"

namespace tyg {
namespace {

std::int64_t units(const Method& method, std::int64_t evaluations, std::int64_t steps) {
  return method.evaluationsPerStep == 0 ? steps : evaluations;
}

/// Does a step's work depend on its length and on the state?
bool workVaries(const Method& method) {
  return method.stableStep == nullptr && method.stableStepOfScene == nullptr && method.evaluationsPerStep != 0;
}

/// A run that goes on burst by burst. Past a scene's end it goes on too, and past its alarm.
class Bursts {
 public:
  Bursts(const Scene& scene, int threads, const CostMeter::Clock& clock,
         const std::shared_ptr<Device>& device = nullptr)
      : simulation_(scene, findMethod(scene.integrator), {.threads = threads, .keepGoing = true, .device = device}),
        clock_(clock),
        threads_(threads) {
    shortenTicks();
    // As many ticks at once as make reading the clock cheap, but a single one where a tick takes long: on a large sheet
    // some methods solve equations for a tenth of a second. On a device each burst has an energy check, for which the
    // state comes back.
    constexpr std::int64_t kMostTicks = 64;
    if (device) ticks_ = kMostTicks;
    while (ticks_ < kMostTicks && secondsOf(ticks_) < kLongEnough) ticks_ *= 2;
  }

  /// Steps for kLongEnough, timed.
  void again() {
    const std::int64_t before = done();
    double seconds = 0;
    while (seconds < kLongEnough) seconds += secondsOf(ticks_);
    perUnit_.push_back(seconds / static_cast<double>(std::max<std::int64_t>(done() - before, 1)));
  }

  /// Have the two fastest bursts taken the same time? Then a third one will hardly be faster.
  [[nodiscard]] bool confirmed() const {
    constexpr double kSame = 1.02;
    std::vector<double> sorted = perUnit_;
    std::ranges::sort(sorted);
    return sorted.size() > 1 && sorted[1] <= kSame * sorted[0];
  }

  /// The least of all bursts: the same work can only be disturbed to take longer. Solves are not the same work again
  /// and again; of them it is the middle one.
  [[nodiscard]] double secondsPerUnit() const {
    std::vector<double> sorted = perUnit_;
    std::ranges::sort(sorted);
    return workVaries(simulation_.method()) ? sorted[sorted.size() / 2] : sorted.front();
  }

 private:
  [[nodiscard]] std::int64_t done() const {
    return units(simulation_.method(), simulation_.forceEvaluations(), simulation_.steps());
  }

  /// An adaptive method may need millions of steps for a tick of the scene's. It does not use the tick's length
  /// otherwise: shorter ones, each ended by the observer where it takes too long, tell the same cost.
  void shortenTicks() {
    if (!simulation_.method().adaptive) return;
    constexpr double kLongestTick = 0.05, kShorter = 1.0 / 16;  // s; of the tick before
    constexpr int kMostTries = 20;
    double began = 0;
    simulation_.observe([&] { return clock_(threads_) - began < kLongestTick; });
    for (int k = 0; k < kMostTries && simulation_.ticks() == 0; ++k) {
      if (k > 0) simulation_.useStep(kShorter * simulation_.dt());
      began = clock_(threads_);
      simulation_.tick();
    }
    simulation_.observe({});
  }

  double secondsOf(std::int64_t ticks) {
    const double start = clock_(threads_);
    simulation_.tick(ticks);
    return clock_(threads_) - start;
  }

  static constexpr double kLongEnough = 3e-4;  // s: hundreds of times what reading a clock takes
  Simulation simulation_;
  const CostMeter::Clock& clock_;
  int threads_;
  std::int64_t ticks_ = 1;
  std::vector<double> perUnit_;
};

/// Everything that a unit's cost depends on. The step counts only for methods whose solve depends on it.
std::string keyOf(const Scene& scene, int threads) {
  const Method& method = findMethod(scene.integrator);
  std::string key = fmt::format("{} {} {}x{} {}{}", scene.integrator, nameOf(scene.precision), scene.columns,
                                scene.rows, threads, scene.damping == Damping::Axial ? " axial" : "");
  for (const ForceTerm* term : forceTerms()) {
    for (const Parameter& parameter : term->parameters) {
      if (parameter.get(scene) != Vec3{}) key += fmt::format(" {}", parameter.key);
    }
  }
  // A Chebyshev method's stages follow its step too: long chains of them share what a step costs besides.
  if (workVaries(method) || method.stableStepOfScene != nullptr) key += fmt::format(" {:g}", scene.dt);
  return key;
}

/// Of a particle, in springs, where half of the cloth touches each body: finding who is near costs once.
double contactCost(const Scene& scene) {
  if (!hasTerm(scene, ContactTerm::kTerm) || scene.bodies.empty()) return 0;
  constexpr double kNear = 1.5, kPlane = 1, kBall = 1.5, kOther = 3, kFriction = 0.75;
  double springs = kNear;
  for (const Body& body : scene.bodies) {
    springs += body.shape == Shape::Plane ? kPlane : body.shape == Shape::Ball ? kBall : kOther;
    if (scene.contact.friction > 0) springs += kFriction;
  }
  return springs;
}

}  // namespace

std::int64_t workOf(const Method& method, const SampledMotion& run) {
  return units(method, run.forceEvaluations, run.steps);
}

double countedCost(const Scene& scene) {
  constexpr double kParticle = 2, kDamper = 0.5, kCell = 1.5, kWind = 0.5, kFloat = 0.6;
  const Sheet sheet = makeSheet(scene);
  double springs = (kParticle + (particleDamping(scene) > 0 ? kDamper : 0)) * sheet.count();
  springs += contactCost(scene) * sheet.count();
  for (const Family family : kFamilies) {
    const SpringFamily& law = familyOf(scene, family);
    const double each = law.present() ? 1 + (law.kd > 0 ? kDamper : 0) : 0;
    springs += each * static_cast<double>(springCount(sheet, family));
  }
  if (scene.air.density > 0) {
    springs += (kCell + kWind * double(scene.winds.size())) * (scene.columns - 1) * (scene.rows - 1);
  }
  return springs * (scene.precision == Precision::Float ? kFloat : 1);
}

CostMeter::CostMeter(Scene yardstick, int threads, Clock clock)
    : yardstick_(std::move(yardstick)), threads_(threads), clock_(std::move(clock)) {}

Price cheapestPrice(const UnitCost& processor, const DeviceOffer& offer, const Scene& scene, int threads) {
  const double here = processor(scene, threads);
  const double there = offer.device ? offer.cost(scene, threads) : std::numeric_limits<double>::infinity();
  if (there < here) return {there, offer.device, here};
  return {here, nullptr, there};
}

double CostMeter::secondsPerUnit(const Scene& scene, int threads, const std::shared_ptr<Device>& device) {
  if (known_.empty()) {
    constexpr int kFirstRounds = 40;
    Bursts yardstick(yardstick_, threads_, clock_);
    for (int round = 0; round < kFirstRounds; ++round) yardstick.again();
    yardstickSeconds_ = known_[keyOf(yardstick_, threads_)] = yardstick.secondsPerUnit();
  }
  const std::string key = keyOf(scene, threads) + (device ? " device" : "");
  const auto found = known_.find(key);
  if (found != known_.end()) return found->second;
  return known_[key] = measured(scene, device ? std::max(2, threads) : threads, device);
}

double CostMeter::measured(const Scene& scene, int threads, const std::shared_ptr<Device>& device) {
  constexpr int kRounds = 20, kFewestRounds = 3, kMostRounds = 100;
  constexpr double kLongEnough = 0.2;  // s: slow bursts need fewer repeats
  Bursts yardstick(yardstick_, threads_, clock_), other(scene, threads, clock_, device);
  const double start = clock_(threads);
  // On a busy machine the fastest bursts of the first rounds may have been disturbed too.
  const auto wanted = [&](int round) {
    if (round < kFewestRounds) return true;
    const bool enough = round >= kRounds && yardstick.confirmed() && other.confirmed();
    return !enough && round < kMostRounds && clock_(threads) - start < kLongEnough;
  };
  for (int round = 0; wanted(round); ++round) {
    yardstick.again();
    other.again();
  }
  return yardstickSeconds_ * other.secondsPerUnit() / yardstick.secondsPerUnit();
}

}  // namespace tyg
