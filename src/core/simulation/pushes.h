// The pushes of a run: when each acts, and the work that they do. A regular type, so that a snapshot is a copy.
// Must not know: methods, stop times, alarms.
#pragma once

#include <cstdint>
#include <vector>

#include "core/simulation/backend.h"

namespace tyg {

class Pushes {
 public:
  /// Of a run; `sameTime` is how close two times are one. s.
  struct Instant {
    double time = 0, sameTime = 0;
    std::int64_t tick = 0;
  };

  /// The scene's, each between two times.
  Pushes(const Scene& scene, const Sheet& sheet);
  /// One by hand, for the whole ticks [firstTick, endTick).
  void add(int particle, const Vec3& force, std::int64_t firstTick, std::int64_t endTick);

  /// Lets pushes begin and end that do so now. Says whether any did: the force jumps, and has to be applied anew.
  bool switchAt(const Instant& now, const Backend& backend);
  /// Hands those that act to the sheet, instead of what it had.
  void applyTo(Backend& backend) const;
  /// The largest sum over the particles of |F|^2 / m that gravity and those that act can make, J/s2.
  [[nodiscard]] double forcing(const Scene& scene, const Sheet& sheet) const;

  /// Force times the distance moved, of all so far, J.
  [[nodiscard]] double work(const Backend& backend) const;
  /// What something else has put into the sheet, J.
  void addWork(double work) { finishedWork_ += work; }

  /// The first time after now at which one of the scene's begins or ends, or `end` where none does before it, s.
  [[nodiscard]] double nextEdge(const Instant& now, double end) const;
  /// Ticks until one by hand begins or ends, or `most` where none does before.
  [[nodiscard]] std::int64_t ticksToEdge(std::int64_t tick, std::int64_t most) const;
  [[nodiscard]] std::size_t bytes() const { return pushes_.size() * sizeof(Push); }

 private:
  struct Push {
    int particle = 0;
    Vec3 force;
    double begin = 0, end = 0;                ///< s, of the scene
    std::int64_t firstTick = 0, endTick = 0;  ///< by hand
    bool byHand = false;
    bool acting = false;
    Vec3 from{};  ///< where the particle was when the push began to act

    [[nodiscard]] bool actsAt(const Instant& now) const;
    [[nodiscard]] double workUpTo(const Vec3& here) const;
  };

  std::vector<Push> pushes_;
  double finishedWork_ = 0;  // J
};

}  // namespace tyg
