// The inner loop: forces of all springs, row by row, each spring once.
//
// Particle (i, row) owns six springs: right and down (structural), down-right and, for its right neighbour, down-left
// (shear), two to the right and two down (bend). A first loop along the row computes them from contiguous loads; what the
// other ends feel is staged: `right` and `right2` for neighbours in the same row, `below` (a ring of three rows) and
// `diagonal` for rows to come. A second loop adds own forces and what neighbours have left. No load or store is scattered
// and no iteration depends on another, so the compiler vectorises both, and every width gives the same bits.
// Included by row_kernel_level.cpp alone; everything here is private to one vector level.
#pragma once

#include "core/row_kernel.h"

#if defined(__clang__)
#define TYG_INDEPENDENT _Pragma("clang loop vectorize(assume_safety)")
#else
#define TYG_INDEPENDENT _Pragma("GCC ivdep")  // `omp simd` leaves the small structs in memory and is far slower
#endif
#define TYG_INLINE [[gnu::always_inline]] inline

namespace tyg {
namespace {

TYG_INLINE float squareRoot(float a) { return __builtin_sqrtf(a); }
TYG_INLINE double squareRoot(double a) { return __builtin_sqrt(a); }

template <class T>
struct Vec {
  T x, y, z;
};
template <class T>
TYG_INLINE Vec<T> operator+(const Vec<T>& a, const Vec<T>& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
template <class T>
TYG_INLINE Vec<T> operator-(const Vec<T>& a, const Vec<T>& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
template <class T>
TYG_INLINE Vec<T> operator*(T s, const Vec<T>& a) { return {s * a.x, s * a.y, s * a.z}; }
template <class T>
TYG_INLINE T dot(const Vec<T>& a, const Vec<T>& b) { return (a.x * b.x + a.y * b.y) + a.z * b.z; }

template <class T>
TYG_INLINE Vec<T> load(const T* planes, std::ptrdiff_t plane, std::ptrdiff_t i) {
  return {planes[i], planes[plane + i], planes[2 * plane + i]};
}
template <class T>
TYG_INLINE void store(T* planes, std::ptrdiff_t plane, std::ptrdiff_t i, const Vec<T>& a) {
  planes[i] = a.x, planes[plane + i] = a.y, planes[2 * plane + i] = a.z;
}

/// Keeps 0 * infinity out of a spring of length 0; far below the rounding of any length that is not.
template <class T>
constexpr T kTiny = sizeof(T) == sizeof(float) ? T(1e-30F) : T(1e-300);

/// Force on the particle at `a` from the spring to the one at `b` (model equation: spring part plus damping); `exists` is
/// 1 or 0.
template <DampingTerm damping, class T>
TYG_INLINE Vec<T> springForce(const RowBand<T>& band, const SpringLaw<T>& law, T exists, std::ptrdiff_t a,
                              std::ptrdiff_t b) {
  const Vec<T> d = load(band.position, band.plane, b) - load(band.position, band.plane, a);
  const T inverseLength = T(1) / squareRoot(dot(d, d) + kTiny<T>);
  T pull = law.ks - law.ksTimesRest * inverseLength;
  if constexpr (damping == DampingTerm::None) {
    return (exists * pull) * d;
  } else {
    const Vec<T> dv = load(band.velocity, band.plane, b) - load(band.velocity, band.plane, a);
    if constexpr (damping == DampingTerm::Relative) {
      return (exists * pull) * d + (exists * law.kd) * dv;
    } else {
      pull += law.kd * ((dot(dv, d) * inverseLength) * inverseLength);
      return (exists * pull) * d;
    }
  }
}

constexpr std::ptrdiff_t kBlock = 128;  ///< particles whose staged forces stay in the first-level cache together
constexpr std::ptrdiff_t kPad = 16;     ///< room for the two places to the left that a block reads
constexpr std::ptrdiff_t kStage = kBlock + kPad;

/// Forces that the springs of one block pass along the row.
template <class T>
struct BlockStage {
  alignas(64) T own[3 * kStage];
  alignas(64) T right[3 * kStage];
  alignas(64) T right2[3 * kStage];

  /// Nothing stands to the left of a row.
  void clearLeft() {
    for (int k = 0; k < 3; ++k) {
      for (std::ptrdiff_t i = k * kStage + kPad - 2; i < k * kStage + kPad; ++i) right[i] = right2[i] = T(0);
    }
  }
  /// The last two places become the ones to the left of the next block.
  void carryLeft() {
    for (int k = 0; k < 3; ++k) {
      for (std::ptrdiff_t i = k * kStage + kPad - 2; i < k * kStage + kPad; ++i) {
        right[i] = right[i + kBlock];
        right2[i] = right2[i + kBlock];
      }
    }
  }
};

/// Forces that a row leaves for the rows below it, as planes `stride` apart. The last places of a plane stay 0, so that
/// reading one place to the left of a plane finds nothing.
template <class T>
struct Below {
  T *now, *next, *afterNext;       ///< for this row, the next, and the one after
  T *diagonal, *diagonalNext;      ///< on the particle down to the right of each, from the last row and from this one
};

template <class T>
Below<T> belowOf(const RowBand<T>& band, int row) {
  const std::ptrdiff_t size = 3 * band.stride;
  T* const ring = band.scratch;
  T* const diagonals = band.scratch + 3 * size;
  return {ring + row % 3 * size, ring + (row + 1) % 3 * size, ring + (row + 2) % 3 * size, diagonals + row % 2 * size,
          diagonals + (row + 1) % 2 * size};
}

/// First loop: the six springs of each particle of a block.
template <class T, int families, DampingTerm damping>
TYG_INLINE void stageSprings(const RowBand<T>& band, const Below<T>& below, BlockStage<T>& stage, int row,
                             std::ptrdiff_t begin, std::ptrdiff_t end) {
  const std::ptrdiff_t s = band.stride;
  const std::ptrdiff_t start = row * s;
  const SpringLaw<T> structural = band.structural, shear = band.shear, bend = band.bend;
  const T hasDown = T(row + 1 < band.rows), hasDown2 = T(row + 2 < band.rows);
  const T *hasRight = band.hasRight, *hasRight2 = band.hasRight2;
  T *own = stage.own + kPad - begin, *right = stage.right + kPad - begin, *right2 = stage.right2 + kPad - begin;
  TYG_INDEPENDENT
  for (std::ptrdiff_t i = begin; i < end; ++i) {
    const std::ptrdiff_t a = start + i;
    Vec<T> f = load(below.now, s, i), onRight{0, 0, 0}, onNext{0, 0, 0};
    if constexpr ((families & kBend) != 0) onNext = load(below.next, s, i);
    if constexpr ((families & kStructural) != 0) {
      const Vec<T> across = springForce<damping>(band, structural, hasRight[i], a, a + 1);
      const Vec<T> down = springForce<damping>(band, structural, hasDown, a, a + s);
      f = (f + across) + down;
      onRight = onRight - across;
      onNext = onNext - down;
    }
    if constexpr ((families & kShear) != 0) {
      const T exists = hasDown * hasRight[i];
      const Vec<T> downRight = springForce<damping>(band, shear, exists, a, a + s + 1);
      const Vec<T> downLeft = springForce<damping>(band, shear, exists, a + 1, a + s);
      f = f + downRight;
      onRight = onRight + downLeft;
      onNext = onNext - downLeft;
      store(below.diagonalNext, s, i, downRight);
    }
    if constexpr ((families & kBend) != 0) {
      const Vec<T> across = springForce<damping>(band, bend, hasRight2[i], a, a + 2);
      const Vec<T> down = springForce<damping>(band, bend, hasDown2, a, a + 2 * s);
      f = (f + across) + down;
      store(right2, kStage, i, across);
      store(below.afterNext, s, i, Vec<T>{0, 0, 0} - down);
    }
    store(own, kStage, i, f);
    store(right, kStage, i, onRight);
    store(below.next, s, i, onNext);
  }
}

/// Second loop: own forces, what the neighbours passed on, and gravity; exactly 0 at pins and ghosts.
template <class T, int families>
TYG_INLINE void sumForces(const RowBand<T>& band, const Below<T>& below, const BlockStage<T>& stage, int row,
                          std::ptrdiff_t begin, std::ptrdiff_t end) {
  const std::ptrdiff_t s = band.stride, plane = band.plane;
  T* const force = band.force + row * s;
  const T* const velocity = band.velocity + row * s;
  const T* const isFree = band.isFree + row * s;
  const T *own = stage.own + kPad - begin, *right = stage.right + kPad - begin, *right2 = stage.right2 + kPad - begin;
  const Vec<T> weight{band.weight[0], band.weight[1], band.weight[2]};
  TYG_INDEPENDENT
  for (std::ptrdiff_t i = begin; i < end; ++i) {
    Vec<T> f = load(own, kStage, i);
    if constexpr ((families & (kStructural | kShear)) != 0) f = f + load(right, kStage, i - 1);
    if constexpr ((families & kShear) != 0) f = f - load(below.diagonal, s, i - 1);
    if constexpr ((families & kBend) != 0) f = f - load(right2, kStage, i - 2);
    store(force, plane, i, isFree[i] * (f + weight));
  }
  if (band.drag == T(0)) return;
  const T drag = band.drag;
  TYG_INDEPENDENT
  for (std::ptrdiff_t i = begin; i < end; ++i) {
    store(force, plane, i, load(force, plane, i) - (isFree[i] * drag) * load(velocity, plane, i));
  }
}

/// Forces on rows [first, last). The two rows above are computed again rather than waited for.
template <class T, int families, DampingTerm damping>
void forcesOfBand(const RowBand<T>& given) {
  const RowBand<T> band = given;  // on the stack, where no store can alias it
  BlockStage<T> stage;
  for (std::ptrdiff_t i = 0; i < 15 * band.stride; ++i) band.scratch[i] = T(0);
  for (int row = band.first > 2 ? band.first - 2 : 0; row < band.last; ++row) {
    const Below<T> below = belowOf(band, row);
    stage.clearLeft();
    for (std::ptrdiff_t begin = 0; begin < band.width; begin += kBlock) {
      const std::ptrdiff_t end = begin + kBlock < band.width ? begin + kBlock : band.width;
      stageSprings<T, families, damping>(band, below, stage, row, begin, end);
      if (row >= band.first) sumForces<T, families>(band, below, stage, row, begin, end);
      stage.carryLeft();
    }
  }
}

}  // namespace
}  // namespace tyg
