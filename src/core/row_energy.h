// Energies and damping power of one row, summed in one fixed order whatever the vector width: eight running sums,
// particle by particle, added pairwise at the end. In double also for float states: sums of many small terms decide the
// alarm. Included by row_kernel_level.cpp alone; everything here is private to one vector level.
#pragma once

#include "core/row_kernel.h"

namespace tyg {
namespace {

constexpr int kSums = 8;

inline double addPairwise(const double (&s)[kSums]) {
  return ((s[0] + s[1]) + (s[2] + s[3])) + ((s[4] + s[5]) + (s[6] + s[7]));
}
inline double larger(double a, double b) { return a > b ? a : b; }

struct Difference {
  double x, y, z;
};
template <class T>
[[gnu::always_inline]] inline Difference difference(const T* planes, std::ptrdiff_t plane, std::ptrdiff_t a,
                                                    std::ptrdiff_t b) {
  return {double(planes[b]) - double(planes[a]), double(planes[plane + b]) - double(planes[plane + a]),
          double(planes[2 * plane + b]) - double(planes[2 * plane + a])};
}
[[gnu::always_inline]] inline double squared(const Difference& d) { return (d.x * d.x + d.y * d.y) + d.z * d.z; }

/// Calls `spring(family, a, b, n, step)` for the runs of springs that start in this row: n springs from a+k to b+k.
template <class T, class Visit>
[[gnu::always_inline]] inline void forSpringRuns(const EnergyRow<T>& in, const Visit& visit) {
  const std::ptrdiff_t s = in.stride, a = in.row * s;
  const int n = in.columns;
  const bool down = in.row + 1 < in.rows, down2 = in.row + 2 < in.rows;
  visit(in.families[0], a, a + 1, n - 1);
  if (down) visit(in.families[0], a, a + s, n);
  if (down) visit(in.families[1], a, a + s + 1, n - 1);
  if (down) visit(in.families[1], a + 1, a + s, n - 1);
  visit(in.families[2], a, a + 2, n - 2);
  if (down2) visit(in.families[2], a, a + 2 * s, n);
}

/// Sums term(k) over k < n in the fixed order.
template <class Term>
[[gnu::always_inline]] inline double sumOf(int n, const Term& term) {
  double sums[kSums] = {};
  int k = 0;
  for (; k + kSums <= n; k += kSums) {
    for (int lane = 0; lane < kSums; ++lane) sums[lane] += term(k + lane);
  }
  for (int lane = 0; k < n; ++k, ++lane) sums[lane] += term(k);
  return addPairwise(sums);
}

/// Elastic energy of a run, and the largest stretch beside it.
template <class T>
double elasticOfRun(const EnergyRow<T>& in, const typename EnergyRow<T>::Family& family, std::ptrdiff_t a,
                    std::ptrdiff_t b, int n, double& maxStretch) {
  double stretch[kSums] = {};
  const double energy = sumOf(n, [&](int k) {
    const double elongation = __builtin_sqrt(squared(difference(in.position, in.plane, a + k, b + k))) - family.rest;
    stretch[k % kSums] = larger(elongation, stretch[k % kSums]);
    return 0.5 * family.ks * elongation * elongation;
  });
  for (const double elongation : stretch) maxStretch = larger(elongation / family.rest, maxStretch);
  return energy;
}

template <class T>
RowEnergy energyOfRow(const EnergyRow<T>& given) {
  const EnergyRow<T> in = given;
  RowEnergy sum;
  const std::ptrdiff_t start = in.row * in.stride, plane = in.plane;
  const T *x = in.position + start, *v = in.velocity + start;
  sum.kinetic = 0.5 * sumOf(in.columns, [=](int k) {
                  return squared({double(v[k]), double(v[plane + k]), double(v[2 * plane + k])});
                });
  sum.fallen = sumOf(in.columns, [&](int k) {
    return (in.weight[0] * double(x[k]) + in.weight[1] * double(x[plane + k])) +
           in.weight[2] * double(x[2 * plane + k]);
  });
  forSpringRuns(in, [&](const typename EnergyRow<T>::Family& family, std::ptrdiff_t a, std::ptrdiff_t b, int n) {
    if (family.ks > 0 || family.kd > 0) sum.elastic += elasticOfRun(in, family, a, b, n, sum.maxStretch);
  });
  return sum;
}

/// Power that the springs' damping and the drag take: sum of kd |dv|^2 (axial: its part along the spring) + drag |v|^2.
template <class T>
RowEnergy powerOfRow(const EnergyRow<T>& given) {
  const EnergyRow<T> in = given;
  RowEnergy sum;
  const std::ptrdiff_t start = in.row * in.stride, plane = in.plane;
  const T* v = in.velocity + start;
  if (in.drag > 0) {
    sum.power = in.drag * sumOf(in.columns, [=](int k) {
                  return squared({double(v[k]), double(v[plane + k]), double(v[2 * plane + k])});
                });
  }
  forSpringRuns(in, [&](const typename EnergyRow<T>::Family& family, std::ptrdiff_t a, std::ptrdiff_t b, int n) {
    if (family.kd <= 0) return;
    sum.power += family.kd * sumOf(n, [&](int k) {
                   const Difference dv = difference(in.velocity, plane, a + k, b + k);
                   if (!in.axial) return squared(dv);
                   const Difference d = difference(in.position, plane, a + k, b + k);
                   const double along = (dv.x * d.x + dv.y * d.y) + dv.z * d.z;
                   return along * along / (squared(d) + 1e-300);
                 });
  });
  return sum;
}

}  // namespace
}  // namespace tyg
