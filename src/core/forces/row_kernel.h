// The seam between the forces and their inner loops, which are compiled once per precision and vector level.
// Plain data and function pointers only: nothing inline may cross from one vector level to another.
#pragma once

#include <cstddef>
#include <optional>

#include "core/forces/power.h"
#include "core/forces/stored_energy.h"
#include "core/forces/terms/all_terms.h"

namespace tyg {

/// x86-64 micro-architecture levels: baseline has SSE2, v3 AVX2, v4 AVX-512. All give the same bits.
enum class VectorLevel { Baseline, V3, V4 };
/// The best level that this machine and this build have.
VectorLevel bestVectorLevel();
/// For tests: forces made from now on use this level (which must not exceed the best one); nothing: the best one.
void useVectorLevel(std::optional<VectorLevel> level);

/// Families present, as bits.
enum FamilyBits { kStructural = 1, kShear = 2, kBend = 4 };
enum class DampingTerm { None, Relative, Axial };

/// What becomes of the force on a particle once it is known.
enum class Update {
  Store,         ///< force = F
  KickAndDrift,  ///< v += kick F; x += step v                                              (symplectic Euler)
  Leapfrog,      ///< v += kick F; v += kick F; x += step v; seen = v + kick F  (half kicks; v at half steps)
};

template <class T>
struct RowTask;

/// The springs of one row; its forces are finished too unless the row only feeds the rows below.
template <class T>
using AccumulateRow = void (*)(const RowTask<T>& task, int row, bool finish);
/// What becomes of the forces on places [begin, end) of one row.
template <class T>
using FinishForces = void (*)(const RowTask<T>& task, int row, std::ptrdiff_t begin, std::ptrdiff_t end);

/// The terms of blocks on the forces of places [begin, end) of one row, which are in the task's scratch memory.
template <class T>
using AddToBlock = void (*)(const RowTask<T>& task, int row, std::ptrdiff_t begin, std::ptrdiff_t end);

/// What masked loops multiply by 1 or 0: each of a particle's springs, in the order of the bits of Missing, and its
/// cell; 0 is also what the sheet has no room for.
constexpr int kMasks = 7;

/// A constant force on one particle.
template <class T>
struct PushedParticle {
  std::ptrdiff_t row = 0, column = 0;
  T force[3] = {};  ///< N
};

/// A sheet to work on row by row, with what the terms know of it. Arrays are planes x, y, z, `plane` numbers apart,
/// rows `stride` apart.
template <class T>
struct RowTask : AllTerms::Numbers<T> {
  int columns = 0;  ///< of the sheet
  int width = 0;    ///< columns rounded up to whole vectors of this precision
  int rows = 0;     ///< of the sheet
  std::ptrdiff_t stride = 0, plane = 0;
  const T* position = nullptr;
  const T* velocity = nullptr;       ///< the one that damping sees
  const T* hasRight = nullptr;       ///< per column: 1 where column + 1 exists, else 0
  const T* hasRight2 = nullptr;      ///< per column: 1 where column + 2 exists, else 0
  const T* isFree = nullptr;         ///< per particle: 0 where pinned or padding, else 1
  const T* isUnpinned = nullptr;     ///< the same, and 0 also for pins that move, which isFree may let feel forces
  const T* there = nullptr;          ///< masked loops: of the row, kMasks runs of `stride` numbers, 0 for what is gone
  const T* blockVelocity = nullptr;  ///< the one that terms of blocks see; null: the other one

  T* force = nullptr;    ///< Store: where to
  T* moving = nullptr;   ///< other updates: the positions again, to be moved in place
  T* kicked = nullptr;   ///< other updates: the velocities to be kicked in place
  T* seen = nullptr;     ///< Leapfrog: the velocities again that damping sees
  T step = 0, kick = 0;  ///< s; s/kg

  T* scratch = nullptr;                   ///< rowScratchSize numbers, all 0 before the first row
  AccumulateRow<T> accumulate = nullptr;  ///< the loops that this scene and update need
  AccumulateRow<T> masked = nullptr;      ///< the same where something of the row is gone
  AddToBlock<T> addToBlock = nullptr;     ///< null: there are no terms of blocks
  FinishForces<T> finish = nullptr;
  const PushedParticle<T>*firstPush = nullptr, *endPush = nullptr;  ///< of the row: those that FinishForces adds
};
constexpr std::ptrdiff_t kBlock = 128;  ///< particles whose forces stay in the first-level cache until they are used
/// Numbers of scratch memory that a pass over the rows needs: planes x, y, z of five rows and of a block.
constexpr std::size_t rowScratchSize(std::ptrdiff_t stride) {
  return static_cast<std::size_t>(3 * (5 * stride + kBlock));
}

/// One row of a state, with what the terms know of it in double, whatever the precision of the state.
template <class T>
struct EnergyRow : AllTerms::Numbers<double> {
  int columns = 0, rows = 0, row = 0;
  std::ptrdiff_t stride = 0, plane = 0;
  const T* position = nullptr;
  const T* velocity = nullptr;
  const T* isUnpinned = nullptr;  ///< per particle: 0 where pinned or padding, else 1
  const T* there = nullptr;       ///< of the row, as RowTask has it; null: nothing is gone
  bool axial = false;
};

/// How many subsets there are of the terms of a place.
consteval unsigned subsetsOf(TermPlace place) { return 1U << AllTerms::count(place); }

template <class T>
struct RowKernels {
  AccumulateRow<T> accumulate[subsetsOf(TermPlace::Cells)][8][3];  ///< by cell terms, families and damping term
  AccumulateRow<T> masked[subsetsOf(TermPlace::Cells)][8][3];      ///< the same for rows of which something is gone
  AddToBlock<T> addToBlock[subsetsOf(TermPlace::Blocks)];          ///< by terms of blocks; null where there are none
  FinishForces<T> finish[3][subsetsOf(TermPlace::Particles)][2];   ///< by update, terms, and whether pushes act
  StoredEnergy (*energy)(const EnergyRow<T>&);                     ///< kinetic: of particles of 1 kg
  Power (*power)(const EnergyRow<T>&);                             ///< pins not counted
};
/// The kernels of the level in use.
template <class T>
const RowKernels<T>& rowKernels();

}  // namespace tyg
