// Forces on the particles of a sheet: all terms that its scene names, and pushes, from time, positions and velocities.
// Must not know: methods. What a scene does not model costs nothing here.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/forces/acting.h"
#include "core/forces/power.h"
#include "core/forces/state.h"
#include "core/forces/step_times.h"
#include "core/forces/stored_energy.h"

namespace tyg {

class Workers;
enum class Update;
template <class T>
struct PushedParticle;

/// The forces of a scene in newtons. Pinned particles feel exactly 0.
template <class T>
class Forces {
 public:
  /// `workers` must outlive this object; rows are shared out over them, and the result does not depend on how many.
  Forces(const Scene& scene, const Sheet& sheet, Workers& workers);
  ~Forces();
  Forces(const Forces&) = delete;
  Forces& operator=(const Forces&) = delete;

  /// Takes the parameters of this scene, which has the same sheet, from the next evaluation on. All of its winds blow,
  /// and its bodies stand still.
  void useParameters(const Scene& scene);
  /// The same sheet with other pins, or with more of it gone, from the next evaluation on. Moving pins and pushes are
  /// to be given anew.
  void useSheet(const Sheet& sheet);
  /// From now on this acts, and nothing else that has a begin and an end.
  void act(const Acting& acting);
  /// These pins move, at the velocities that the state has for them: what they bring is then worked out with every
  /// evaluation.
  void movePins(std::vector<int> particles);

  /// Force on every particle at this time (s), these positions and velocities. Counts as one force evaluation.
  void evaluate(double time, const VectorField<T>& position, const VectorField<T>& velocity, VectorField<T>& force);

  /// Whether the fused updates below may be used now: where the ledger follows the dissipation, or pins move, forces
  /// have to be seen one evaluation at a time.
  [[nodiscard]] bool canAdvance() const { return !trackDissipation_ && movingPins_.empty(); }
  static constexpr int kMostSteps = 64;  ///< of one call
  /// `count` steps v += h/m F(t, x, v); x += h v, with the same bits as evaluating and updating step by step. `times`
  /// says when each of them evaluates its force.
  void kickAndDrift(State<T>& state, double h, const StepTimes& times, int count);
  /// `count` steps v += h/2m F; v += h/2m F; x += h v; predicted = v + h/2m F with F(t, x, predicted): leapfrog with
  /// the velocity at half steps. The same bits as step by step. The force is that of the end of each step of `times`.
  void leapfrog(State<T>& state, VectorField<T>& predicted, const StepTimes& times, int count);

  /// The same, with these velocities for the terms of blocks alone.
  void evaluate(double time, const VectorField<T>& position, const VectorField<T>& velocity, VectorField<T>& force,
                const VectorField<T>& blockVelocity);
  /// Everything but the springs and the terms of blocks, for methods that treat these in a way of their own. No force
  /// evaluation.
  void evaluateWithoutStiffness(double time, const VectorField<T>& position, const VectorField<T>& velocity,
                                VectorField<T>& force);
  /// Works out the power of this state, where it is wanted, as an evaluation would.
  void measurePower(double time, const VectorField<T>& position, const VectorField<T>& velocity);

  /// What the terms know of the sheet at this time, for methods that solve with them. Valid until the next evaluation.
  [[nodiscard]] AllTerms::Numbers<T> numbersAt(double time) const;

  /// 1 for a particle that moves, 0 for a pinned one; the index is that of the planes of a field.
  [[nodiscard]] const T* freeMask() const;
  /// Newtons to metres per second squared.
  [[nodiscard]] double inverseMass() const { return inverseMass_; }
  [[nodiscard]] const Layout& layout() const { return layout_; }
  [[nodiscard]] Workers& workers() const { return workers_; }
  [[nodiscard]] std::int64_t evaluations() const { return account_.evaluations; }

  /// Constant force on one particle (N), added to any that is there. Ignored by a pinned particle.
  void addPush(int particle, const Vec3& force);
  void clearPushes();

  // For devices, which compute the same forces elsewhere:
  /// All pushes that act, by row and column; those on one particle in the order in which they are added.
  [[nodiscard]] std::span<const PushedParticle<T>> pushes() const;
  /// See movePins().
  [[nodiscard]] std::span<const int> movingPins() const { return movingPins_; }
  /// What energies and powers are worked out with, in double whatever the precision of the state. Valid until it is
  /// asked for again, or until the next energy.
  [[nodiscard]] AllTerms::Numbers<double> energyNumbersAt(double time) const;
  /// Whether damping, drag or a term takes or brings any power.
  [[nodiscard]] bool hasPower() const;
  /// An evaluation has been done elsewhere, in which this was the power.
  void countEvaluation(const Power& power) {
    ++account_.evaluations;
    account_.power = power;
  }

  /// Energies of this state at this time (s). Sums run row by row in one fixed order.
  [[nodiscard]] StoredEnergy energy(double time, const State<T>& state) const;
  /// What damping takes from the cloth and terms bring to it at this time, these positions and velocities, W. Pins are
  /// not counted. No force evaluation.
  [[nodiscard]] Power powerOf(double time, const VectorField<T>& position, const VectorField<T>& velocity) const;

  /// With `on`, every evaluation also works out the power of damping and of terms.
  void trackDissipation(bool on) { trackDissipation_ = on; }
  [[nodiscard]] bool tracksDissipation() const { return trackDissipation_; }
  /// The power of the last evaluation counts for `seconds` in its integral. Methods call it with their own quadrature
  /// weights, so that the ledger closes to the method's own order.
  void addPower(double seconds) { account_.energy.add(account_.power, seconds); }
  /// The same in two parts, for methods that may yet reject a step.
  [[nodiscard]] const Power& power() const { return account_.power; }  ///< W, at the last evaluation
  void addEnergy(const Power& joules) { account_.energy.add(joules); }
  [[nodiscard]] const Power& energyOfPower() const { return account_.energy; }  ///< J, so far

  /// What is counted along the way, to be saved and restored together with a state.
  struct Account {
    std::int64_t evaluations = 0;
    Power power;   ///< W, at the last evaluation
    Power energy;  ///< J, its integral so far
  };
  [[nodiscard]] const Account& account() const { return account_; }
  void setAccount(const Account& account) { account_ = account; }

 private:
  struct Kernel;
  /// `changed`: what is to be different in this evaluation from others.
  template <class Change>
  void runBands(const Change& change, double time, const VectorField<T>& position, const VectorField<T>& velocity,
                VectorField<T>& force);
  void finishEvaluation(double time, const VectorField<T>& position, const VectorField<T>& velocity,
                        VectorField<T>& force);
  template <class Task, class TimeOf>
  void advance(Task task, Update update, State<T>& state, double h, int count, TimeOf timeOf);
  Layout layout_;
  Workers& workers_;
  double inverseMass_;
  std::unique_ptr<Kernel> kernel_;
  void takePower(double time, const VectorField<T>& position, const VectorField<T>& velocity);
  double takeFromPins(const VectorField<T>& velocity, VectorField<T>& force) const;

  bool trackDissipation_ = false;
  std::vector<int> movingPins_;
  Account account_;
};

}  // namespace tyg
