// Stored energies and damping power of one row, summed in one fixed order whatever the vector width: eight running
// sums, particle by particle, added pairwise at the end. In double also for float states: sums of many small terms
// decide the alarm. Included by row_kernel_level.cpp alone; everything here is private to one vector level.
#pragma once

#include <array>

#include "core/forces/row_forces.h"

namespace tyg {
namespace {

constexpr int kSums = 8;
constexpr int kOfPart = int(kLanes<double>), kParts = kSums / kOfPart;

/// Eight numbers in as many registers as they need.
struct Eight {
  Lanes<double> part[kParts] = {};

  TYG_INLINE double operator[](int k) const { return part[k / kOfPart][k % kOfPart]; }
  /// 0 for all but the first `count`, of which there are 0 to 8.
  TYG_INLINE void keepFirst(int count) {
    for (int k = count; k < kSums; ++k) part[k / kOfPart][k % kOfPart] = 0;
  }
};
template <class Operation>
TYG_INLINE Eight partByPart(const Operation& operation) {
  Eight result;
  for (int k = 0; k < kParts; ++k) result.part[k] = operation(k);
  return result;
}
TYG_INLINE Eight operator+(const Eight& a, const Eight& b) {
  return partByPart([&](int k) { return a.part[k] + b.part[k]; });
}
TYG_INLINE Eight operator-(const Eight& a, const Eight& b) {
  return partByPart([&](int k) { return a.part[k] - b.part[k]; });
}
TYG_INLINE Eight operator*(const Eight& a, const Eight& b) {
  return partByPart([&](int k) { return a.part[k] * b.part[k]; });
}
TYG_INLINE Eight operator/(const Eight& a, const Eight& b) {
  return partByPart([&](int k) { return a.part[k] / b.part[k]; });
}
TYG_INLINE Eight operator*(double a, const Eight& b) {
  return partByPart([&](int k) { return a * b.part[k]; });
}
TYG_INLINE Eight operator-(const Eight& a) {
  return partByPart([&](int k) { return -a.part[k]; });
}
TYG_INLINE Eight smaller(const Eight& a, const Eight& b) {
  return partByPart([&](int k) { return a.part[k] < b.part[k] ? a.part[k] : b.part[k]; });
}
TYG_INLINE Eight larger(const Eight& a, const Eight& b) {
  return partByPart([&](int k) { return a.part[k] > b.part[k] ? a.part[k] : b.part[k]; });
}
TYG_INLINE Eight squareRoots(const Eight& a) {
  return partByPart([&](int k) { return squareRoots<double>(a.part[k]); });
}
TYG_INLINE double addPairwise(const Eight& s) {
  return ((s[0] + s[1]) + (s[2] + s[3])) + ((s[4] + s[5]) + (s[6] + s[7]));
}
template <class T>
TYG_INLINE Eight eightOf(const T* from) {
  using Numbers [[gnu::vector_size(kOfPart * sizeof(T))]] = T;
  return partByPart([&](int k) {
    Numbers numbers;
    std::memcpy(&numbers, from + k * kOfPart, sizeof numbers);
    return __builtin_convertvector(numbers, Lanes<double>);
  });
}

/// Three components of eight particles, or of eight springs.
struct EightVectors {
  Eight x, y, z;
};
template <class T>
TYG_INLINE EightVectors eightVectors(const T* planes, std::ptrdiff_t plane) {
  return {eightOf(planes), eightOf(planes + plane), eightOf(planes + 2 * plane)};
}
template <class T>
TYG_INLINE EightVectors differences(const T* planes, std::ptrdiff_t plane, std::ptrdiff_t a, std::ptrdiff_t b) {
  const EightVectors to = eightVectors(planes + b, plane), from = eightVectors(planes + a, plane);
  return {to.x - from.x, to.y - from.y, to.z - from.z};
}
TYG_INLINE EightVectors operator+(const EightVectors& a, const EightVectors& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
TYG_INLINE EightVectors operator-(const EightVectors& a, const EightVectors& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
TYG_INLINE EightVectors operator*(const Eight& s, const EightVectors& a) { return {s * a.x, s * a.y, s * a.z}; }
TYG_INLINE Eight dotOf(const EightVectors& a, const EightVectors& b) { return (a.x * b.x + a.y * b.y) + a.z * b.z; }

/// Arithmetic for terms, as LaneMath has it.
struct EightMath {
  TYG_INLINE static Eight all(double number) {
    return partByPart([&](int) { return Lanes<double>{} + number; });
  }
  TYG_INLINE static EightVectors all3(const double (&numbers)[3]) {
    return {all(numbers[0]), all(numbers[1]), all(numbers[2])};
  }
  TYG_INLINE static Eight root(const Eight& a) { return squareRoots(a); }
  TYG_INLINE static Eight size(const Eight& a) { return larger(a, -a); }
  TYG_INLINE static Eight nearestWhole(const Eight& a) {
    return partByPart([&](int k) { return LaneMath<double>::nearestWhole(a.part[k]); });
  }
  TYG_INLINE static Eight larger(const Eight& a, const Eight& b) { return tyg::larger(a, b); }
  TYG_INLINE static Eight smaller(const Eight& a, const Eight& b) { return tyg::smaller(a, b); }
  TYG_INLINE static Eight signOf(const Eight& a) {
    return partByPart([&](int k) { return LaneMath<double>::signOf(a.part[k]); });
  }
  TYG_INLINE static Eight atLeast(const Eight& a, const Eight& b) {
    return partByPart([&](int k) { return LaneMath<double>::atLeast(a.part[k], b.part[k]); });
  }
  TYG_INLINE static Eight dot(const EightVectors& a, const EightVectors& b) { return dotOf(a, b); }
  TYG_INLINE static EightVectors cross(const EightVectors& a, const EightVectors& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
};

/// Calls `visit(law, a, b, n)` for the runs of springs that start in this row: n springs from a+k to b+k.
template <class T, class Visit>
TYG_INLINE void forSpringRuns(const EnergyRow<T>& in, const Visit& visit) {
  const std::ptrdiff_t s = in.stride, a = in.row * s;
  const int n = in.columns;
  const bool down = in.row + 1 < in.rows, down2 = in.row + 2 < in.rows;
  const SpringLaw<double>&structural = in.StructuralSprings::template Numbers<double>::law,
        &shear = in.ShearSprings::template Numbers<double>::law, &bend = in.BendSprings::template Numbers<double>::law;
  visit(structural, a, a + 1, n - 1);
  if (down) visit(structural, a, a + s, n);
  if (down) visit(shear, a, a + s + 1, n - 1);
  if (down) visit(shear, a + 1, a + s, n - 1);
  visit(bend, a, a + 2, n - 2);
  if (down2) visit(bend, a, a + 2 * s, n);
}

/// Sums over k < n in the fixed order; `term(k)` gives the terms of k to k + 7. Those past n are not counted: they come
/// from the padding, of which every row has more than eight.
template <class Term>
TYG_INLINE double sumOf(int n, const Term& term) {
  Eight sums;
  int k = 0;
  for (; k + kSums <= n; k += kSums) sums = sums + term(k);
  if (k < n) {
    Eight last = term(k);
    last.keepFirst(n - k);
    sums = sums + last;
  }
  return addPairwise(sums);
}

/// Two such sums in one pass.
template <class Terms>
TYG_INLINE std::array<double, 2> sumsOf(int n, const Terms& terms) {
  Eight first, second;
  int k = 0;
  for (; k + kSums <= n; k += kSums) {
    const auto [a, b] = terms(k);
    first = first + a, second = second + b;
  }
  if (k < n) {
    auto [a, b] = terms(k);
    a.keepFirst(n - k), b.keepFirst(n - k);
    first = first + a, second = second + b;
  }
  return {addPairwise(first), addPairwise(second)};
}

/// Elastic energy of a run, and the largest stretch beside it.
template <class T>
double elasticOfRun(const EnergyRow<T>& in, const SpringLaw<double>& law, std::ptrdiff_t a, std::ptrdiff_t b, int n,
                    double& maxStretch) {
  const Eight rest = partByPart([&](int) { return Lanes<double>{} + law.rest; });
  Eight longest;
  const double energy = sumOf(n, [&](int k) {
    const EightVectors d = differences(in.position, in.plane, a + k, b + k);
    Eight elongation = squareRoots(dotOf(d, d)) - rest;
    if (k + kSums > n) elongation.keepFirst(n - k);
    longest = larger(elongation, longest);
    return 0.5 * law.ks * elongation * elongation;
  });
  for (int k = 0; k < kSums; ++k) {
    if (longest[k] / law.rest > maxStretch) maxStretch = longest[k] / law.rest;
  }
  return energy;
}

/// The particles of one row and the cells below it, as terms see them.
template <class T>
class RowOfTerms {
 public:
  using Vector = EightVectors;
  [[nodiscard]] static EightMath math() { return {}; }

  explicit RowOfTerms(const EnergyRow<T>& in)
      : position_(in.position + in.row * in.stride),
        velocity_(in.velocity + in.row * in.stride),
        isUnpinned_(in.isUnpinned + in.row * in.stride),
        stride_(in.stride),
        plane_(in.plane),
        columns_(in.columns),
        hasRowBelow_(in.row + 1 < in.rows) {}

  /// Of the coordinates of the particles along an axis, m.
  [[nodiscard]] Range<T> range(int axis) const { return rangeOf(position_ + axis * plane_, columns_); }
  /// Sum of what `amount` says of the position and the velocity of each particle.
  template <class Amount>
  [[nodiscard]] TYG_INLINE double sumOverParticles(const Amount& amount) const {
    return sumOf(columns_, [&](int k) {
      return amount(eightVectors(position_ + k, plane_), eightVectors(velocity_ + k, plane_));
    });
  }
  /// The same with 0 for a pinned particle and 1 for others as a third argument, one amount or two of them at once.
  template <class Amount>
  [[nodiscard]] TYG_INLINE double sumOverFree(const Amount& amount) const {
    return sumOf(columns_, [&](int k) { return amountAt(amount, k); });
  }
  template <class Amounts>
  [[nodiscard]] TYG_INLINE std::array<double, 2> sumsOverFree(const Amounts& amounts) const {
    return sumsOf(columns_, [&](int k) { return amountAt(amounts, k); });
  }
  /// Sums of the two numbers that `amounts` says of the positions and the velocities of the corners of each cell below
  /// the row.
  template <class Amounts>
  [[nodiscard]] TYG_INLINE std::array<double, 2> sumsOverCells(const Amounts& amounts) const {
    if (!hasRowBelow_) return {};
    return sumsOf(columns_ - 1, [&](int k) { return amounts(cornersAt(position_ + k), cornersAt(velocity_ + k)); });
  }

 private:
  template <class Amount>
  [[nodiscard]] TYG_INLINE auto amountAt(const Amount& amount, int k) const {
    return amount(eightVectors(position_ + k, plane_), eightVectors(velocity_ + k, plane_), eightOf(isUnpinned_ + k));
  }
  [[nodiscard]] TYG_INLINE Corners<EightVectors> cornersAt(const T* planes) const {
    return {eightVectors(planes, plane_), eightVectors(planes + 1, plane_), eightVectors(planes + stride_, plane_),
            eightVectors(planes + stride_ + 1, plane_)};
  }

  const T *position_, *velocity_, *isUnpinned_;
  std::ptrdiff_t stride_, plane_;
  int columns_;
  bool hasRowBelow_;
};

template <class Term, class T>
TYG_INLINE const typename Term::template Numbers<double>& numbersOf(const EnergyRow<T>& in) {
  return in;
}

template <class T>
StoredEnergy energyOfRow(const EnergyRow<T>& given) {
  const EnergyRow<T> in = given;
  const RowOfTerms<T> row(in);
  StoredEnergy sum;
  sum.kinetic = 0.5 * row.sumOverParticles([](const EightVectors&, const EightVectors& v) { return dotOf(v, v); });
  AllTerms::forEach([&]<class Term>() {
    if constexpr (requires { Term::template storedIn<RowOfTerms<T>>; }) {
      sum.template of<Term>() += Term::storedIn(row, numbersOf<Term>(in));
    }
  });
  double& elastic = sum.of<StructuralSprings>();
  forSpringRuns(in, [&](const SpringLaw<double>& law, std::ptrdiff_t a, std::ptrdiff_t b, int n) {
    if (law.ks > 0 || law.kd > 0) elastic += elasticOfRun(in, law, a, b, n, sum.maxStretch);
  });
  return sum;
}

/// Power that the terms bring, and that they and the springs' damping take: kd |dv|^2 of every spring (axial: its part
/// along the spring).
template <class T>
Power powerOfRow(const EnergyRow<T>& given) {
  const EnergyRow<T> in = given;
  const RowOfTerms<T> row(in);
  Power power;
  double sum = 0;
  std::size_t supply = 0;
  AllTerms::forEach([&]<class Term>() {
    if constexpr (requires { Term::kSupply; }) {
      const auto [lost, supplied] = Term::powersIn(row, numbersOf<Term>(in));
      sum += lost;
      power.supplied[supply++] = supplied;
    } else if constexpr (requires { Term::template powerIn<RowOfTerms<T>>; }) {
      sum += Term::powerIn(row, numbersOf<Term>(in));
    }
  });
  const Eight tiny = partByPart([](int) { return Lanes<double>{} + 1e-300; });
  forSpringRuns(in, [&](const SpringLaw<double>& law, std::ptrdiff_t a, std::ptrdiff_t b, int n) {
    if (law.kd <= 0) return;
    sum += law.kd * sumOf(n, [&](int k) {
             const EightVectors dv = differences(in.velocity, in.plane, a + k, b + k);
             if (!in.axial) return dotOf(dv, dv);
             const EightVectors d = differences(in.position, in.plane, a + k, b + k);
             const Eight along = dotOf(dv, d);
             return along * along / (dotOf(d, d) + tiny);
           });
  });
  power.lost = sum;
  return power;
}

}  // namespace
}  // namespace tyg
