// The viewer without its window: what each input does to the cloth and the camera, and what a frame shows.
// Must not know: window libraries, OpenGL, files. Time comes from the clock it is given.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tyg/simulation.h"
#include "view/camera.h"
#include "view/draw_options.h"
#include "view/frame_clock.h"
#include "viewer/cure.h"
#include "viewer/history.h"
#include "viewer/input_event.h"
#include "viewer/input_table.h"
#include "viewer/margin.h"
#include "viewer/scene_change.h"
#include "viewer/view_log.h"

namespace tyg {

/// Waiting: at time zero, never started. Frozen: the alarm went, or something was thrown; a restart goes on, a step
/// back and, after an alarm, a cure.
enum class RunState { Waiting, Running, Paused, Frozen };
std::string_view nameOf(RunState state);

/// How the last half second went.
struct Pace {
  double framesPerSecond = 0;  ///< 0 before anything moved
  double simulating = 0;       ///< share of the frame spent simulating, 0..1
  double realTime = 1;         ///< simulated seconds per second
  bool behind = false;         ///< the machine did not keep up with real time
};

/// The moments of a run that are kept, s.
struct Timeline {
  double first = 0, shown = 0, newest = 0;
  bool past = false;  ///< the cloth stands before the newest moment
};

using StepText = std::array<char, 48>;

/// What of the window is not the cloth's.
struct Margins {
  int left = 0, right = 0;  ///< pixels at its sides that panels and keys take
  float beside = 0;         ///< m to the left of the cloth, as the camera sees it, stands a second one; 0: none
  bool operator==(const Margins&) const = default;
};

class Viewer {
 public:
  using Clock = std::function<double()>;                          ///< s, from any start
  static constexpr double kStillSpeed = 1e-3, kStillSeconds = 1;  ///< m/s and simulated s: see asleep()

  /// Sets the scene up, waiting. Throws InputError where the scene does not fit together.
  Viewer(const Scene& scene, const Settings& settings, Clock clock);

  void handle(const WindowEvent& event);
  /// What the key of this action does, for buttons. Those that need a cursor or a number do nothing.
  void perform(InputAction action);
  /// Pauses at the kept moment nearest to this time, s.
  void turnToTime(double time);
  /// Size of the window, and what of it is not the cloth's. The first one that is not empty frames the cloth, and what
  /// is beside it, in the rest (a third of the window in any case), as F does. So do later ones, until the person moves
  /// the camera: from then on the cloth stays as large as it is, and slides to the middle of what is free.
  void resize(Extent pixels, Margins margins);
  /// Once a frame: moves the camera and the cloth to the present time.
  void frame();
  /// Freezes and shows the text: for what is thrown by those who draw and log.
  void freeze(std::string message);
  /// Shows the text until the next input: what was done, or that something is not as it was wanted.
  void note(std::string text) { note_ = std::move(text), noteWarns_ = false; }
  void warn(std::string text) { note_ = std::move(text), noteWarns_ = true; }
  /// Goes on with this scene: at once where the running simulation can (another method or step), else from the start.
  /// Changes nothing and warns where the scene does not fit together. Returns what it took.
  SceneChange use(const Scene& scene);
  /// Clicks push this many times as strongly as usual; > 0, clamped to 0.01..100.
  void setPushFactor(double factor);
  [[nodiscard]] double pushFactor() const { return pushFactor_; }
  [[nodiscard]] double pushNewtons() const;  ///< of the next click
  /// Called with the log of a run that has ended, at a restart.
  void onRunEnd(std::function<void(const EventLog&)> keep) { onRunEnd_ = std::move(keep); }

