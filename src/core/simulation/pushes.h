// The pushes of a run: when each acts, and the work that they do. A regular type, so that a checkpoint is a copy.
// Must not know: methods, stop times, alarms.
#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "core/simulation/backend.h"
#include "core/simulation/instant.h"

namespace tyg {

class Pushes {
 public:
  /// The pushes of the scene, each of which acts from one time to another.
  Pushes(const Scene& scene, const Sheet& sheet);
  /// Adds a push by hand, which acts for the whole ticks [firstTick, endTick).
  void add(const Sheet& sheet, int particle, const Vec3& force, std::int64_t firstTick, std::int64_t endTick);

  /// Begins and ends the pushes whose time has come. Returns whether there were any: the force then has to be applied
  /// anew.
  bool switchAt(const Instant& now, const Backend& backend);
  /// Gives the backend the pushes that act now, in place of those that it had.
  void applyTo(Backend& backend) const;
  /// The largest sum over the particles of |F|^2 / m that steady forces and the acting pushes can make, J/s2.
  [[nodiscard]] double forcing(const Scene& scene, const Sheet& sheet) const;

  /// The work of all pushes so far: force times the distance moved, J.
  [[nodiscard]] double work(const Backend& backend) const;
  /// Adds energy that something else has put into the sheet, J.
  void addWork(double work) { finishedWork_ += work; }

  /// The first time after now at which a push of the scene begins or ends, or `end` where none does before it, s.
  [[nodiscard]] double nextEdge(const Instant& now, double end) const;
  /// Ticks until a push by hand begins or ends, or `most` where none does before.
  [[nodiscard]] std::int64_t ticksToEdge(std::int64_t tick, std::int64_t most) const;
  [[nodiscard]] std::size_t bytes() const { return pushes_.size() * sizeof(Push); }

 private:
  /// When a push of the scene acts: from `begin` on, until `end`, s.
  struct Times {
    double begin = 0, end = 0;
  };
  /// When a push by hand acts: in the ticks [first, end).
  struct Ticks {
    std::int64_t first = 0, end = 0;
  };
  struct Push {
    int particle = 0;
    Vec3 force;
    std::variant<Times, Ticks> when;
    bool acting = false;
    Vec3 from{};             ///< where the particle was when the push began to act
    bool isIgnored = false;  ///< by a pinned particle, which moves as it does

    [[nodiscard]] bool actsAt(const Instant& now) const;
    [[nodiscard]] double workUpTo(const Vec3& here) const;
  };

  std::vector<Push> pushes_;
  double finishedWork_ = 0;  // J
};

}  // namespace tyg
