// The seam between the forces and their inner loops, which are compiled once per precision and vector level.
// Plain data and function pointers only: nothing inline may cross from one vector level to another.
#pragma once

#include <cstddef>
#include <optional>

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

/// The law of one family: force = (ks - ksTimesRest / length) * direction + damping.
template <class T>
struct SpringLaw {
  T ks = 0, ksTimesRest = 0, kd = 0;  ///< N/m, N, N s/m
};

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
using StageRow = void (*)(const RowTask<T>& task, int row, bool finish);
/// What becomes of the forces on places [begin, end) of one row.
template <class T>
using FinishForces = void (*)(const RowTask<T>& task, int row, std::ptrdiff_t begin, std::ptrdiff_t end);

/// A sheet to work on row by row. Arrays are planes x, y, z, `plane` numbers apart, rows `stride` apart.
template <class T>
struct RowTask {
  int width = 0;  ///< columns rounded up to whole vectors of this precision
  int rows = 0;   ///< of the sheet
  std::ptrdiff_t stride = 0, plane = 0;
  const T* position = nullptr;
  const T* velocity = nullptr;   ///< the one that damping and drag see
  const T* hasRight = nullptr;   ///< per column: 1 where column + 1 exists, else 0
  const T* hasRight2 = nullptr;  ///< per column: 1 where column + 2 exists, else 0
  const T* isFree = nullptr;     ///< per particle: 0 where pinned or a ghost, else 1
  SpringLaw<T> structural, shear, bend;
  T weight[3] = {};  ///< gravity on one particle, N
  T drag = 0;        ///< N s/m

  T* force = nullptr;    ///< Store: where to
  T* moving = nullptr;   ///< other updates: the positions again, to be moved in place
  T* kicked = nullptr;   ///< other updates: the velocities to be kicked in place
  T* seen = nullptr;     ///< Leapfrog: the velocities again that damping and drag see
  T step = 0, kick = 0;  ///< s; s/kg

  T* scratch = nullptr;         ///< rowScratchSize numbers, all 0 before the first row
  StageRow<T> stage = nullptr;  ///< the loops that this scene and update need
  FinishForces<T> finish = nullptr;
};
/// Numbers of scratch memory that a pass over the rows needs.
constexpr std::size_t rowScratchSize(std::ptrdiff_t stride) { return static_cast<std::size_t>(15 * stride + 3 * 128); }

/// What one row contributes to the energies, summed over its particles and the springs they own.
struct RowEnergy {
  double kinetic = 0;     ///< sum of |v|^2 / 2
  double fallen = 0;      ///< sum of position . weight, J
  double elastic = 0;     ///< J
  double maxStretch = 0;  ///< fraction of rest length
  double power = 0;       ///< W taken by damping and drag
};
/// Rest lengths and laws in double, whatever the precision of the state.
template <class T>
struct EnergyRow {
  int columns = 0, rows = 0, row = 0;
  std::ptrdiff_t stride = 0, plane = 0;
  const T* position = nullptr;
  const T* velocity = nullptr;
  struct Family {
    double ks = 0, kd = 0, rest = 0;
  } families[3];
  bool axial = false;
  double weight[3] = {};
  double drag = 0;
};

template <class T>
struct RowKernels {
  StageRow<T> stage[8][3];       ///< by families and damping term
  FinishForces<T> finish[3][2];  ///< by update, and whether there is drag
  RowEnergy (*energy)(const EnergyRow<T>&);
  RowEnergy (*power)(const EnergyRow<T>&);  ///< fills `power` alone
};
/// The kernels of the level in use.
template <class T>
const RowKernels<T>& rowKernels();

}  // namespace tyg