  [[nodiscard]] RunState state() const { return state_; }
  [[nodiscard]] double now() const { return clock_(); }    ///< s, of the clock that it was given
  [[nodiscard]] bool seeking() const { return seeking_; }  ///< on the way to a past moment
  [[nodiscard]] bool leaving() const { return leaving_; }
  [[nodiscard]] bool idle() const;  ///< nothing moves until the next input
  [[nodiscard]] const Simulation& simulation() const { return simulation_; }
  /// The scene that a restart begins, with the method and step that are in use.
  [[nodiscard]] const Scene& scene() const { return scene_; }
  /// Counts the sheets there have been: what is made for one sheet is made anew when this changes.
  [[nodiscard]] int sheetsSoFar() const { return sheetsSoFar_; }
  [[nodiscard]] const Method& method() const { return *method_; }  ///< chosen; frozen: for the next run
  /// `step of 2 ms`, or `tolerance of 0.1 mm` for a method that chooses its own steps: as chosen, like method().
  /// Allocates nothing.
  void describeStep(StepText& text) const;
  [[nodiscard]] const Camera& camera() const { return camera_; }
  [[nodiscard]] const DrawOptions& drawOptions() const { return draw_; }
  [[nodiscard]] bool showsHelp() const { return help_; }
  [[nodiscard]] const Pace& pace() const { return pace_; }
  [[nodiscard]] bool behind() const { return state_ == RunState::Running && pace_.behind && !asleep(); }
  [[nodiscard]] const std::string& message() const { return message_; }  ///< why it froze; empty else
  [[nodiscard]] const std::string& note() const { return note_; }
  [[nodiscard]] bool noteWarns() const { return noteWarns_; }
  /// The ways out of a failure; nothing where the cloth did not freeze by its alarm.
  [[nodiscard]] const std::optional<Cure>& cure() const { return cure_; }
  /// Of the method and step that are chosen; frozen: for the next run.
  [[nodiscard]] const Margin& margin() const { return stepMargin_.margin(); }
  /// The moments that can be gone back to.
  [[nodiscard]] Timeline timeline() const;
  /// It runs, and stays as it is until something is done to it: no particle has moved faster than a millimetre a second
  /// for a second, and no push acts or is to come. No ticks pass meanwhile.
  [[nodiscard]] bool asleep() const { return stillSince_ && time_ - *stillSince_ >= kStillSeconds; }
  [[nodiscard]] double speed() const { return frameClock_.speed(); }    ///< simulated seconds wanted per second
  [[nodiscard]] bool breaking() const { return breaking_; }             ///< runs on past its alarm
  [[nodiscard]] bool keyHeld() const { return repeated_.has_value(); }  ///< one that acts again and again
  [[nodiscard]] int pushes() const { return pushes_; }                  ///< clicks so far
  /// x, y, z of the last good state, m, its time in s, its ticks, and the box around it.
  [[nodiscard]] std::span<const float> positions() const { return positions_; }
  [[nodiscard]] double time() const { return time_; }
  [[nodiscard]] std::int64_t shownTick() const { return shownTick_; }
  [[nodiscard]] const Box& box() const { return box_; }
  [[nodiscard]] int picked() const { return picked_; }  ///< the particle pushed last; -1 before any push
  /// The energies now; the dissipated one and the drift are followed from followLedger(true) on, restarts included.
  Ledger ledger() { return simulation_.ledger(); }
  void followLedger(bool on);
  /// The push to show: while it acts or is about to, and long enough to be seen.
  [[nodiscard]] std::optional<ShownPush> shownPush() const;

  /// The present frame for the log, without its number and wall time.
  [[nodiscard]] ViewLogLine logLine();
  /// The run so far: its ticks and hash filled in.
  [[nodiscard]] EventLog record() const;
  /// The run that leads to what is shown: up to a past moment, or into the failure that the text tells of.
  [[nodiscard]] EventLog recordShown() const;

