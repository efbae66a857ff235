// The pushes of a run: when each acts, and the work that they do. A regular type, so that a checkpoint is a copy.
// Must not know: methods, stop times, alarms.
#pragma once

#include <cstdint>
#include <memory>
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

  /// The sheet has other pins now: those that act on them do no work from now on, or do it again.
  void useSheet(const Sheet& sheet, const Backend& backend);

  /// Begins and ends the pushes whose time has come. Returns whether there were any: the force then has to be applied
  /// anew.
  bool switchAt(const Instant& now, const Backend& backend);
  /// Gives the backend the pushes that act now, in place of those that it had.
  void applyTo(Backend& backend) const;
  /// The largest sum over the particles of |F|^2 / m that steady forces and the acting pushes can make, J/s2.
  [[nodiscard]] double forcing(const Scene& scene, const Sheet& sheet) const;
  /// No particle feels a larger force of steady forces and the acting pushes, N.
  [[nodiscard]] double largestForce(const Scene& scene) const;

  /// The work of all pushes so far: force times the distance moved, J.
  [[nodiscard]] double work(const Backend& backend) const;
  /// Adds energy that something else has put into the sheet, J.
  void addWork(double work) { finishedWork_ += work; }

  /// The first time after now at which a push of the scene begins or ends, or `end` where none does before it, s.
  [[nodiscard]] double nextEdge(const Instant& now, double end) const;
  /// Ticks until a push by hand begins or ends, or `most` where none does before.
  [[nodiscard]] std::int64_t ticksToEdge(std::int64_t tick, std::int64_t most) const;
  [[nodiscard]] std::size_t bytes() const {
    return ofScene_.size() * (sizeof(ScenePush) + sizeof(int)) + byHand_.size() * sizeof(HandPush);
  }

 private:
  struct Push {
    int particle = 0;
    Vec3 force;
    bool acting = false;
    Vec3 from{};             ///< where the particle was when the push began to act
    bool isIgnored = false;  ///< by a pinned particle, which moves as it does

    [[nodiscard]] double workUpTo(const Vec3& here) const;
  };
  /// Acts from `begin` on, until `end`, s.
  struct ScenePush : Push {
    double begin = 0, end = 0;
    [[nodiscard]] bool actsAt(const Instant& now) const;
  };
  /// Acts in the ticks [first, end).
  struct HandPush : Push {
    std::int64_t first = 0, end = 0;
    [[nodiscard]] bool actsAt(const Instant& now) const { return first <= now.tick && now.tick < end; }
  };
  /// Where a push of the scene begins or ends.
  struct Edge {
    double time = 0;  // s
    int push = 0;
  };

  void turn(Push& push, const Backend& backend);
  bool switchOfScene(const Instant& now, const Backend& backend);
  bool switchByHand(const Instant& now, const Backend& backend);
  /// Those of the scene first, by particle, then those by hand.
  template <class Visit>
  void forActing(const Visit& visit) const;

  std::vector<ScenePush> ofScene_;
  std::vector<HandPush> byHand_;                    // until they end
  std::shared_ptr<const std::vector<Edge>> edges_;  // by time; the same for all copies
  std::size_t passed_ = 0;                          // of the edges
  std::vector<int> acting_;                         // of the scene, by particle, then in its order
  double finishedWork_ = 0;                         // J
};

}  // namespace tyg
