// The step limit of a moving sheet: the mode that limits the step as the sheet is now, followed from call to call by a
// few differences of the force.
// Must not know: time, pushes, what moves the sheet.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/forces/forces.h"
#include "core/spectrum/lattice.h"
#include "core/spectrum/level_line.h"
#include "tyg/method.h"
#include "tyg/scene.h"

namespace tyg {

/// With K = -da/dx and C = -da/dv of the present state, a direction u of unit length (pinned particles at rest) moves
/// like the mode w2 = u.Ku, d = u.Cu. The methods' limits are level lines of stableStep(w2, d), and the mode that sets
/// the limit reaches farthest along the normal (a, b) of its level line: the eigenvector of a K + b C with the largest
/// eigenvalue. For symplectic Euler b/a = 2/h and for leapfrog 4/h whatever the mode (docs/model.md, section 8), so the
/// answer is exact there once the iteration has settled. Where damping alone limits a method in another way than
/// stiffness does (Runge-Kutta), two modes are followed in turn, and the smaller limit counts. A call is one restart of
/// a Lanczos iteration (Lanczos 1950) of three products, from the mode found last.
template <class T>
class LiveSpectrum {
 public:
  static constexpr int kProducts = 3;  ///< of a call, one force evaluation each; one more is for the state itself

  /// `workers` must outlive this object.
  LiveSpectrum(const Scene& scene, const Sheet& sheet, Workers& workers);

  /// Begins anew with the parameters of this scene, which has the same sheet.
  void useParameters(const Scene& scene);

  /// From now on this acts: bodies are where it says. Winds do not matter.
  void act(const Acting& acting) { acting_ = acting; }

  /// Largest stable step, s, at this state; see Simulation::liveStableStep. Allocates nothing.
  double stableStep(const Method& method, const State<T>& state, double time);
  /// All force evaluations so far.
  [[nodiscard]] std::int64_t evaluations() const { return forces_.evaluations(); }

 private:
  /// A mode that is followed from call to call, and the direction that moves like it.
  struct Follower {
    Mode mode;
    VectorField<T> direction;
  };
  enum Which { kStiff, kDamped };

  void countApart(const Scene& scene);
  [[nodiscard]] double limitOfTouching(const Method& method) const;
  [[nodiscard]] bool touches(const State<T>& state) const;
  void start(const Method& method, bool both);
  void startFrom(Which which, const LatticeWave& wave);
  /// False where the state is not finite.
  bool follow(const Method& method, Which which, const State<T>& state);
  void product(const LineNormal& weights, const State<T>& state, const VectorField<T>& u, VectorField<T>& result);
  void mix(VectorField<T>& direction);
  [[nodiscard]] double dampingOf(const State<T>& state, const VectorField<T>& u);

  double dot(const VectorField<T>& a, const VectorField<T>& b);
  double largest(const VectorField<T>& a);
  /// to = keep * to + factor * from
  void add(VectorField<T>& to, double keep, double factor, const VectorField<T>& from);

  Layout layout_;
  double mass_ = 1;        // kg
  double reach_ = 0;       // m, the largest displacement of a difference
  double mostDamped_ = 0;  // 1/s, of the sheet at rest
  Damping law_;
  Lattice lattice_;
  std::array<Vec3, 2> along_;  // a direction that each follower's mode moves in at rest
  bool isStarted_ = false;
  Forces<T> forces_;
  Acting acting_;
  double ofAir_ = 0;       ///< 1/s, that air adds to the damping of a motion at most
  double ofFriction_ = 0;  ///< the same of friction, where particles touch something
  Mode held_;              ///< of a particle that something holds
  double time_ = 0;        ///< s, of the present state
  std::array<Follower, 2> followers_;
  Which turn_ = kStiff;
  static constexpr std::uint32_t kFirstSeed = 1;
  std::uint32_t seed_ = kFirstSeed;
  VectorField<T> force_, position_, velocity_;  // the force of the state itself; a state beside it
  std::array<VectorField<T>, kProducts> basis_, image_;
  std::vector<double> ofRow_;
};

}  // namespace tyg
