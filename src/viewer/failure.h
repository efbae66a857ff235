// What breaks a run: the margin of its step, followed from frame to frame, and after a failure what the person is told
// and the ways out. Must not know: how a cure is taken, windows.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>

#include "viewer/cure.h"
#include "viewer/margin.h"
#include "viewer/shown_state.h"

namespace tyg {

/// What a method amplifies first, by the name that `tyg run` prints: a wave in a sheet of so many columns and rows, or,
/// where there are 0, a particle in contact.
struct FailingMotion {
  std::string name;
  double qx = 0, qy = 0;  ///< phases from column to column and row to row
  int columns = 0, rows = 0;
};

class Failure {
 public:
  using Clock = std::function<double()>;  ///< s, from any start
  /// The last state that was shown before the alarm.
  struct LastGood {
    std::int64_t tick = 0;
    double time = 0;  ///< s
  };

  explicit Failure(Clock clock) : clock_(std::move(clock)) {}

  /// A new run, which has not failed.
  void restart();
  /// Something was thrown: it has no cure.
  void freeze(std::string message);
  /// The alarm stopped the simulation, or a tick of it was given up after these seconds; `shown` is before that.
  void freezeOnAlarm(Simulation& simulation, const ShownState& shown);
  void freezeOnStall(Simulation& simulation, const ShownState& shown, double seconds);
  /// The cloth is no longer frozen.
  void thaw();
  void setRunsOn(bool runsOn) { runsOn_ = runsOn; }
  /// A state without an alarm is shown at this tick: a failure that lies before it is overcome.
  void passed(std::int64_t tick);

  /// On the way to an alarm, at every tick: what explains a failure is the limit just before it.
  void measureMargin(Simulation& simulation) { margin_.measure(simulation); }
  /// Once a frame, of a simulation that is not frozen. One that runs on past its alarm keeps the margin that it had
  /// there: what it has become since explains nothing.
  void updateMargin(Simulation& simulation) { runsOn_ ? margin_.keep(simulation) : margin_.update(simulation, clock_); }
  /// Likewise of a frozen one: the margin is that of the next run, with this scene's method and step.
  void previewMargin(const Scene& chosen) { margin_.preview(chosen); }
  /// A cure keeps what was chosen while the cloth is frozen: its step is the chosen one where that holds.
  void fitCure(const Simulation& simulation, const Scene& chosen);

  [[nodiscard]] const Margin& margin() const { return margin_.margin(); }
  [[nodiscard]] const std::string& message() const { return message_; }  ///< why the cloth is frozen; empty: it is not
  /// Nothing where the cloth did not freeze by its alarm.
  [[nodiscard]] const std::optional<Cure>& cure() const { return cure_; }
  /// Nothing while no alarm has stopped the run.
  [[nodiscard]] const std::optional<LastGood>& lastGood() const { return lastGood_; }
  /// A state at this tick lies after the last good one.
  [[nodiscard]] bool isPast(std::int64_t tick) const { return lastGood_ && tick > lastGood_->tick; }
  [[nodiscard]] bool runsOn() const { return runsOn_; }  ///< the person let the run go on past its alarm
  /// Nothing while no alarm has stopped the run, or where the limit does not explain it.
  [[nodiscard]] const std::optional<FailingMotion>& motion() const { return motion_; }
  /// s, when the alarm went; NaN while none has stopped the run.
  [[nodiscard]] double alarmTime() const { return lastGood_ ? alarmTime_ : std::numeric_limits<double>::quiet_NaN(); }

 private:
  /// What the person was told when the alarm went, and of which method and step.
  struct Told {
    std::string message;
    Cure cure;
    const Method* method = nullptr;
    double step = 0;  ///< s
  };
  void freezeWith(std::string message, const Cure& cure, const ShownState& shown);

  Clock clock_;
  MarginWatch margin_;
  std::string message_;
  std::optional<Cure> cure_;
  std::optional<LastGood> lastGood_;
  bool runsOn_ = false;
  // Of the last failure; it is told alike however often it is reached.
  double alarmTime_ = 0;  ///< s
  Told told_;
  std::optional<FailingMotion> motion_;
};

}  // namespace tyg
