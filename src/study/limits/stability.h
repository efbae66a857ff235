// How large a step may be: the limits that the springs of a sheet at rest, and in any deformation, set to a method.
// Must not know: measured limits, clocks.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/forces/term.h"
#include "core/spectrum/lattice.h"
#include "tyg/method.h"
#include "tyg/scene.h"

namespace tyg {

/// Largest stable step (s) of a method over the motions of the scene's lattice at rest, all damping included, and of a
/// particle that rests on a body (heldLimit()): the one number that commands, studies and the window call the limit at
/// rest. Of small sheets and of narrow ones it is that of their own spectrum with its edges and pins
/// (RestSpectrum::smallSheet); others are taken as unbounded, which pins and edges only loosen. 0 where no step is
/// stable; NaN where the method has no limit or nothing on the sheet sets one (free fall).
double restLatticeLimit(const Scene& scene, const Method& method);
/// The largest stable step (s) of a single particle that contact holds: along the normal w2 = k/m and d = 2 zeta
/// sqrt(k/m), along the surface d = grip/m. NaN where nothing holds particles, or the method has no limit of modes.
double heldLimit(const Scene& scene, const Method& method);
/// The modes of such a particle, along the normal and along the surface; none where nothing holds particles.
std::vector<Mode> heldModes(const Scene& scene);
/// The same as the first of the unbounded lattice, whatever the size of the sheet.
double unboundedLimit(const Scene& scene, const Method& method);

/// A step (s) up to which no deformation of the sheet makes the method unstable: each mode of the sheet as it is at any
/// one time stays bounded. For symplectic Euler, leapfrog and report-rk4 from max over q of h^2 Lk + c h Ld <= 4 m
/// (docs/model.md, section 8); for imex the same with no damping; for Runge-Kutta methods the smallest limit of any
/// mode with w2 <= max Lk / m and d <= max Ld / m, which every mode has whatever the springs' directions. Where contact
/// holds particles, imex is explicit in its damping: its c is 2 then, with all of Ld, springs and drag included. 0
/// where no step can be certified; NaN where the method has no limit, or one that depends on the whole spectrum (rkc2),
/// and where air acts on cells (catchesAir()). Springs that are compressed may buckle: that is motion, and no method's
/// fault.
double certifiedLimit(const Scene& scene, const Method& method);
/// Whether air acts on the cells of a sheet. A stretched cell catches more of it, without bound.
bool catchesAir(const Scene& scene);

/// What limits a method in a scene, and which motion fails first.
struct StepLimit {
  /// Of the finite sheet's own limit: at that limit two roots of the limiting mode meet, and the mode grows step by
  /// step though neither root does; this far below, it beats but does not grow.
  static constexpr double kBelowMeeting = 0.998;

  double predicted = 0;     ///< s: of restLatticeLimit
  double certified = 0;     ///< s: of certifiedLimit
  double qx = 0, qy = 0;    ///< phases of the wave that fails first, from column to column and row to row, [0, pi]
  Mode mode;                ///< its frequency and damping
  bool outOfPlane = false;  ///< does it move across the sheet?
  bool byDamping = false;   ///< damping sets the limit rather than stiffness
  bool byContact = false;   ///< a particle that rests on a body sets the limit, and not the springs
  /// Where damping sets the limit, the term that does most of it, such as drag or air; null where that is the springs.
  const ForceTerm* damper = nullptr;
};
StepLimit stepLimit(const Scene& scene, const Method& method);

/// What the first failing motion looks like: `checkerboard`, `column stripes`, `row stripes`, `stripes` where it may be
/// either, `rippled stripes`, `diagonal ripples`, `the whole sheet`, and in a chain `each against the next` or
/// `ripples`; `a particle on the ball` where contact sets the limit; `none` where nothing fails.
std::string appearanceOf(const Scene& scene, const StepLimit& limit);
/// The same with the plane, the wave vector and the cause: `column stripes in plane, q = (3.14, 0.00), set by
/// stiffness`; or `a particle on the ball, set by contact with the ball, not the springs`; or with `set by air, not the
/// springs`.
std::string describe(const Scene& scene, const StepLimit& limit);
/// What sets the limit, in a word: `stiffness` or `damping` of the springs, of contact `contact` or `friction`, or the
/// name of another term that damps, such as `drag` or `air`.
std::string_view causeOf(const StepLimit& limit);

}  // namespace tyg
