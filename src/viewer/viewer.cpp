// Looks each key up in the table of inputs, and does in each frame first what moves the camera, then the cloth.
#include "viewer/viewer.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "tyg/methods.h"
#include "view/body_shapes.h"
#include "view/picking.h"
#include "viewer/motion_bounds.h"
#include "viewer/opened_file.h"

namespace tyg {
namespace {

using enum InputAction;

constexpr float kNotchesPerPixel = 0.05F;  // of a drag upwards, which comes nearer as the wheel does
constexpr float kClickPixels = 4;          // a click beside the cloth moves no farther
constexpr double kClickSeconds = 0.5;      // nor does it last longer

}  // namespace

Viewer::Viewer(const Scene& scene, const Settings& settings, Clock clock)
    : clock_(std::move(clock)),
      run_(Simulation(scene, findMethod(scene.integrator), settings), clock_, notes_, *this),
      scenes_(scene, settings, run_, notes_),
      tools_(run_, view_, notes_),
      lastFrame_(clock_()) {
  view_.followScene(scene.look.show);
  run_.showStart();
}

std::int64_t Viewer::beforeTicks(Simulation& simulation, std::int64_t due) {
  const std::int64_t most = tools_.follow(simulation, due);
  return review_.isOpen() ? std::min(most, review_.ghost().meet(simulation)) : most;
}

void Viewer::runBegan() {
  tools_.restart();
  if (const std::string closed = review_.beginRun(scenes_.scene()); !closed.empty()) notes_.warn(closed);
  view_.followScene(scenes_.scene().look.show);
  if (std::exchange(sheet_, scenes_.sheetsSoFar()) == scenes_.sheetsSoFar()) return;
  tools_.forgetParticles();
  followCloth();
  view_.begin(motionBounds(run_.simulation(), run_.shown().box(), scenes_.settings(), clock_));
  view_.frameCloth();
}

void Viewer::followCloth() {
  placeBodies(run_.simulation().scene(), run_.shown().time(), bodies_);
  const Simulation& simulation = run_.simulation();
  view_.follow(run_.shown().box(), bodies_, simulation.ticks() > 0, simulation.sheet().missing.none());
}

void Viewer::handle(const WindowEvent& event) {
  if (event.kind == WindowEvent::Kind::Press && idle()) {  // the idle time is neither made up nor measured
    lastFrame_ = clock_();
    woken_ = true;
  }
  try {
    dispatch(event);
  } catch (const std::exception& error) {
    notes_.warn(error.what());
  }
}

void Viewer::dispatch(const WindowEvent& event) {
  switch (event.kind) {
    case WindowEvent::Kind::Press:
      if (const Input* input = findInput(event.key)) press(*input, event);
      return;
    case WindowEvent::Kind::Release:
      return release(event.key);
    case WindowEvent::Kind::Move:
      return moveCursor({event.x, event.y});
    case WindowEvent::Kind::Scroll:
      if (!tools_.scroll(static_cast<float>(event.notches))) view_.approach(static_cast<float>(event.notches));
      return;
    case WindowEvent::Kind::FocusLost:
      leftDrag_ = LeftDrag::Tool;
      tools_.letGo();
      return keys_.releaseAll();
    case WindowEvent::Kind::Drop:
      notes_.clear();
      return openFile(event.path);
    case WindowEvent::Kind::Exposed:
      return;
  }
}

void Viewer::press(const Input& input, const WindowEvent& event) {
  notes_.clear(clock_());
  if (isMouse(input.key)) cursor_ = {event.x, event.y};
  keys_.press(input, clock_());
  if (input.action == UseTool) return pressLeft(event);
  if (input.action == ChooseTool) return tools_.choose(toolSlot(input.key));
  if (input.action == ChooseMethod) return scenes_.chooseMethod(methodSlot(input.key));
  perform(input.action);
}

void Viewer::pressLeft(const WindowEvent& event) {
  pressedAt_ = cursor_;
  pressedTime_ = clock_();
  leftDrag_ = event.control ? LeftDrag::Look : event.shift ? LeftDrag::Approach : LeftDrag::Tool;
  if (leftDrag_ == LeftDrag::Tool && !tools_.press(cursor_)) leftDrag_ = LeftDrag::Beside;
}

void Viewer::releaseLeft() {
  const LeftDrag drag = std::exchange(leftDrag_, LeftDrag::Tool);
  if (drag == LeftDrag::Tool) tools_.release();
  if (drag == LeftDrag::Beside && clock_() - pressedTime_ <= kClickSeconds) tools_.clickBeside(cursor_);
}

void Viewer::release(KeyCode key) {
  keys_.release(key);
  const Input* input = findInput(key);
  if (input != nullptr && input->action == UseTool) releaseLeft();
}

void Viewer::moveCursor(glm::vec2 cursor) {
  const glm::vec2 moved = cursor - std::exchange(cursor_, cursor);
  if (leftDrag_ == LeftDrag::Tool) tools_.move(cursor);
  if (leftDrag_ == LeftDrag::Beside && glm::distance(cursor, pressedAt_) > kClickPixels) {
    leftDrag_ = LeftDrag::Orbit;
    const Extent window = view_.pixels();
    orbitsAbout_ = middleInView(view_.camera(), {window.width, window.height}, run_.shown().positions());
  }
  if (leftDrag_ == LeftDrag::Orbit) view_.orbit(moved, orbitsAbout_);
  if (keys_.held(LookAround) || leftDrag_ == LeftDrag::Look) view_.turn(moved);
  if (leftDrag_ == LeftDrag::Approach) view_.approach(-kNotchesPerPixel * moved.y);
}

void Viewer::perform(InputAction action) {
  try {
    act(action);
  } catch (const std::exception& error) {
    notes_.warn(error.what());
  }
}

bool Viewer::open(const std::string& path) {
  try {
    openFile(path);
    return true;
  } catch (const std::exception& error) {
    notes_.warn(error.what());
    return false;
  }
}

void Viewer::openFile(const std::string& path) {
  if (run_.seeking()) return;
  const OpenedFile file = readOpened(path);
  if (file.kind != OpenedFile::Kind::Motion) return scenes_.open(file, path);
  review_.open(file.text, path, scenes_.scene());
  wantedPanel_ = OpenGhost;
}

void Viewer::act(InputAction action) {
  switch (action) {
    case StartOrPause:
      return run_.startOrPause();
    case Step:
      return run_.step();
    case StepBack:
      return run_.stepBack();
    case Slower:
      return run_.changeSpeed(0.5);
    case Faster:
      return run_.changeSpeed(2);
    case Again:
      return run_.replay();
    case RunOn:
      return run_.runOn();
    case Restart:
      return scenes_.restart();
    case SmallerStep:
      return scenes_.smallerStep();
    case LargerStep:
      return scenes_.largerStep();
    case SafeStep:
      return scenes_.takeSafeStep();
    case HoldingMethod:
      return scenes_.takeHoldingMethod();
    case FrameCloth:
      followCloth();
      return view_.frameCloth();
    case Leave:
      leaving_ = true;
      return;
    default:
      return view_.toggle(action);
  }
}

void Viewer::resize(Extent pixels, const Insets& insets) {
  followCloth();
  view_.resize(pixels, insets);
}

bool Viewer::idle() const {
  return run_.resting() && !keys_.repeats() && !keys_.held(LookAround) && !keys_.moves() && !tools_.pressed() &&
         !view_.glides();
}

bool Viewer::behind() const { return run_.state() == RunState::Running && pace().behind && !run_.asleep(); }

void Viewer::frame() {
  const double now = clock_();
  const double seconds = now - std::exchange(lastFrame_, now);
  followCloth();
  view_.move(keys_.motion(), static_cast<float>(seconds));
  keys_.moved(seconds);
  if (keys_.repeats() && !run_.seeking()) {
    if (const auto action = keys_.due(clock_())) perform(*action);
  }
  tools_.frame();
  run_.advance(seconds, pace_.otherSeconds());
  if (tools_.pressed() && run_.state() != RunState::Frozen) scenes_.followSimulation();  // a body may have been moved
  followCloth();
  if (review_.isOpen()) review_.ghost().moveTo(run_.shown().time());
  view_.followBreaking(run_.showsBreaking(), run_.state() == RunState::Running);
  if (tools_.pressed()) {
    view_.stay();
  } else {
    view_.keepInView([this] { return run_.shown().positions(); }, static_cast<float>(seconds));
  }
  run_.updateMargin(scenes_.scene());
  if (!woken_ && !idle()) pace_.measure(seconds, clock_() - now, run_.frameClock());
  woken_ = false;
}

ViewLogLine Viewer::logLine() const {
  const glm::vec3 eye = view_.camera().eye();
  const Simulation& simulation = run_.simulation();
  return {.time = run_.shown().time(),
          .state = nameOf(run_.state()),
          .integrator = scenes_.method().name,
          .dt = simulation.dt(),
          .eye = {eye.x, eye.y, eye.z},
          .picked = tools_.record().picked,
          .pushes = tools_.record().pushes,
          .kinetic = run_.shown().kinetic(),
          .alarm = nameOf(simulation.status()),
          .tool = toolTable()[tools_.chosenSlot()].name,
          .held = simulation.held().empty() ? -1 : simulation.held().front(),
          .pins = static_cast<int>(simulation.sheet().pins.size() - simulation.held().size()),
          .cuts = simulation.cuts()};
}

}  // namespace tyg
