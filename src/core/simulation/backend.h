// What moves in a simulation, and depends on the precision: state, forces and integrator behind one virtual interface.
// Must not know: stop times, when a push begins or ends, alarms.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/forces/forces.h"
#include "core/simulation/device_state.h"
#include "tyg/method.h"
#include "tyg/scene.h"
#include "tyg/simulation.h"

namespace tyg {

class Backend {
 public:
  /// A copy of everything that moves. Only the backend that made it can restore it.
  struct Checkpoint {
    virtual ~Checkpoint() = default;
    [[nodiscard]] virtual std::size_t bytes() const = 0;  ///< of memory
  };

  virtual ~Backend() = default;
  virtual void useMethod(const Method& method) = 0;
  /// The sheet has other pins now, or more of it is gone. Moving pins and pushes are to be given anew.
  virtual void useSheet(const Method& method) = 0;
  /// The scene has other live parameters now. Changes nothing where the method refuses them by throwing InputError.
  virtual void useLiveParameters() = 0;
  // Times are those of the state, s, where nothing else is said.
  /// `count` such steps, 1 to 64.
  virtual void steps(const StepTimes& times, int count) = 0;
  /// See Integrator::stepWithin.
  virtual double stepWithin(double time, double most, double tolerance) = 0;
  /// See Forces::act.
  virtual void act(const Acting& acting) = 0;
  /// Puts a pin there with this velocity, and says which pins move from now on.
  virtual void placePin(int particle, const ParticleState& there) = 0;
  virtual void movePins(std::vector<int> particles) = 0;
  virtual void clearPushes() = 0;
  virtual void addPush(int particle, const Vec3& force) = 0;
  /// To be called after any edit of pushes, winds or state.
  virtual void reset() = 0;

  /// See Simulation::liveStableStep.
  virtual double liveStableStep(const Method& method, double time) = 0;
  /// See Forces::trackDissipation.
  virtual void trackDissipation(bool on, double time) = 0;
  [[nodiscard]] virtual StoredEnergy energy(double time) const = 0;
  /// Energies of the start shape with the parameters of now, at the time 0.
  [[nodiscard]] virtual StoredEnergy startEnergy() const = 0;
  /// The structural springs that are there and longer than this, m, in index order: to the right before down.
  [[nodiscard]] virtual std::vector<SpringEnds> longerThan(double length) const = 0;
  /// Of any particle, m/s.
  [[nodiscard]] virtual double largestSpeed() const = 0;
  /// See Forces::powerOf and Forces::energyOfPower.
  [[nodiscard]] virtual Power power(double time) const = 0;
  [[nodiscard]] virtual Power energyOfPower() const = 0;
  [[nodiscard]] virtual std::int64_t evaluations() const = 0;
  /// One particle alone. Whoever asks for many asks for their positions and velocities instead.
  [[nodiscard]] virtual ParticleState particle(int index) const = 0;
  [[nodiscard]] virtual Vec3 position(int particle) const = 0;
  [[nodiscard]] virtual Vec3 velocity(int particle) const = 0;
  virtual void copyPositions(std::span<float> xyz) const = 0;
  /// See DeviceState::positions; null where no device has the state.
  [[nodiscard]] virtual std::shared_ptr<const DevicePositions> positionsOnDevice() const = 0;
  [[nodiscard]] virtual std::uint64_t hash() const = 0;

  [[nodiscard]] virtual std::unique_ptr<Checkpoint> save() const = 0;
  virtual void restore(const Checkpoint& saved) = 0;
};

/// A scene from its displaced start shape. The references must outlive it. Throws InputError where the method, or the
/// device that the settings name, does not take the scene.
std::unique_ptr<Backend> makeBackend(const Scene& scene, const Sheet& sheet, const Method& method, Workers& workers,
                                     const Settings& settings);

}  // namespace tyg
