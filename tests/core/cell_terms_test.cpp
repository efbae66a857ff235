// The place in the row kernel for terms of whole cells, tried with a term that no scene has.
#include <gtest/gtest.h>

#include <array>

#include <algorithm>

#include "core/forces/row_energy.h"
#include "core/forces/row_forces.h"
#include "core/forces/state.h"
#include "test_systems.h"

namespace tyg::test {
namespace {

/// Pulls each corner of a cell by what all four corners sum up to, with another weight for each and for velocities.
struct CornerSum {
  static constexpr TermPlace kPlace = TermPlace::Cells;
  template <class T>
  using Numbers = Gravity::Numbers<T>;
  template <class T>
  static Vec<T> cornerForce(const LaneMath<T>& /*math*/, const Corners<Vec<T>>& x, const Corners<Vec<T>>& v,
                            const Numbers<T>& /*weight*/) {
    return (T(1) * x.here + T(2) * x.right) + (T(3) * x.below + T(4) * x.belowRight) + T(5) * (v.here + v.belowRight);
  }
};

std::vector<Vec3> expectedForces(const Bench<double>& bench) {
  const int columns = bench.sheet.columns;
  std::vector<Vec3> sum(std::size_t(bench.sheet.count()));
  const auto x = [&](int particle) { return bench.state.position.get(particle); };
  const auto v = [&](int particle) { return bench.state.velocity.get(particle); };
  for (int row = 0; row + 1 < bench.sheet.rows; ++row) {
    for (int column = 0; column + 1 < columns; ++column) {
      const int a = row * columns + column, b = a + 1, e = a + columns, f = e + 1;
      const Vec3 corner = x(a) + 2 * x(b) + 3 * x(e) + 4 * x(f) + 5 * (v(a) + v(f));
      for (const int particle : {a, b, e, f}) sum[std::size_t(particle)] = sum[std::size_t(particle)] + corner;
    }
  }
  return sum;
}

template <int families>
std::vector<Vec3> forcesByRows(const Bench<double>& bench) {
  const Layout& layout = bench.forces.layout();
  AlignedVector<double> hasRight(std::size_t(layout.stride)), hasRight2(hasRight.size());
  std::fill_n(hasRight.begin(), layout.columns - 1, 1.0);
  AlignedVector<double> scratch(rowScratchSize(layout.stride));
  VectorField<double> force(layout);
  RowTask<double> task;
  task.width = int(layout.stride) - Layout::kLanes, task.rows = layout.rows;
  task.stride = layout.stride, task.plane = layout.plane;
  task.position = bench.state.position.x(), task.velocity = bench.state.velocity.x(), task.force = force.x();
  task.hasRight = hasRight.data(), task.hasRight2 = hasRight2.data(), task.isFree = bench.forces.freeMask();
  task.scratch = scratch.data();
  task.finish = finishForces<double, Update::Store, TermList<>, false>;
  for (int row = 0; row < layout.rows; ++row) {
    accumulateRow<double, families, DampingTerm::None, TermList<CornerSum>, false>(task, row, true);
  }
  std::vector<Vec3> all;
  for (int i = 0; i < bench.sheet.count(); ++i) all.push_back(force.get(i));
  return all;
}

TEST(CellTerms, PullAllFourCornersOfEveryCell) {
  constexpr double kRounding = 1e-12;  // N: sums of up to sixteen numbers of up to some hundred
  for (const auto& [columns, rows] : {std::pair{2, 2}, {5, 4}, {33, 3}, {3, 17}}) {
    Bench<double> bench(emptyWorld(columns, rows));
    Numbers numbers(41);
    shake(bench, 0.3, numbers);
    const std::vector<Vec3> expected = expectedForces(bench);
    // With families of springs that have no stiffness: their places in the rows are used then too.
    for (const std::vector<Vec3>& found : {forcesByRows<0>(bench), forcesByRows<kStructural>(bench),
                                           forcesByRows<kShear>(bench), forcesByRows<7>(bench)}) {
      for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_LE(length(found[i] - expected[i]), kRounding * columns * rows) << i << " of " << columns << "x" << rows;
      }
    }
  }
}

TEST(CellTerms, SumAmountsOverEveryCellOnce) {
  constexpr double kRounding = 1e-12;  // of a sum of up to a hundred numbers near 1
  const auto amounts = [](const auto& x, const auto& v) {
    return std::array{(1.0 * x.here.x + 2.0 * x.right.y) + (3.0 * x.below.z + 4.0 * x.belowRight.x),
                      5.0 * (v.here.z * v.belowRight.y)};
  };
  for (const auto& [columns, rows] : {std::pair{1, 3}, {3, 1}, {2, 2}, {5, 4}, {8, 3}, {9, 3}, {17, 5}, {33, 3}}) {
    Bench<double> bench(emptyWorld(columns, rows));
    Numbers numbers(43);
    shake(bench, 0.3, numbers);
    const auto corners = [&, across = columns](const VectorField<double>& field, int a) {
      return Corners<Vec3>{field.get(a), field.get(a + 1), field.get(a + across), field.get(a + across + 1)};
    };
    EnergyRow<double> row;
    row.columns = columns, row.rows = rows;
    row.stride = bench.forces.layout().stride, row.plane = bench.forces.layout().plane;
    row.position = bench.state.position.x(), row.velocity = bench.state.velocity.x();
    std::array<double, 2> found{}, expected{};
    for (row.row = 0; row.row < rows; ++row.row) {
      const auto more = RowOfTerms<double>(row).sumsOverCells(amounts);
      found[0] += more[0], found[1] += more[1];
      for (int column = 0; column + 1 < columns && row.row + 1 < rows; ++column) {
        const int a = row.row * columns + column;
        const auto of = amounts(corners(bench.state.position, a), corners(bench.state.velocity, a));
        expected[0] += of[0], expected[1] += of[1];
      }
    }
    for (const std::size_t k : {0U, 1U}) {
      EXPECT_NEAR(found[k], expected[k], kRounding * columns * rows) << columns << "x" << rows;
    }
  }
}

}  // namespace
}  // namespace tyg::test
