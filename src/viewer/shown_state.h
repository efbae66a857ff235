// The state of the cloth that is on the screen: the last one that was worth showing.
// Must not know: how it is drawn, how the simulation came there.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "tyg/simulation.h"
#include "view/box.h"
#include "view/drawn_positions.h"

namespace tyg {

class ShownState {
 public:
  /// Takes over the simulation's state. Returns false, and keeps the state before, where a picture cannot hold it or,
  /// unless `pastAlarm`, where the alarm says that it is wrong. Allocates nothing but for another number of particles.
  bool take(const Simulation& simulation, bool pastAlarm);
  /// The same for states that follow each other and are no later than the alarm. What a device has in the context that
  /// draws stays there until somebody asks for positions: then the last energy check counts, and no new one is made,
  /// unless the cloth has grown.
  bool follow(const Simulation& simulation);

  /// What was done to the sheet at the shown time without time passing.
  void followSheet(const Simulation& simulation) {
    if (sheet_ != simulation.sheet()) sheet_ = simulation.sheet();
    held_.assign(simulation.held().begin(), simulation.held().end());
  }

  [[nodiscard]] const Sheet& sheet() const { return sheet_; }        ///< with its pins and what was cut
  [[nodiscard]] std::span<const int> held() const { return held_; }  ///< of its pins those in a hand
  /// x, y, z of each particle, m.
  [[nodiscard]] std::span<const float> positions() const;
  /// The same for whoever draws; valid until another state is taken.
  [[nodiscard]] DrawnPositions drawn() const;
  [[nodiscard]] bool onDevice() const { return onDevice_ != nullptr; }  ///< in the context that draws
  [[nodiscard]] double time() const { return time_; }                   ///< s
  [[nodiscard]] std::int64_t tick() const { return tick_; }
  [[nodiscard]] double kinetic() const { return kinetic_; }  ///< energy, J, of now or of the last energy check
  [[nodiscard]] const Box& box() const { return box_; }      ///< around all particles, m

 private:
  void note(const Simulation& simulation, double kinetic, const Box& box);

  mutable std::vector<float> positions_;
  std::vector<float> next_;
  std::shared_ptr<const DevicePositions> onDevice_;  // null: positions_ is what is shown
  mutable bool isRead_ = false;                      // from there
  double time_ = 0, kinetic_ = 0;
  std::int64_t tick_ = 0;
  Box box_;
  float lookedAt_ = 0;  // m, size of the box when the energy was last looked at
  Sheet sheet_;
  std::vector<int> held_;
};

}  // namespace tyg
