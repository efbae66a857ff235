// The viewer's inputs, camera and frames. Its way through time is in viewer_time.cpp.
#include "viewer/viewer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "tyg/methods.h"
#include "view/picking.h"
#include "viewer/room.h"

namespace tyg {
namespace {

using enum InputAction;

/// Simulated seconds that a click pushes, and by which holding the button goes on.
constexpr double kClickSeconds = 0.1, kHoldSeconds = 0.02;
/// A push as a share of the cloth's weight: a poke that is seen everywhere and tears nothing.
constexpr double kPushShare = 0.15;
/// But at least this many times the weight of the particle, for scenes of a few particles.
constexpr double kLeastPush = 3;
constexpr double kEarthGravity = 9.81;    // m/s2: what a push is measured by even where a scene has no gravity
constexpr double kPushSeenSeconds = 0.3;  // wall time that a push stays on screen

constexpr double kSmoothingSeconds = 0.5;
/// A longer frame says that nothing moved before it, not how fast frames come.
constexpr double kLongestMeasuredFrame = 0.5;

int wholeTicks(double seconds, double dt) {
  constexpr double kMost = 1e9;  // of ticks too short to simulate, a push lasts as many as can be counted
  return static_cast<int>(std::clamp(std::ceil(seconds / dt - 1e-9), 1.0, kMost));
}

/// A held key acts again after this long, and then this often, s.
constexpr double kRepeatAfter = 0.35, kRepeatEvery = 0.05;
/// By which a key changes the step.
constexpr double kStepFactor = 1.05;

bool isRepeated(InputAction action) {
  return action == StepBack || action == Step || action == SmallerStep || action == LargerStep;
}

bool isHeldAction(InputAction action) {
  return action == Poke || action == Look || (action >= MoveForward && action <= MoveUp);
}

}  // namespace

std::string_view nameOf(RunState state) {
  constexpr std::array<std::string_view, 4> kNames{"waiting", "running", "paused", "frozen"};
  return kNames.at(static_cast<std::size_t>(state));
}

Viewer::Viewer(const Scene& scene, const Settings& settings, Clock clock)
    : scene_(scene),
      settings_(settings),
      clock_(std::move(clock)),
      method_(&findMethod(scene.integrator)),
      simulation_(scene, *method_, settings),
      frameClock_(scene.dt),
      lastFrame_(clock_()),
      positions_(static_cast<std::size_t>(3 * simulation_.sheet().count())) {
  limitTicks();
  history_.begin(simulation_);
  showState();
  room_ = roomOf(simulation_, box_, settings_, clock_);
}

void Viewer::handle(const WindowEvent& event) {
  if (event.kind == WindowEvent::Kind::Press && idle()) {  // the idle time is neither made up nor measured
    lastFrame_ = clock_();
    woken_ = true;
  }
  try {
    switch (event.kind) {
      case WindowEvent::Kind::Press:
        if (const Input* input = findInput(event.key)) press(*input, event);
        break;
      case WindowEvent::Kind::Release:
        release(event.key);
        break;
      case WindowEvent::Kind::Move:
        moveCursor({event.x, event.y});
        break;
      case WindowEvent::Kind::Scroll:
        camera_.approach(static_cast<float>(event.notches));
        cameraMoved_ = true;
        break;
      case WindowEvent::Kind::FocusLost:
        held_.fill(false);
        repeated_.reset();
        break;
      case WindowEvent::Kind::Exposed:
        break;
    }
  } catch (const std::exception& error) {
    warn(error.what());
  }
}

void Viewer::press(const Input& input, const WindowEvent& event) {
  note_.clear();
  if (isHeldAction(input.action)) held_.at(static_cast<std::size_t>(input.action)) = true;
  if (isMouse(input.key)) cursor_ = {event.x, event.y};
  if (isRepeated(input.action)) {
    repeated_ = input;
    repeatAt_ = clock_() + kRepeatAfter;
  }
  if (input.action == Poke) return beginPush(cursor_);
  if (input.action == ChooseMethod) return choose(methodPlace(input.key));
  perform(input.action);
}

void Viewer::release(KeyCode key) {
  const Input* input = findInput(key);
  if (input == nullptr) return repeated_.reset();  // one library tells of `{` where `[` is let go of under Shift
  held_.at(static_cast<std::size_t>(input->action)) = false;
  if (repeated_ && repeated_->key == key) repeated_.reset();
}

void Viewer::repeatHeldKey() {
  if (!repeated_ || seeking_ || clock_() < repeatAt_) return;
  repeatAt_ = clock_() + kRepeatEvery;
  perform(repeated_->action);
}

void Viewer::perform(InputAction action) {
  try {
    act(action);
  } catch (const std::exception& error) {
    warn(error.what());
  }
}

void Viewer::act(InputAction action) {
  switch (action) {
    case StartOrPause:
      return startOrPause();
    case Step:
      return step();
    case StepBack:
      return turnTo(shownTick_ - 1);
    case Slower:
      return changeSpeed(0.5);
    case Faster:
      return changeSpeed(2);
    case Again:
      return again();
    case Restart:
      return restart();
    case SmallerStep:
      return useStep(simulation_.dt() / kStepFactor);
    case LargerStep:
      return useStep(simulation_.dt() * kStepFactor);
    case SafeStep:
      return takeSafeStep();
    case HoldingMethod:
      return takeHoldingMethod();
    case RunOn:
      return runOn();
    case FrameCloth:
      return frameCloth();
    case Leave:
      leaving_ = true;
      return;
    default:
      return toggle(action);
  }
}

void Viewer::toggle(InputAction action) {
  const auto flip = [](bool& value) { value = !value; };
  switch (action) {
    case ShowStructural:
      return flip(draw_.structural);
    case ShowShear:
      return flip(draw_.shear);
    case ShowBend:
      return flip(draw_.bend);
    case ShowParticles:
      return flip(draw_.particles);
    case ShowPins:
      return flip(draw_.pins);
    case ShowGround:
      return flip(draw_.ground);
    case ShowHelp:
      return flip(help_);
    case ChangeBackground:
      draw_.background = draw_.background == Background::Dark ? Background::Light : Background::Dark;
      return;
    default:
      return;
  }
}

void Viewer::describeStep(StepText& text) const {
  if (method_->adaptive) {
    std::snprintf(text.data(), text.size(), "tolerance of %.4g mm", 1e3 * scene_.tolerance);
  } else {
    std::snprintf(text.data(), text.size(), "step of %.4g ms", 1e3 * scene_.dt);
  }
}

void Viewer::choose(std::size_t place) {
  if (place < methods().size()) useMethod(methods()[place]);
}

double Viewer::pushNewtons() const {
  const Sheet& sheet = simulation_.sheet();
  const double weight = sheet.particleMass * kEarthGravity;
  return pushFactor_ * weight * std::max(kLeastPush, kPushShare * sheet.count());
}

void Viewer::setPushFactor(double factor) {
  constexpr double kMost = 100;
  pushFactor_ = std::clamp(factor, 1 / kMost, kMost);
}

void Viewer::beginPush(glm::vec2 cursor) {
  if (state_ == RunState::Frozen || seeking_ || pixels_.width <= 0 || pixels_.height <= 0) return;
  const glm::vec2 window(pixels_.width, pixels_.height);
  const Sheet& sheet = simulation_.sheet();
  const std::optional<int> hit = pickParticle(camera_, cursor, window, sheet, positions_);
  const glm::dvec3 away = hit ? glm::dvec3(sightLine(camera_, cursor, window).direction) : glm::dvec3(0, 0, 1);
  const glm::dvec3 force = pushNewtons() * away;
  beforeDeed();
  picked_ = hit ? *hit : particleAt(sheet, Place{.name = "middle"});
  force_ = {force.x, force.y, force.z};
  const int ticks = wholeTicks(kClickSeconds, simulation_.dt());
  simulation_.push(picked_, force_, ticks);
  pushEnd_ = simulation_.ticks() + ticks;
  pushedAt_ = clock_();
  ++pushes_;
  if (std::ranges::binary_search(sheet.pins, picked_)) note("That particle is pinned: no push moves it.");
}

void Viewer::keepPushing() {
  if (!held(Poke) || picked_ < 0 || simulation_.ticks() < pushEnd_) return;
  const int ticks = wholeTicks(kHoldSeconds, simulation_.dt());
  simulation_.push(picked_, force_, ticks);
  pushEnd_ = simulation_.ticks() + ticks;
}

void Viewer::moveCursor(glm::vec2 cursor) {
  const glm::vec2 moved = cursor - cursor_;
  cursor_ = cursor;
  if (!held(Look)) return;
  camera_.turn(moved.x, moved.y);
  cameraMoved_ = true;
}

Motion Viewer::motion() const {
  const auto along = [this](InputAction plus, InputAction minus) { return float(held(plus)) - float(held(minus)); };
  return {.right = along(MoveRight, MoveLeft), .up = along(MoveUp, MoveDown), .forward = along(MoveForward, MoveBack)};
}

void Viewer::resize(Extent pixels, Margins margins) {
  if (pixels == pixels_ && margins == margins_) return;
  pixels_ = pixels;
  margins_ = margins;
  if (pixels.width <= 0 || pixels.height <= 0) return;
  if (!framed_) return frameCloth();
  if (!cameraMoved_) return fitView();
  const float before = std::exchange(aside_, aside());
  camera_.slide(aside_ - before);
}

void Viewer::frameCloth() {
  camera_.watch(box_);
  const auto corners = box_.corners();
  inView_ = simulation_.ticks() > 0 ? std::vector(corners.begin(), corners.end()) : room_;
  fitView();
}

/// Of the window's free part.
void Viewer::fitView() {
  if (pixels_.width <= 0 || pixels_.height <= 0) return;
  const int free = std::max(pixels_.width / 3, pixels_.width - margins_.left - margins_.right);
  aside_ = aside();
  std::vector<glm::vec3> points = inView_;
  if (margins_.beside > 0) {
    for (const glm::vec3& point : inView_) points.push_back(point - margins_.beside * camera_.right());
  }
  camera_.frame(points, float(free) / float(pixels_.height), aside_);
  framed_ = true;
  cameraMoved_ = false;
}

float Viewer::aside() const { return 0.5F * float(margins_.left - margins_.right) / float(pixels_.height); }

bool Viewer::idle() const {
  const Motion keys = motion();
  return (state_ != RunState::Running || asleep()) && !seeking_ && !repeated_ && !held(Look) && keys.right == 0 &&
         keys.up == 0 && keys.forward == 0;
}

void Viewer::frame() {
  const double now = clock_();
  const double seconds = now - lastFrame_;
  lastFrame_ = now;
  camera_.watch(box_);
  const Motion keys = motion();
  camera_.move(keys, static_cast<float>(seconds));
  cameraMoved_ = cameraMoved_ || keys.right != 0 || keys.up != 0 || keys.forward != 0;
  repeatHeldKey();
  moveCloth(seconds);
  if (state_ == RunState::Frozen) {
    stepMargin_.lookAhead(scene_);
  } else {
    stepMargin_.look(simulation_, clock_);
  }
  if (!woken_) measure(seconds, clock_() - now);
  woken_ = false;
}

void Viewer::measure(double frameSeconds, double simulatingSeconds) {
  if (frameSeconds <= 0 || frameSeconds > kLongestMeasuredFrame || idle()) return;
  const double share = frameSeconds_ > 0 ? std::min(1.0, frameSeconds / kSmoothingSeconds) : 1;
  frameSeconds_ += share * (frameSeconds - frameSeconds_);
  simulatingSeconds_ += share * (std::min(simulatingSeconds, frameSeconds) - simulatingSeconds_);
  pace_ = {.framesPerSecond = 1 / frameSeconds_,
           .simulating = simulatingSeconds_ / frameSeconds_,
           .realTime = frameClock_.realTimeFactor(),
           .behind = frameClock_.behind()};
}

std::optional<ShownPush> Viewer::shownPush() const {
  const bool acts = simulation_.ticks() < pushEnd_ || clock_() - pushedAt_ < kPushSeenSeconds;
  if (pushes_ == 0 || state_ == RunState::Frozen || !acts) return std::nullopt;
  return ShownPush{.particle = picked_, .force = force_};
}

ViewLogLine Viewer::logLine() {
  const glm::vec3 eye = camera_.eye();
  return {.time = time_,
          .state = nameOf(state_),
          .integrator = method_->name,
          .dt = simulation_.dt(),
          .eye = {eye.x, eye.y, eye.z},
          .picked = picked_,
          .pushes = pushes_,
          .kinetic = kinetic_,
          .alarm = nameOf(simulation_.status())};
}

EventLog Viewer::record() const { return history_.record(simulation_); }

EventLog Viewer::recordShown() const { return History::recordTo(simulation_); }

}  // namespace tyg
