// A frozen simulation is left as it is: what is chosen then is kept in the scene, for the next run or for a cure.
#include "viewer/scene_control.h"

#include <fmt/core.h>

#include <algorithm>
#include <exception>
#include <utility>

#include "core/simulation/live_parameters.h"
#include "core/simulation/replay.h"
#include "tyg/methods.h"
#include "viewer/opened_file.h"

namespace tyg {
namespace {

/// Steps beyond these shares of its duration are of no use in any scene.
constexpr double kShortestStep = 1e-7, kLongestStep = 1;
/// By which a key changes the step.
constexpr double kStepFactor = 1.05;

/// A graphics card computes in float, whatever a scene says.
Scene fitFor(const Settings& settings, Scene scene) {
  if (settings.device) scene.precision = Precision::Float;
  return scene;
}

}  // namespace

SceneControl::SceneControl(const Scene& scene, Settings settings, RunControl& run, Notes& notes)
    : run_(run), notes_(notes), scene_(scene), settings_(std::move(settings)), method_(&findMethod(scene.integrator)) {}

SceneChange SceneControl::use(const Scene& scene) {
  if (run_.seeking()) return SceneChange::None;
  const Scene wanted = fitFor(settings_, scene);
  const SceneChange change = changeBetween(scene_, wanted);
  try {
    if (change == SceneChange::Live) useLive(wanted), goOnWhereMended();
    if (change > SceneChange::Live) begin(wanted, change == SceneChange::NewSheet);
  } catch (const std::exception& error) {
    notes_.warn(error.what());
    return SceneChange::None;
  }
  return change;
}

void SceneControl::open(const OpenedFile& file, const std::string& path) {
  if (run_.seeking()) return;
  if (file.kind == OpenedFile::Kind::Log) return play(parseEventLog(file.text, path));
  begin(parseScene(file.text, path, methodNames()), true);
}

void SceneControl::play(EventLog log) {
  Scene scene = loggedScene(log, methodNames());
  scene.integrator = findMethod(log.integrator).name;
  scene.dt = log.dt, scene.precision = log.precision;
  if (scene.columns != log.columns || scene.rows != log.rows) {
    throw InputError(fmt::format("found a log of {} x {} particles, allowed: {} x {}, as its scene '{}' has",
                                 log.columns, log.rows, scene.columns, scene.rows, scene.name));
  }
  Simulation fresh(scene, findMethod(scene.integrator), settings_);
  scene_ = scene;
  method_ = &findMethod(scene.integrator);
  ++sheetsSoFar_, ++runsSoFar_;
  run_.startOver(std::move(fresh), std::move(log));
}

/// Another method, step or other live parameters.
void SceneControl::useLive(const Scene& scene) {
  useMethod(findMethod(scene.integrator));
  if (scene.dt != scene_.dt) useStep(scene.dt);
  if (run_.state() != RunState::Frozen && !sameLiveParameters(scene, run_.simulation().scene())) {
    run_.intervene().useLiveParameters(scene);
  }
  scene_ = scene;
  run_.fitCure(scene_);
}

void SceneControl::useMethod(const Method& method) {
  if (run_.seeking()) return;
  if (run_.state() != RunState::Frozen && &method != method_) run_.intervene().useMethod(method);
  method_ = &method;
  scene_.integrator = method.name;
  run_.fitCure(scene_);
}

void SceneControl::chooseMethod(std::size_t slot) {
  if (slot >= methods().size()) return;
  useMethod(methods()[slot]);
  goOnWhereMended();
}

void SceneControl::useStep(double dt) {
  if (run_.seeking()) return;
  const double step = std::clamp(dt, kShortestStep * scene_.duration, kLongestStep * scene_.duration);
  if (run_.state() == RunState::Frozen) {
    scene_.dt = step;
    return run_.fitCure(scene_);
  }
  run_.intervene().useStep(step);
  followSimulation();
}

void SceneControl::changeStep(double factor) {
  useStep(scene_.dt * factor);
  goOnWhereMended();
}

void SceneControl::smallerStep() { changeStep(1 / kStepFactor); }

void SceneControl::largerStep() { changeStep(kStepFactor); }

void SceneControl::followSimulation() {
  const Simulation& simulation = run_.simulation();
  method_ = &simulation.method();
  scene_.integrator = method_->name;
  scene_.dt = simulation.dt();
  copyLiveParameters(simulation.scene(), scene_);
}

void SceneControl::begin(Scene scene, bool newSheet) {
  scene = fitFor(settings_, std::move(scene));
  const Method& method = findMethod(scene.integrator);
  Simulation fresh(scene, method, settings_);  // first: it may refuse the scene
  const bool running = run_.state() == RunState::Running;
  scene_ = std::move(scene);
  method_ = &method;
  if (newSheet) ++sheetsSoFar_;
  ++runsSoFar_;
  run_.startOver(std::move(fresh));
  if (running) run_.startOrPause();
}

void SceneControl::restart() {
  Simulation fresh(scene_, *method_, settings_);
  ++runsSoFar_;
  run_.startOver(std::move(fresh));
}

void SceneControl::followLedger(bool on) {
  settings_.ledger = on;
  run_.followLedger(on);
}

void SceneControl::moveOnCard(bool on) {
  if (run_.seeking() || on == onCard() || !cardOffer_) return;
  try {
    Scene scene = scene_;
    if (on) scene.precision = Precision::Float;
    OfferedCard card;
    if (on) card = cardOffer_(scene);
    Settings settings = settings_;
    settings.device = card.device;
    Simulation fresh(scene, *method_, settings);
    const bool running = run_.state() == RunState::Running;
    scene_ = std::move(scene), settings_ = std::move(settings);
    ++runsSoFar_;
    run_.startOver(std::move(fresh));
    if (running) run_.startOrPause();
    if (!card.sentence.empty()) notes_.say(card.sentence);
  } catch (const std::exception& error) {
    notes_.warn(error.what());
  }
}

/// At once, or, after an alarm, shortly before the failure, and goes on from there. What was set since that time, or
/// while the cloth was frozen, is part of what is wanted: the way back must not lose it.
void SceneControl::cureWith(const Scene& wanted) {
  if (run_.seeking()) return;
  const bool turned = run_.turnBeforeFailure([this, wanted] {
    try {
      run_.intervene();
      useLive(wanted);
      run_.goOn();
    } catch (const std::exception& error) {  // a method that was chosen while it was frozen may refuse the scene
      notes_.warn(error.what());
    }
  });
  if (!turned) useLive(wanted);
}

void SceneControl::takeSafeStep() {
  const std::optional<Cure>& cure = run_.failure().cure();
  if (run_.state() == RunState::Frozen && !cure) return;
  Scene wanted = scene_;
  const double safe = safeStep(run_.measureLimit());
  const double step = cure ? cure->step : run_.margin().adaptive ? 0 : safe;
  if (step > 0) wanted.dt = step, cureWith(wanted);
}

/// Goes on from before a failure where what is chosen by now holds.
void SceneControl::goOnWhereMended() {
  const Simulation& failed = run_.simulation();
  if (run_.state() != RunState::Frozen || !run_.failure().cure()) return;
  const bool same = method_ == &failed.method() && scene_.dt == failed.dt();
  if (same && sameLiveParameters(scene_, failed.scene())) return;
  run_.updateMargin(scene_);
  if (run_.margin().band() == MarginBand::Past) return;
  const Scene wanted = scene_;
  cureWith(wanted);
}

void SceneControl::takeHoldingMethod() {
  const std::optional<Cure>& cure = run_.failure().cure();
  if (!cure || cure->method == nullptr) return;
  Scene wanted = scene_;
  wanted.integrator = cure->method->name;
  cureWith(wanted);
}

void SceneControl::describeStep(StepText& text) const {
  const auto end =
      method_->adaptive
          ? fmt::format_to_n(text.data(), text.size() - 1, "tolerance of {:.4g} mm", 1e3 * scene_.tolerance)
          : fmt::format_to_n(text.data(), text.size() - 1, "step of {:.4g} ms", 1e3 * scene_.dt);
  *end.out = '\0';
}

}  // namespace tyg
