// Forces on the particles of a sheet: all terms that its scene names, and pushes, from positions and velocities.
// Must not know: time, methods. What a scene does not model costs nothing here.
#pragma once

#include <cstdint>
#include <memory>

#include "core/forces/state.h"
#include "core/forces/stored_energy.h"

namespace tyg {

class Workers;
enum class Update;

/// The forces of a scene in newtons. Pinned particles feel exactly 0.
template <class T>
class Forces {
 public:
  /// `workers` must outlive this object; rows are shared out over them, and the result does not depend on how many.
  Forces(const Scene& scene, const Sheet& sheet, Workers& workers);
  ~Forces();
  Forces(const Forces&) = delete;
  Forces& operator=(const Forces&) = delete;

  /// Takes the parameters of this scene, which has the same sheet, from the next evaluation on.
  void useParameters(const Scene& scene);

  /// Force on every particle at these positions and velocities. Counts as one force evaluation.
  void evaluate(const VectorField<T>& position, const VectorField<T>& velocity, VectorField<T>& force);

  /// Whether the fused updates below may be used now: where the ledger follows the dissipation, forces have to be seen
  /// one evaluation at a time.
  [[nodiscard]] bool canAdvance() const { return !trackDissipation_; }
  static constexpr int kMostSteps = 64;  ///< of one call
  /// `count` steps v += h/m F(x, v); x += h v, with the same bits as evaluating and updating step by step.
  void kickAndDrift(State<T>& state, double h, int count);
  /// `count` steps v += h/2m F; v += h/2m F; x += h v; predicted = v + h/2m F with F(x, predicted): leapfrog with the
  /// velocity at half steps. The same bits as step by step.
  void leapfrog(State<T>& state, VectorField<T>& predicted, double h, int count);

  /// Everything but the springs, for methods that treat these in a way of their own. No force evaluation.
  void evaluateWithoutSprings(const VectorField<T>& position, const VectorField<T>& velocity, VectorField<T>& force);
  /// Works out the power of this state for the ledger, where it is wanted, as an evaluation would.
  void measurePower(const VectorField<T>& position, const VectorField<T>& velocity);

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

  /// Energies of this state. Sums run row by row in one fixed order.
  [[nodiscard]] StoredEnergy energy(const State<T>& state) const;
  /// W that damping takes from the cloth at these positions and velocities, >= 0. No force evaluation.
  [[nodiscard]] double lossPower(const VectorField<T>& position, const VectorField<T>& velocity) const;

  /// With `on`, every evaluation also works out the power that damping takes from the cloth.
  void trackDissipation(bool on) { trackDissipation_ = on; }
  /// The last evaluation counts for `seconds` in the integral of the dissipated power. Methods call it with their own
  /// quadrature weights, so that the ledger closes to the method's own order.
  void dissipate(double seconds) { addDissipated(seconds * power()); }
  /// The same in two parts, for methods that may yet reject a step.
  [[nodiscard]] double power() const { return account_.power; }  ///< W, at the last evaluation
  void addDissipated(double joules) { account_.dissipated += joules; }
  [[nodiscard]] double dissipated() const { return account_.dissipated; }  ///< J, so far

  /// What is counted along the way, to be saved and restored together with a state.
  struct Account {
    std::int64_t evaluations = 0;
    double power = 0;       ///< W, at the last evaluation
    double dissipated = 0;  ///< J
  };
  [[nodiscard]] const Account& account() const { return account_; }
  void setAccount(const Account& account) { account_ = account; }

 private:
  struct Kernel;
  template <class Loop>
  void runBands(Loop accumulate, const VectorField<T>& position, const VectorField<T>& velocity, VectorField<T>& force);
  template <class Task>
  void advance(Task task, Update update, State<T>& state, double h, int count);
  Layout layout_;
  Workers& workers_;
  double inverseMass_;
  std::unique_ptr<Kernel> kernel_;
  bool trackDissipation_ = false;
  Account account_;
};

}  // namespace tyg
