// See chebyshev.h.
#include "integrators/chebyshev.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "integrators/chebyshev_table.h"

namespace tyg {
namespace {

using Complex = std::complex<double>;

Complex growthOf(const ChebyshevTable& table, int s, const Complex& z) {
  const Complex x = table.w0 + table.w1 * z;
  Complex before = 1, now = x;  // T_0, T_1 by the three-term recurrence
  for (int j = 2; j <= s; ++j) {
    const Complex next = 2.0 * x * now - before;
    before = now;
    now = next;
  }
  const double b = table.b[std::size_t(s)];
  return 1 - b * table.value[std::size_t(s)] + b * now;
}

/// The distinct fast ends of the spectrum: conjugate roots grow alike.
std::vector<Complex> rootsOf(std::span<const Mode> modes) {
  std::vector<Complex> roots;
  for (const Mode& mode : modes) {
    const double discriminant = mode.d * mode.d - 4 * mode.w2;
    if (discriminant < 0) {
      roots.emplace_back(-mode.d / 2, std::sqrt(-discriminant) / 2);
    } else {
      const double fast = -(mode.d + std::sqrt(discriminant)) / 2;
      roots.emplace_back(fast, 0);
      if (fast < 0) roots.emplace_back(mode.w2 / fast, 0);
    }
  }
  return roots;
}

}  // namespace

ChebyshevTable::ChebyshevTable(int s) : b(std::size_t(s) + 1), value(std::size_t(s) + 1) {
  constexpr double kEps = 2.0 / 13;
  w0 = 1 + kEps / (double(s) * s);
  // T_j, T'_j, T''_j at w0 by differentiating the recurrence T_j = 2 x T_(j-1) - T_(j-2).
  double t0 = 1, t1 = w0, d0 = 0, d1 = 1, e0 = 0, e1 = 0;
  value[0] = t0, value[1] = t1;
  for (int j = 2; j <= s; ++j) {
    const double t = 2 * w0 * t1 - t0, d = 2 * t1 + 2 * w0 * d1 - d0, e = 4 * d1 + 2 * w0 * e1 - e0;
    t0 = t1, t1 = t, d0 = d1, d1 = d, e0 = e1, e1 = e;
    value[std::size_t(j)] = t;
    b[std::size_t(j)] = e / (d * d);
  }
  b[0] = b[1] = b[2];
  w1 = d1 / e1;
}

Complex chebyshevGrowth(int stages, Complex z) { return growthOf(ChebyshevTable(stages), stages, z); }

int chebyshevStages(std::span<const Mode> modes, double h) {
  constexpr double kRounding = 1e-10;
  std::vector<Complex> roots = rootsOf(modes);
  for (int s = 2; s <= kMostChebyshevStages; ++s) {
    const ChebyshevTable table(s);
    const auto growing = std::ranges::find_if(
        roots, [&](const Complex& mu) { return std::abs(growthOf(table, s, h * mu)) > 1 + kRounding; });
    if (growing == roots.end()) return s;
    std::swap(roots.front(), *growing);  // the next number of stages most likely fails here too
  }
  return 0;
}

}  // namespace tyg
