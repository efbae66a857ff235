// The inner loops: forces of all springs, row by row, each spring once, and what a step does with them.
//
// Particle (i, row) owns six springs: right and down (structural), down-right and, for its right neighbour, down-left
// (shear), two to the right and two down (bend). `stageSprings` computes them along the row from contiguous loads; what
// the other ends feel is staged: `right` and `right2` for neighbours in the same row, `below` (a ring of three rows)
// and `diagonal` for rows to come. `finishForces` then adds own forces and what neighbours have left, and stores the
// sum or moves the particle with it: no spring owned further on looks back at this row, so that is safe in place. No
// load or store is scattered and no iteration depends on another: the compiler vectorises both, and every width gives
// the same bits. Included by row_kernel_level.cpp alone; everything here is private to one vector level.
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
TYG_INLINE Vec<T> operator+(const Vec<T>& a, const Vec<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
TYG_INLINE Vec<T> operator-(const Vec<T>& a, const Vec<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
TYG_INLINE Vec<T> operator*(T s, const Vec<T>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class T>
TYG_INLINE T dot(const Vec<T>& a, const Vec<T>& b) {
  return (a.x * b.x + a.y * b.y) + a.z * b.z;
}

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

/// Force on the particle at `a` from the spring to the one at `b` (model equation: spring part plus damping); `exists`
/// is 1 or 0.
template <DampingTerm damping, class T>
TYG_INLINE Vec<T> springForce(const RowTask<T>& task, const SpringLaw<T>& law, T exists, std::ptrdiff_t a,
                              std::ptrdiff_t b) {
  const Vec<T> d = load(task.position, task.plane, b) - load(task.position, task.plane, a);
  const T inverseLength = T(1) / squareRoot(dot(d, d) + kTiny<T>);
  T pull = law.ks - law.ksTimesRest * inverseLength;
  if constexpr (damping == DampingTerm::None) {
    return (exists * pull) * d;
  } else {
    const Vec<T> dv = load(task.velocity, task.plane, b) - load(task.velocity, task.plane, a);
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
constexpr std::ptrdiff_t kStage = 160;  ///< from one plane of a block's staged forces to the next

/// Where a row's forces are staged, as pointers to planes; all within the task's scratch memory.
template <class T>
struct Staged {
  T *own, *right, *right2;     ///< of a block, planes kStage apart, by place less the block's begin
  T *now, *next, *afterNext;   ///< for this row, the next, and the one after; planes `stride` apart
  T *diagonal, *diagonalNext;  ///< on the particle down to the right of each, from the last row and from this one
};

template <class T>
TYG_INLINE Staged<T> stagedOf(const RowTask<T>& task, int row, std::ptrdiff_t begin) {
  const std::ptrdiff_t size = 3 * task.stride;
  T* const ring = task.scratch;
  T* const diagonals = ring + 3 * size;  // ghosts before it stay 0: the place to the left of a row holds nothing
  T* const block = diagonals + 2 * size + kPad - begin;
  return {block,
          block + 3 * kStage,
          block + 6 * kStage,
          ring + row % 3 * size,
          ring + (row + 1) % 3 * size,
          ring + (row + 2) % 3 * size,
          diagonals + row % 2 * size,
          diagonals + (row + 1) % 2 * size};
}

/// The six springs of each particle of a block.
template <class T, int families, DampingTerm damping>
void stageSprings(const RowTask<T>& given, int row, std::ptrdiff_t begin, std::ptrdiff_t end) {
  const RowTask<T> task = given;  // on the stack, where no store can alias it
  const Staged<T> to = stagedOf(task, row, begin);
  const std::ptrdiff_t s = task.stride;
  const std::ptrdiff_t start = row * s;
  const SpringLaw<T> structural = task.structural, shear = task.shear, bend = task.bend;
  const T hasDown = T(row + 1 < task.rows), hasDown2 = T(row + 2 < task.rows);
  const T *hasRight = task.hasRight, *hasRight2 = task.hasRight2;
  TYG_INDEPENDENT
  for (std::ptrdiff_t i = begin; i < end; ++i) {
    const std::ptrdiff_t a = start + i;
    Vec<T> f = load(to.now, s, i), onRight{0, 0, 0}, onNext{0, 0, 0};
    if constexpr ((families & kBend) != 0) onNext = load(to.next, s, i);
    if constexpr ((families & kStructural) != 0) {
      const Vec<T> across = springForce<damping>(task, structural, hasRight[i], a, a + 1);
      const Vec<T> down = springForce<damping>(task, structural, hasDown, a, a + s);
      f = (f + across) + down;
      onRight = onRight - across;
      onNext = onNext - down;
    }
    if constexpr ((families & kShear) != 0) {
      const T exists = hasDown * hasRight[i];
      const Vec<T> downRight = springForce<damping>(task, shear, exists, a, a + s + 1);
      const Vec<T> downLeft = springForce<damping>(task, shear, exists, a + 1, a + s);
      f = f + downRight;
      onRight = onRight + downLeft;
      onNext = onNext - downLeft;
      store(to.diagonalNext, s, i, downRight);
    }
    if constexpr ((families & kBend) != 0) {
      const Vec<T> across = springForce<damping>(task, bend, hasRight2[i], a, a + 2);
      const Vec<T> down = springForce<damping>(task, bend, hasDown2, a, a + 2 * s);
      f = (f + across) + down;
      store(to.right2, kStage, i, across);
      store(to.afterNext, s, i, Vec<T>{0, 0, 0} - down);
    }
    store(to.own, kStage, i, f);
    store(to.right, kStage, i, onRight);
    store(to.next, s, i, onNext);
  }
}

/// Own forces, what the neighbours passed on, gravity and drag; exactly 0 at pins and ghosts. Then the update.
template <class T, int families, Update update, bool drag>
void finishForces(const RowTask<T>& given, int row, std::ptrdiff_t begin, std::ptrdiff_t end) {
  const RowTask<T> task = given;
  const Staged<T> from = stagedOf(task, row, begin);
  const std::ptrdiff_t s = task.stride, plane = task.plane, start = row * s;
  const T *velocity = task.velocity + start, *isFree = task.isFree + start;
  constexpr bool kStores = update == Update::Store, kPredicts = update == Update::Leapfrog;
  T* const force = kStores ? task.force + start : nullptr;
  T* const x = kStores ? nullptr : task.moving + start;
  T* const v = kStores ? nullptr : task.kicked + start;
  T* const seen = kPredicts ? task.seen + start : nullptr;
  const Vec<T> weight{task.weight[0], task.weight[1], task.weight[2]};
  const T step = task.step, kick = task.kick;
  TYG_INDEPENDENT
  for (std::ptrdiff_t i = begin; i < end; ++i) {
    Vec<T> f = load(from.own, kStage, i);
    if constexpr ((families & (kStructural | kShear)) != 0) f = f + load(from.right, kStage, i - 1);
    if constexpr ((families & kShear) != 0) f = f - load(from.diagonal, s, i - 1);
    if constexpr ((families & kBend) != 0) f = f - load(from.right2, kStage, i - 2);
    f = isFree[i] * (f + weight);
    if constexpr (drag) f = f - (isFree[i] * task.drag) * load(velocity, plane, i);
    if constexpr (kStores) {
      store(force, plane, i, f);
    } else {
      Vec<T> w = load(v, plane, i) + kick * f;
      if constexpr (kPredicts) {
        w = w + kick * f;
        store(seen, plane, i, w + kick * f);
      }
      store(v, plane, i, w);
      store(x, plane, i, load(x, plane, i) + step * w);
    }
  }
}

/// One row in blocks. A block's last two places become the ones to the left of the next block.
template <class T>
void stageAndFinishRow(const RowTask<T>& task, int row, bool finish) {
  for (std::ptrdiff_t begin = 0; begin < task.width; begin += kBlock) {
    const std::ptrdiff_t end = begin + kBlock < task.width ? begin + kBlock : task.width;
    const Staged<T> block = stagedOf(task, row, 0);
    for (int axis = 0; axis < 3; ++axis) {
      for (std::ptrdiff_t i = axis * kStage - 2; i < axis * kStage; ++i) {
        block.right[i] = begin == 0 ? T(0) : block.right[i + kBlock];
        block.right2[i] = begin == 0 ? T(0) : block.right2[i + kBlock];
      }
    }
    task.stage(task, row, begin, end);
    if (finish) task.finish(task, row, begin, end);
  }
}

}  // namespace
}  // namespace tyg
