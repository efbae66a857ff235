// The inner loops: forces of all springs, row by row, each spring once, and what a step does with them.
//
// Particle (i, row) owns six springs: right and down (structural), down-right and, for its right neighbour, down-left
// (shear), two to the right and two down (bend). `accumulateRow` computes them along the row, a vector of particles at
// a time. What springs do to particles further right stays in registers and is shifted into place for the next vector;
// what they do to the rows below is staged in a ring of rows. `finishForces` then adds gravity and the terms of single
// particles to a block of forces and stores the sum or moves the particles with it. Springs that are computed later
// neither act on these particles nor read where they are, so the particles may be moved in place. Terms of whole cells
// join the springs where these are gathered. Every number is computed by the same operations in the same order at every
// vector width, so every width gives the same bits. Included by row_kernel_level.cpp alone; everything here is private
// to one vector level.
#pragma once

#include <algorithm>
#include <cstring>
#include <utility>

#include "core/forces/row_kernel.h"

#define TYG_INLINE [[gnu::always_inline]] inline

namespace tyg {
namespace {

#if defined(__AVX512F__)
constexpr std::size_t kVectorBytes = 64;
#elif defined(__AVX2__)
constexpr std::size_t kVectorBytes = 32;
#else
constexpr std::size_t kVectorBytes = 16;
#endif

/// A vector register's worth of numbers, with the arithmetic operators of the compiler's own vector types.
template <class T>
struct LanesOf {
  using Type [[gnu::vector_size(kVectorBytes)]] = T;
};
template <class T>
using Lanes = typename LanesOf<T>::Type;
template <class T>
constexpr std::ptrdiff_t kLanes = kVectorBytes / sizeof(T);

template <class T>
TYG_INLINE Lanes<T> load(const T* from) {
  Lanes<T> lanes;
  std::memcpy(&lanes, from, kVectorBytes);
  return lanes;
}
template <class T>
TYG_INLINE void store(T* to, const Lanes<T>& lanes) {
  std::memcpy(to, &lanes, kVectorBytes);
}
TYG_INLINE float squareRoot(float a) { return __builtin_sqrtf(a); }
TYG_INLINE double squareRoot(double a) { return __builtin_sqrt(a); }
template <class T>
TYG_INLINE Lanes<T> squareRoots(const Lanes<T>& a) {
  Lanes<T> roots;
  for (std::ptrdiff_t lane = 0; lane < kLanes<T>; ++lane) roots[lane] = squareRoot(a[lane]);
  return roots;
}

/// A vector in space for each lane.
template <class T>
struct Vec {
  Lanes<T> x, y, z;
};
template <class T>
TYG_INLINE Vec<T> operator+(const Vec<T>& a, const Vec<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
TYG_INLINE Vec<T> operator-(const Vec<T>& a, const Vec<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T, class Factor>
TYG_INLINE Vec<T> operator*(const Factor& s, const Vec<T>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class T>
TYG_INLINE Lanes<T> dot(const Vec<T>& a, const Vec<T>& b) {
  return (a.x * b.x + a.y * b.y) + a.z * b.z;
}

template <class T>
TYG_INLINE Vec<T> load(const T* planes, std::ptrdiff_t plane, std::ptrdiff_t i) {
  return {load(planes + i), load(planes + plane + i), load(planes + 2 * plane + i)};
}
template <class T>
TYG_INLINE void store(T* planes, std::ptrdiff_t plane, std::ptrdiff_t i, const Vec<T>& a) {
  store(planes + i, a.x), store(planes + plane + i, a.y), store(planes + 2 * plane + i, a.z);
}

/// The last `distance` lanes of `before`, then the first ones of `here`: `here` moved to the right along the row.
template <std::size_t distance, class Register, std::size_t... lane>
TYG_INLINE Register shifted(const Register& before, const Register& here, std::index_sequence<lane...>) {
  return __builtin_shufflevector(before, here, (sizeof...(lane) - distance + lane)...);
}
template <std::size_t distance, class T>
TYG_INLINE Vec<T> shifted(const Vec<T>& before, const Vec<T>& here) {
  constexpr std::make_index_sequence<std::size_t(kLanes<T>)> kEach;
  return {shifted<distance>(before.x, here.x, kEach), shifted<distance>(before.y, here.y, kEach),
          shifted<distance>(before.z, here.z, kEach)};
}

/// Keeps 0 * infinity out of a spring of length 0; far below the rounding of any length that is not.
template <class T>
constexpr T kTiny = sizeof(T) == sizeof(float) ? T(1e-30F) : T(1e-300);

/// Force on the particles at `a` from the springs to those at `b` (model equation: spring part plus damping); `exists`
/// is 1 or 0.
template <DampingTerm damping, class T, class Exists>
TYG_INLINE Vec<T> springForce(const RowTask<T>& task, const SpringLaw<T>& law, const Exists& exists, std::ptrdiff_t a,
                              std::ptrdiff_t b) {
  const Vec<T> d = load(task.position, task.plane, b) - load(task.position, task.plane, a);
  const Lanes<T> inverseLength = T(1) / squareRoots<T>(dot(d, d) + kTiny<T>);
  Lanes<T> pull = law.ks - law.ksTimesRest * inverseLength;
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

/// Where a row's forces are staged, as pointers to planes; all within the task's scratch memory.
template <class T>
struct Staged {
  T* own;                                 ///< of a block: planes kBlock apart, by place less the block's begin
  T *taken, *takenNext, *takenAfterNext;  ///< by springs from above: from this row, the next, and the one after
  T *diagonal, *diagonalNext;  ///< on the particle down to the right of each, from the last row and from this one
};

template <class T>
TYG_INLINE Staged<T> stagedOf(const RowTask<T>& task, int row) {
  const std::ptrdiff_t size = 3 * task.stride;
  T* const ring = task.scratch + 3 * kBlock;
  T* const diagonals = ring + 3 * size;  // the padding before it stays 0: to the left of a row there is nothing
  return {task.scratch,
          ring + row % 3 * size,
          ring + (row + 1) % 3 * size,
          ring + (row + 2) % 3 * size,
          diagonals + row % 2 * size,
          diagonals + (row + 1) % 2 * size};
}

/// What a term knows of the sheet.
template <class Term, class T>
TYG_INLINE const typename Term::template Numbers<T>& numbersOf(const RowTask<T>& task) {
  return task;
}

/// Arithmetic for terms that see whole registers.
template <class T>
struct LaneMath {
  TYG_INLINE static Lanes<T> all(T number) { return number - Lanes<T>{}; }  // no arithmetic: plus 0 would change -0
  TYG_INLINE static Vec<T> all3(const T (&numbers)[3]) { return {all(numbers[0]), all(numbers[1]), all(numbers[2])}; }
  TYG_INLINE static Lanes<T> root(const Lanes<T>& a) { return squareRoots<T>(a); }
  TYG_INLINE static Lanes<T> size(const Lanes<T>& a) { return a < 0 ? -a : a; }
  /// The nearest whole number to one far below 1 / epsilon: what is left after adding a number of which only whole
  /// parts can be told apart.
  TYG_INLINE static Lanes<T> nearestWhole(const Lanes<T>& a) {
    constexpr T kWhole = sizeof(T) == sizeof(float) ? T(12582912) : T(6755399441055744);  // 1.5 / epsilon
    return (a + kWhole) - kWhole;
  }
  TYG_INLINE static Lanes<T> larger(const Lanes<T>& a, const Lanes<T>& b) { return a > b ? a : b; }
  TYG_INLINE static Lanes<T> smaller(const Lanes<T>& a, const Lanes<T>& b) { return a < b ? a : b; }
  TYG_INLINE static Lanes<T> signOf(const Lanes<T>& a) { return a < 0 ? all(-1) : all(1); }
  /// 1 where a >= b, else 0.
  TYG_INLINE static Lanes<T> atLeast(const Lanes<T>& a, const Lanes<T>& b) { return a >= b ? all(1) : all(0); }
  TYG_INLINE static Lanes<T> dot(const Vec<T>& a, const Vec<T>& b) { return (a.x * b.x + a.y * b.y) + a.z * b.z; }
  TYG_INLINE static Vec<T> cross(const Vec<T>& a, const Vec<T>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
};

template <class T>
TYG_INLINE Corners<Vec<T>> corners(const T* planes, const RowTask<T>& task, std::ptrdiff_t a, std::ptrdiff_t below) {
  return {load(planes, task.plane, a), load(planes, task.plane, a + 1), load(planes, task.plane, below),
          load(planes, task.plane, below + 1)};
}

/// Force of all cell terms on each corner of the cells below right of the particles at `a`. `below`, the particles
/// under them, is told as for springs, so that the compiler finds the same places there.
template <class CellTerms, class T, class Exists>
TYG_INLINE Vec<T> cellForce(const RowTask<T>& task, const Exists& exists, std::ptrdiff_t a, std::ptrdiff_t below) {
  Vec<T> sum{};
  const Corners<Vec<T>> x = corners(task.position, task, a, below), v = corners(task.velocity, task, a, below);
  CellTerms::forEach([&]<class Term>() { sum = sum + Term::cornerForce(LaneMath<T>{}, x, v, numbersOf<Term>(task)); });
  return exists * sum;
}

/// The springs of one row, six for each particle, and the terms of its cells, a block at a time; each block is finished
/// unless the row only feeds the rows below.
template <class T, int families, DampingTerm damping, class CellTerms, bool masked>
void accumulateRow(const RowTask<T>& given, int row, bool finish) {
  constexpr bool kCells = !CellTerms::kEmpty;
  const RowTask<T> task = given;  // on the stack, where no store can alias it
  const SpringLaw<T>&structural = numbersOf<StructuralSprings>(task).law, &shear = numbersOf<ShearSprings>(task).law,
        &bend = numbersOf<BendSprings>(task).law;
  const Staged<T> to = stagedOf(task, row);
  const std::ptrdiff_t s = task.stride;
  const T hasDown = T(row + 1 < task.rows), hasDown2 = T(row + 2 < task.rows);
  // 1 or 0 for each of a particle's springs and its cell; masks know what exists.
  const auto kept = [&](int mask, std::ptrdiff_t i, const auto& exists) {
    if constexpr (masked) {
      return load(task.there + mask * s + i);
    } else {
      return exists;
    }
  };
  Vec<T> rightBefore{}, right2Before{};  // what the vector before does to its right neighbours, one and two places on
  for (std::ptrdiff_t begin = 0; begin < task.width; begin += kBlock) {
    const std::ptrdiff_t end = begin + kBlock < task.width ? begin + kBlock : task.width;
    for (std::ptrdiff_t i = begin; i < end; i += kLanes<T>) {
      const std::ptrdiff_t a = row * s + i;
      [[maybe_unused]] Vec<T> corner{};
      Vec<T> across{}, down{}, downRight{}, downLeft{}, across2{}, down2{};
      if constexpr ((families & kStructural) != 0) {
        across = springForce<damping>(task, structural, kept(0, i, load(task.hasRight + i)), a, a + 1);
        down = springForce<damping>(task, structural, kept(1, i, hasDown), a, a + s);
      }
      if constexpr (kCells) {  // here, where few registers are in use; the diagonals serve the shear springs too
        corner = cellForce<CellTerms>(task, kept(6, i, hasDown * load(task.hasRight + i)), a, a + s);
      }
      if constexpr ((families & kShear) != 0) {
        const Lanes<T> exists = hasDown * load(task.hasRight + i);
        downRight = springForce<damping>(task, shear, kept(2, i, exists), a, a + s + 1);
        downLeft = springForce<damping>(task, shear, kept(3, i, exists), a + 1, a + s);
      }
      if constexpr ((families & kBend) != 0) {
        across2 = springForce<damping>(task, bend, kept(4, i, load(task.hasRight2 + i)), a, a + 2);
        down2 = springForce<damping>(task, bend, kept(5, i, hasDown2), a, a + 2 * s);
      }
      Vec<T> f = (((((across - load(to.taken, s, i)) + down) + downRight) + across2) + down2);
      Vec<T> onRight = downLeft - across;
      if constexpr (kCells) {
        f = f + corner, onRight = onRight + corner;
        down = down - corner, downRight = downRight - corner;
      }
      Vec<T> takenNext = down;
      if constexpr ((families & kBend) != 0) {
        takenNext = load(to.takenNext, s, i) + down;
        store(to.takenAfterNext, s, i, down2);
      }
      store(to.takenNext, s, i, takenNext + downLeft);
      if constexpr (kCells || (families & (kStructural | kShear)) != 0) f = f + shifted<1>(rightBefore, onRight);
      if constexpr (kCells || (families & kShear) != 0) {
        f = f - load(to.diagonal, s, i - 1);
        store(to.diagonalNext, s, i, downRight);
      }
      if constexpr ((families & kBend) != 0) f = f - shifted<2>(right2Before, across2);
      rightBefore = onRight, right2Before = across2;
      store(to.own, kBlock, i - begin, f);
    }
    if (!finish) continue;
    if (task.addToBlock != nullptr) task.addToBlock(task, row, begin, end);
    task.finish(task, row, begin, end);
  }
}

/// The smallest and the largest of some numbers.
template <class T>
struct Range {
  T low = 0, high = 0;
};

/// The lanes of the other half, of the other quarter of each half, and so on.
template <std::size_t half, class Register, std::size_t... lane>
TYG_INLINE Register halvesSwapped(const Register& a, std::index_sequence<lane...> /*lanes*/) {
  return __builtin_shufflevector(a, a, (lane ^ half)...);
}
template <class T, std::size_t half = std::size_t(kLanes<T>) / 2>
TYG_INLINE Range<T> rangeOf(const Lanes<T>& lows, const Lanes<T>& highs) {
  if constexpr (half == 0) {
    return {lows[0], highs[0]};
  } else {
    constexpr std::make_index_sequence<std::size_t(kLanes<T>)> kEach;
    const Lanes<T> low = halvesSwapped<half>(lows, kEach), high = halvesSwapped<half>(highs, kEach);
    return rangeOf<T, half / 2>(low < lows ? low : lows, high > highs ? high : highs);
  }
}

/// Of `count` numbers, at least one.
template <class T>
TYG_INLINE Range<T> rangeOf(const T* numbers, std::ptrdiff_t count) {
  Range<T> range{numbers[0], numbers[0]};
  std::ptrdiff_t i = 0;
  if (count >= kLanes<T>) {
    Lanes<T> lows = load(numbers), highs = lows;
    for (i = kLanes<T>; i + kLanes<T> <= count; i += kLanes<T>) {
      const Lanes<T> here = load(numbers + i);
      lows = here < lows ? here : lows, highs = here > highs ? here : highs;
    }
    range = rangeOf<T>(lows, highs);
  }
  for (; i < count; ++i) range = {std::min(range.low, numbers[i]), std::max(range.high, numbers[i])};
  return range;
}

/// Particles of one row whose forces are being summed up, as terms of blocks see them.
template <class T>
class BlockOfParticles {
 public:
  [[nodiscard]] static LaneMath<T> math() { return {}; }

  BlockOfParticles(const RowTask<T>& task, int row, std::ptrdiff_t begin, std::ptrdiff_t end)
      : position_(task.position + row * task.stride + begin),
        velocity_((task.blockVelocity != nullptr ? task.blockVelocity : task.velocity) + row * task.stride + begin),
        isFree_(task.isUnpinned + row * task.stride + begin),
        force_(task.scratch),
        plane_(task.plane),
        size_(end - begin),
        count_(std::min<std::ptrdiff_t>(size_, task.columns - begin)) {}

  /// Of the coordinates of all particles of the block along an axis, m.
  [[nodiscard]] TYG_INLINE Range<T> range(int axis) const { return rangeOf(position_ + axis * plane_, count_); }
  /// Adds what `force` says of the positions and the velocities of particles, and of whether they are free: 1, or 0 for
  /// pinned ones and for places without a particle.
  template <class Force>
  TYG_INLINE void add(const Force& force) const {
    for (std::ptrdiff_t i = 0; i < size_; i += kLanes<T>) {
      const Vec<T> more = force(load(position_, plane_, i), load(velocity_, plane_, i), load(isFree_ + i));
      store(force_, kBlock, i, load(force_, kBlock, i) + more);
    }
  }

 private:
  const T *position_, *velocity_, *isFree_;
  T* force_;
  std::ptrdiff_t plane_, size_, count_;
};

template <class T, class BlockTerms>
void addToBlock(const RowTask<T>& task, int row, std::ptrdiff_t begin, std::ptrdiff_t end) {
  const BlockOfParticles<T> block(task, row, begin, end);
  BlockTerms::forEach([&]<class Term>() { Term::addToBlock(block, numbersOf<Term>(task)); });
}

/// The pushes on these particles, which lie from column i on; the others' forces keep their bits.
template <class T>
TYG_INLINE void addPushes(const RowTask<T>& task, std::ptrdiff_t i, Vec<T>& f) {
  const PushedParticle<T>* push =
      std::ranges::lower_bound(task.firstPush, task.endPush, i, {}, &PushedParticle<T>::column);
  for (; push != task.endPush && push->column < i + kLanes<T>; ++push) {
    const std::ptrdiff_t lane = push->column - i;
    f.x[lane] += push->force[0], f.y[lane] += push->force[1], f.z[lane] += push->force[2];
  }
}

static_assert(
    AllTerms::count(TermPlace::Always) == 1,
    "finishForces() adds the weight of gravity and no other term of TermPlace::Always: add the new term there");

/// Adds gravity and the particles' terms to the springs' forces, exactly 0 at pins and padding. Then the update.
template <class T, Update update, class ParticleTerms, bool pushed>
void finishForces(const RowTask<T>& given, int row, std::ptrdiff_t begin, std::ptrdiff_t end) {
  const RowTask<T> task = given;
  const std::ptrdiff_t plane = task.plane, start = row * task.stride;
  const T *position = task.position + start, *velocity = task.velocity + start, *isFree = task.isFree + start;
  constexpr bool kStores = update == Update::Store, kPredicts = update == Update::Leapfrog;
  T* const force = kStores ? task.force + start : nullptr;
  T* const x = kStores ? nullptr : task.moving + start;
  T* const v = kStores ? nullptr : task.kicked + start;
  T* const seen = kPredicts ? task.seen + start : nullptr;
  const Lanes<T> zero{};
  const Vec<T> weight{zero + task.weight[0], zero + task.weight[1], zero + task.weight[2]};
  for (std::ptrdiff_t i = begin; i < end; i += kLanes<T>) {
    Vec<T> f = load(isFree + i) * (load(task.scratch, kBlock, i - begin) + weight);
    ParticleTerms::forEach([&]<class Term>() {
      f = Term::addTo(f, load(isFree + i), load(position, plane, i), load(velocity, plane, i), numbersOf<Term>(task));
    });
    if constexpr (pushed) addPushes(task, i, f);
    if constexpr (kStores) {
      store(force, plane, i, f);
    } else {
      Vec<T> w = load(v, plane, i) + task.kick * f;
      if constexpr (kPredicts) {
        w = w + task.kick * f;
        store(seen, plane, i, w + task.kick * f);
      }
      store(v, plane, i, w);
      store(x, plane, i, load(x, plane, i) + task.step * w);
    }
  }
}

}  // namespace
}  // namespace tyg
