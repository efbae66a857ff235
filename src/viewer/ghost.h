// A second simulation that follows the live one: its reference solution, or another method in the same steps. It gets
// every push from the live one's log, goes with it back in time, and knows how far apart the two are.
// Must not know: windows, how anything is drawn; time comes from the clock it is given.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "study/motion/reference.h"
#include "tyg/simulation.h"

namespace tyg {

/// How far the live cloth is from its ghost, when both are at the same time.
struct GhostGap {
  double time = 0;     ///< s
  double rms = 0;      ///< m, over all particles
  double largest = 0;  ///< m, of any particle
  double error = 0;    ///< m, the largest RMS distance so far
  /// errorFloor() of the study, m. A twin of the ghost that starts a little away follows it: whatever the cloth has
  /// made of that distance at most, it makes of the live cloth's rounding, and of the reference's own error.
  double floor = 0;
  [[nodiscard]] bool means() const { return meansSomething(error, floor); }
};

/// The state of the live run that is on the screen while the live simulation itself has gone on, to its alarm.
struct ShownTarget {
  std::int64_t ticks = 0;
  double time = 0;                     ///< s
  std::span<const float> positions{};  ///< x, y, z, m
};

class Ghost {
 public:
  using Clock = std::function<double()>;  ///< s, from any start

  /// Of the live simulation's reference where `second` is null, else of that method with the live one's steps.
  /// Throws InputError where that method does not take the scene.
  Ghost(const Simulation& live, const Method* second);

  /// Comes up to the live simulation's time, or as near as `seconds` of the clock allow (one stride at least). Where
  /// the live one went back in time or began anew, so does the ghost; where its scene changed, it begins anew. To
  /// `shown` instead, where that is not null.
  void follow(const Simulation& live, double seconds, const Clock& clock, const ShownTarget* shown = nullptr);

  [[nodiscard]] const Method& method() const { return *method_; }
  [[nodiscard]] bool isReference() const { return second_ == nullptr; }
  [[nodiscard]] double tolerance() const { return scene_.tolerance; }  ///< m, of the reference's steps
  [[nodiscard]] double time() const { return main_->time(); }          ///< s
  /// s from the ghost to the live cloth at the last follow(); 0: in step.
  [[nodiscard]] double behind() const { return behind_; }
  /// It has come no nearer within a second of the clock.
  [[nodiscard]] bool losing() const { return losing_; }
  [[nodiscard]] Status status() const { return main_->status(); }
  /// A tick of it took longer than a second: it has stopped, until the live one goes back in time or begins anew.
  [[nodiscard]] bool stalled() const { return stalled_; }
  /// Force evaluations by the ghost and its twin since it began; goes back with it in time.
  [[nodiscard]] std::int64_t forceEvaluations() const;

  /// Of the last time in step; none before that, and none since a return in time until they meet again.
  [[nodiscard]] const std::optional<GhostGap>& gap() const { return gap_; }
  [[nodiscard]] const Sheet& sheet() const { return main_->sheet(); }  ///< with its pins and what was cut
  /// The ghost's x, y, z, m.
  [[nodiscard]] std::span<const float> positions() const { return positions_; }
  /// The distance of each particle at gap()'s time, m; empty without a gap.
  [[nodiscard]] std::span<const float> distances() const { return distances_; }
  /// T* of the study, s: the last time at which ten floors fitted into the largest distance so far, 0 where they never
  /// did; NaN while they do, and while the floor could not be seen in the window anyway.
  [[nodiscard]] double horizon() const;
  /// s, when they first met: what was before is not known. NaN before that.
  [[nodiscard]] double comparedSince() const { return told_.since; }

 private:
  /// What the distances up to now have told.
  struct Told {
    double amplification = 1;                                 ///< of the twin's distance, the largest
    double error = 0;                                         ///< m, the largest RMS distance
    double meant = 0;                                         ///< s, the last time at which it meant something
    double since = std::numeric_limits<double>::quiet_NaN();  ///< s, the first time
  };
  /// A state to go back to.
  struct Checkpoint {
    std::int64_t tick = 0;
    std::size_t events = 0;  ///< of the live log, played by then
    Snapshot main;
    Snapshot twin;
    Told told;
  };
  void begin(const Simulation& live);
  [[nodiscard]] Scene sceneFor(const Simulation& live) const;
  [[nodiscard]] bool hasStrayed(const Simulation& live) const;
  void goBack(const Simulation& live);
  void keepCheckpoint();
  void stride(const Simulation& live);
  bool strideInTime(const Simulation& live, const Clock& clock);
  void watchGap(double now);
  void measure(const Simulation& live, const ShownTarget* shown);

  const Method *second_, *method_;
  Scene liveScene_, scene_;  ///< as the live one was begun; as the ghost runs it
  std::optional<Simulation> main_, twin_;
  std::vector<Event> played_;  ///< of the live log
  std::vector<Checkpoint> checkpoints_;
  std::int64_t ticksBetweenCheckpoints_ = 0;
  double behind_ = 0;
  double watched_ = 0, behindThen_ = 0;  ///< s of the clock, and how far behind it was
  bool losing_ = false, stalled_ = false;
  double twinDistance_ = 0;  ///< m, at the start
  std::int64_t goal_ = 0;    ///< ticks to come up to
  Told told_;
  std::optional<GhostGap> gap_;
  std::vector<float> positions_, distances_;
};

}  // namespace tyg