 private:
  void press(const Input& input, const WindowEvent& event);
  void release(KeyCode key);
  void act(InputAction action);
  void toggle(InputAction action);
  void useLive(const Scene& scene);
  void begin(const Scene& scene, bool newSheet);
  void startOver(Simulation fresh);
  void startOrPause();
  void goOn();
  void step();
  void turnTo(std::int64_t tick, std::function<void()> then = {});
  void seek();
  void again();
  void endReplay();
  void runOn();
  void cureWith(const Scene& wanted);
  void fitCure();
  double limitInUse();
  void takeSafeStep();
  void takeHoldingMethod();
  void useStep(double dt);
  void beforeDeed();
  void changeSpeed(double factor);
  void followSimulation();
  void restart();
  void choose(std::size_t place);
  void useMethod(const Method& method);
  void beginPush(glm::vec2 cursor);
  void keepPushing();
  void moveCursor(glm::vec2 cursor);
  void frameCloth();
  void fitView();
  void repeatHeldKey();
  void moveCloth(double frameSeconds);
  int run(std::int64_t ticks, double seconds);
  [[nodiscard]] std::int64_t together(std::int64_t most, double seconds) const;
  void showState();
  void watchForSleep();
  [[nodiscard]] bool still() const;
  void freezeOnAlarm();
  void freezeOnStall();
  void limitTicks();
  void measure(double frameSeconds, double simulatingSeconds);
  [[nodiscard]] bool held(InputAction action) const { return held_.at(static_cast<std::size_t>(action)); }
  [[nodiscard]] Motion motion() const;
  [[nodiscard]] float aside() const;

  Scene scene_;
  Settings settings_;
  Clock clock_;
  const Method* method_;
  Simulation simulation_;
  FrameClock frameClock_;
  History history_;
  MarginWatch stepMargin_;
  RunState state_ = RunState::Waiting;
  int sheetsSoFar_ = 1;
  Margins margins_;
  std::vector<glm::vec3> inView_;  ///< what was framed
  float aside_ = 0;                ///< heights of the window from its middle to the middle of what is free
  int picked_ = -1, pushes_ = 0;
  bool leaving_ = false;
  bool woken_ = false;      ///< this frame ends an idle time
  bool seeking_ = false;    ///< on the way to history_.target()
  bool late_ = false;       ///< a tick was given up
  bool breaking_ = false;   ///< runs on past its alarm
  bool replaying_ = false;  ///< the past is shown again, slowly
  bool framed_ = false;
  bool cameraMoved_ = false;  ///< by the person, since the cloth was framed
  bool help_ = true;

  double lastFrame_ = 0;           ///< s, of the clock
  std::function<void()> arrived_;  ///< done at history_.target()
  double speedBefore_ = 1;         ///< that a replay goes back to
  std::optional<Cure> cure_;
  double tickBegan_ = 0;    ///< s, of the clock
  double tickSeconds_ = 0;  ///< wall time of a tick, smoothed; 0 before the first

  std::vector<float> positions_, next_;
  double time_ = 0, kinetic_ = 0;
  std::int64_t shownTick_ = 0;
  std::optional<double> stillSince_;         ///< simulated s; nothing while it moves
  std::optional<History::Moment> lastGood_;  ///< shown last before the alarm that stopped the run
  Box box_;
  Pace pace_;
  double frameSeconds_ = 0, simulatingSeconds_ = 0;  ///< smoothed
  std::string message_, note_;
  bool noteWarns_ = false;
  std::function<void(const EventLog&)> onRunEnd_;

  Camera camera_;
  std::vector<glm::vec3> room_;  ///< to frame before anything moved
  Extent pixels_;
  glm::vec2 cursor_{0};
  std::array<bool, kInputActions> held_{};
  std::optional<Input> repeated_;  ///< its key is held down and acts again ...
  double repeatAt_ = 0;            ///< ... at this time, s, of the clock

  DrawOptions draw_;

  double pushFactor_ = 1;
  Vec3 force_;                ///< N, of the last push
  std::int64_t pushEnd_ = 0;  ///< tick
  double pushedAt_ = 0;       ///< s, of the clock
};

}  // namespace tyg
