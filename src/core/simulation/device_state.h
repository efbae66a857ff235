// The state of a cloth where a device has it: what can be asked there takes less time than a copy of everything.
// Must not know: what the device is.
#pragma once

#include <memory>

#include "core/forces/forces.h"
#include "core/forces/state.h"
#include "core/simulation/device_positions.h"

namespace tyg {

struct ParticleState {
  Vec3 position, velocity;  ///< m, m/s
};

/// All answers are those that the state itself would give, to the last bit, as long as no number leaves its range.
template <class T>
class DeviceState {
 public:
  virtual ~DeviceState() = default;
  [[nodiscard]] virtual ParticleState particle(int index) = 0;
  virtual void place(int index, const ParticleState& particle) = 0;
  /// See Forces::energy and Forces::powerOf.
  [[nodiscard]] virtual StoredEnergy energy(const Forces<T>& forces, double time) = 0;
  [[nodiscard]] virtual Power power(const Forces<T>& forces, double time) = 0;
  /// The squares of the largest speed (m2/s2) and of the length of the longest structural spring that is there (m2), 0
  /// where there is none.
  struct Largest {
    T squaredSpeed = 0, squaredLength = 0;
  };
  [[nodiscard]] virtual Largest largest() = 0;
  /// For whoever draws; null where the device has no buffer that can be drawn from.
  [[nodiscard]] virtual std::shared_ptr<const DevicePositions> positions() = 0;
};

}  // namespace tyg
