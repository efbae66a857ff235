// Turns the uneven time between frames into whole ticks of one fixed length, so that every frame rate moves the cloth
// through the same states. Must not know: clocks (time is an argument), the simulation, windows.
#pragma once

namespace tyg {

/// Use, once a frame: `n = clock.due(wallSeconds)`, run up to n ticks, `clock.ran(howMany)`. A viewer that runs out of
/// patience before n ticks runs fewer: the rest is dropped, time does not pile up, and realTimeFactor() tells.
class FrameClock {
 public:
  /// At most this much simulated time is due in one frame, s at speed 1, so that frames that come five times a second
  /// still show real time; a longer pause is dropped.
  static constexpr double kMostPerFrame = 0.25;

  explicit FrameClock(double tick) { setTick(tick); }

  /// Length of a tick, s, > 0 (anything else throws std::invalid_argument). Time owed so far is kept.
  void setTick(double seconds);
  [[nodiscard]] double tick() const { return tick_; }
  /// Simulated seconds per wall second that are wanted: 1 is real time, 0.25 slow motion. > 0, else
  /// std::invalid_argument. Starts realTimeFactor() anew.
  void setSpeed(double factor);
  [[nodiscard]] double speed() const { return speed_; }

  /// Ticks to run for a frame that comes `wallSeconds` after the last one. Negative or not finite counts as zero.
  int due(double wallSeconds);
  /// How many of them were run (0..due).
  void ran(int ticks);

  /// Simulated seconds per wall second, smoothed over about half a second. Before the first frame: the speed.
  [[nodiscard]] double realTimeFactor() const { return factor_; }
  /// True while the machine is more than a tenth slower than asked.
  [[nodiscard]] bool behind() const { return factor_ < 0.9 * speed_; }
  /// Forgets time owed and starts realTimeFactor() anew: after a pause, a restart, a window that was hidden.
  void restart();

 private:
  double tick_ = 1e-3, speed_ = 1;
  double owed_ = 0;      ///< simulated s not yet due as a whole tick
  double lastWall_ = 0;  ///< wall s of the present frame
  double factor_ = 1;
};

}  // namespace tyg
