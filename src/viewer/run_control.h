// The run of a cloth through time: starting, pausing, stepping, going back, replaying, and freezing where it fails.
// Must not know: windows, the camera, who chooses scenes and settings. Time comes from the clock it is given.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "tyg/simulation.h"
#include "viewer/break_record.h"
#include "viewer/failure.h"
#include "viewer/history.h"
#include "viewer/journey.h"
#include "viewer/notes.h"
#include "viewer/playback.h"
#include "viewer/run_listener.h"
#include "viewer/shown_state.h"
#include "viewer/sleep_watch.h"
#include "viewer/tick_runner.h"

namespace tyg {

/// Waiting: at time zero, never started. Frozen: the alarm went, or something was thrown; a restart goes on, and so
/// does a step back and, after an alarm, a cure.
enum class RunState { Waiting, Running, Paused, Frozen };
std::string_view nameOf(RunState state);

/// The times of a run that are kept, s.
struct Timeline {
  double first = 0, shown = 0, newest = 0;
  bool past = false;  ///< the cloth is shown as it was before the newest time
};

class RunControl {
 public:
  using Clock = std::function<double()>;  ///< s, from any start

  /// Waits at the start of this simulation. All that is given here must live as long as this does.
  RunControl(Simulation simulation, Clock clock, Notes& notes, RunListener& listener);
  /// Once after construction, when the listener is ready to be told of the first run.
  void showStart();

  void startOrPause();
  /// Runs from the present time on; what came after it is forgotten.
  void goOn();
  /// One tick on, and pauses.
  void step();
  void stepBack() { turnTo((seeking() ? history_.target() : shown_.tick()) - 1); }
  /// Pauses at the kept tick nearest to this time, s.
  void turnToTime(double time);
  /// Shows the last second again, slowly.
  void replay();
  void changeSpeed(double factor) { playback_.changeSpeed(factor); }
  /// Past the alarm that stopped it; does nothing where none did.
  void runOn();
  /// Turns back to shortly before the failure, where it had not yet grown, and then does `then`, perhaps some frames
  /// later. Returns false, and does nothing, where there is no failure to turn back from.
  bool turnBeforeFailure(std::function<void()> then);
  /// Ends the run and waits at the start of another simulation.
  void startOver(Simulation fresh);
  /// The same with a run of it that a log tells of, which is then played up to its end. Throws InputError where the two
  /// do not fit together.
  void startOver(Simulation fresh, EventLog log);
  /// Freezes and shows the text: for what is thrown by those who draw and log.
  void freeze(std::string message);

  /// Begins a change that a person makes: the cloth wakes, and what came after the present time is forgotten. Returns
  /// what is to be changed.
  Simulation& intervene();
  /// Once a frame: simulates what is due after `frameSeconds`, of which everything else took `otherSeconds`.
  void advance(double frameSeconds, double otherSeconds);
  /// Once a frame: the margin of the method and step in use, or, where the cloth is frozen, of those of this scene,
  /// which are for the next run.
  void updateMargin(const Scene& chosen);
  /// s: the largest stable step of what is in use now, not at the last frame.
  double measureLimit();
  /// A cure keeps what was chosen while the cloth is frozen; see Failure::fitCure.
  void fitCure(const Scene& chosen) { failure_.fitCure(simulation_, chosen); }

  /// Called with the log of a run that has ended, at a restart.
  void onRunEnd(std::function<void(const EventLog&)> keep) { onRunEnd_ = std::move(keep); }
  /// The energies now; the dissipated one and the drift are followed from followLedger(true) on.
  [[nodiscard]] Ledger ledger() const { return simulation_.glance().ledger; }
  void followLedger(bool on) { simulation_.followLedger(on); }

  [[nodiscard]] RunState state() const { return state_; }
  [[nodiscard]] double now() const { return clock_(); }               ///< s, of the clock that it was given
  [[nodiscard]] bool seeking() const { return journey_.underWay(); }  ///< on the way to a past time
  [[nodiscard]] const Simulation& simulation() const { return simulation_; }
  [[nodiscard]] const ShownState& shown() const { return shown_; }
  [[nodiscard]] const Failure& failure() const { return failure_; }
  [[nodiscard]] const Margin& margin() const { return failure_.margin(); }
  /// Of a cloth that was let run on past its alarm; empty for others.
  [[nodiscard]] std::span<const BreakRecord::Moment> breaking() const { return breaking_.moments(); }
  /// It runs on past its alarm, or is shown as that has left it.
  [[nodiscard]] bool showsBreaking() const { return !breaking_.moments().empty() && failure_.isPast(shown_.tick()); }
  /// It can be let run on past its alarm.
  [[nodiscard]] bool canRunOn() const;
  [[nodiscard]] Timeline timeline() const;
  /// It runs, and stays as it is until something is done to it. No ticks pass meanwhile.
  [[nodiscard]] bool asleep() const { return sleep_.asleep(shown_.time()); }
  /// Neither ticks pass nor is a past time on its way.
  [[nodiscard]] bool resting() const { return (state_ != RunState::Running || asleep()) && !seeking(); }
  /// Its speed is the simulated seconds that are wanted per second.
  [[nodiscard]] const FrameClock& frameClock() const { return playback_.clock(); }
  /// The run so far: its ticks and hash filled in.
  [[nodiscard]] EventLog record() const { return history_.record(simulation_); }
  /// The run that leads to what is shown: up to a past time, or into the failure that the text tells of.
  [[nodiscard]] EventLog recordShown() const { return History::recordTo(simulation_); }

 private:
  void turnTo(std::int64_t tick, std::function<void()> then = {});
  void seek();
  int run(std::int64_t ticks, double seconds);
  void show();
  void noteFastContact();
  [[nodiscard]] bool isCheckedAnew();
  bool failsAhead();
  void goBackToAlarm();
  [[nodiscard]] std::int64_t ticksToBreak();
  void freezeOnAlarm();
  void freezeOnStall();

  Clock clock_;
  Notes& notes_;
  RunListener& listener_;
  Simulation simulation_;
  Playback playback_;
  double ticksPerSecond_ = 1;  ///< of the clock, in which a cloth is let break
  History history_;
  TickRunner ticks_;
  SleepWatch sleep_;
  std::int64_t checks_ = 0;  ///< energy checks of the run, as of the last frame
  ShownState shown_;
  Failure failure_;
  BreakRecord breaking_;
  RunState state_ = RunState::Waiting;
  bool isFastContactNoted_ = false;  ///< in this run
  Journey journey_;                  ///< to history_.target()
  std::function<void(const EventLog&)> onRunEnd_;
};

}  // namespace tyg
