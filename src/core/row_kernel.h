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

/// A band of rows to work on. Arrays are planes x, y, z, `plane` numbers apart, rows `stride` apart.
template <class T>
struct RowBand {
  int width = 0;                   ///< columns rounded up to whole vectors of this precision
  int rows = 0;                    ///< of the sheet
  int first = 0, last = 0;         ///< rows [first, last) are computed
  std::ptrdiff_t stride = 0, plane = 0;
  const T* position = nullptr;
  const T* velocity = nullptr;
  T* force = nullptr;
  const T* hasRight = nullptr;     ///< per column: 1 where column + 1 exists, else 0
  const T* hasRight2 = nullptr;    ///< per column: 1 where column + 2 exists, else 0
  const T* isFree = nullptr;       ///< per particle: 0 where pinned or a ghost, else 1
  T* scratch = nullptr;            ///< rowScratchSize numbers
  SpringLaw<T> structural, shear, bend;
  T weight[3] = {};                ///< gravity on one particle, N
  T drag = 0;                      ///< N s/m
};
/// Numbers of scratch memory that one thread needs.
inline std::size_t rowScratchSize(std::ptrdiff_t stride) { return static_cast<std::size_t>(15 * stride); }

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
  void (*forces[8][3])(const RowBand<T>&);  ///< by families and damping term
  RowEnergy (*energy)(const EnergyRow<T>&);
  RowEnergy (*power)(const EnergyRow<T>&);  ///< fills `power` alone
};
/// The kernels of the level in use.
template <class T>
const RowKernels<T>& rowKernels();

}  // namespace tyg
