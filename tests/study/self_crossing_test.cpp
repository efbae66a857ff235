// A sheet that passes through itself is found, and one that does not is not accused.
#include "study/motion/self_crossing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "test_systems.h"

namespace tyg::test {
namespace {

Sheet flatSheet(int columns, int rows) {
  Scene scene = emptyWorld(columns, rows);
  scene.start = Start::Flat;
  return makeSheet(scene);
}

/// The sheet with every particle moved by what `shape` makes of its column and row.
template <class Shape>
std::vector<Vec3> shaped(const Sheet& sheet, const Shape& shape) {
  std::vector<Vec3> at;
  for (int i = 0; i < sheet.count(); ++i) at.push_back(shape(i % sheet.columns, i / sheet.columns));
  return at;
}

TEST(SelfCrossing, IsNotFoundInFlatWavyAndFoldedSheets) {
  const Sheet sheet = flatSheet(20, 15);
  EXPECT_FALSE(firstCrossing(sheet, shaped(sheet, [](int c, int r) { return Vec3{1.0 * c, 0, 1.0 * r}; })));
  EXPECT_FALSE(firstCrossing(sheet, shaped(sheet, [](int c, int r) {
                               return Vec3{0.8 * c, std::sin(0.7 * c) + std::cos(0.5 * r), 0.9 * r};
                             })));
  // A spiral: layers lie a fifth of an edge apart.
  EXPECT_FALSE(firstCrossing(sheet, shaped(sheet, [](int c, int r) {
                               const double angle = 0.9 * c, radius = 1 + 0.2 * angle / 6.283;
                               return Vec3{radius * std::cos(angle), radius * std::sin(angle), 1.0 * r};
                             })));
  EXPECT_FALSE(firstCrossing(sheet, shaped(sheet, [](int, int) { return Vec3{}; })));
  EXPECT_FALSE(firstCrossing(flatSheet(1, 9), std::vector<Vec3>(9)));
}

TEST(SelfCrossing, IsFoundWithTheFirstCellsWhereOneCornerPokesThrough) {
  const Sheet sheet = flatSheet(12, 9);
  // Folded in the middle, half an edge above itself; then one particle is pushed through the lower layer.
  std::vector<Vec3> at = shaped(sheet, [](int c, int r) {
    return c < 6 ? Vec3{1.0 * c, 0, 1.0 * r} : Vec3{11.0 - c + 0.3, 0.5, r + 0.3};
  });
  EXPECT_FALSE(firstCrossing(sheet, at));
  const int through = 3 * 12 + 8;  // column 8, row 3, above column 3.3, row 3.3
  at[std::size_t(through)].y = -0.2;
  const auto found = firstCrossing(sheet, at);
  ASSERT_TRUE(found);
  // The first of the four cells around the particle, and the one that it passes through.
  EXPECT_EQ(found->column, 7);
  EXPECT_EQ(found->row, 2);
  EXPECT_EQ(found->otherColumn, 3);
  EXPECT_EQ(found->otherRow, 3);
}

/// Every edge against every triangle.
bool crossesAnywhere(const Sheet& sheet, const std::vector<Vec3>& at) {
  const auto side = [](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const Vec3 u = b - a, v = c - a, w = d - a;
    return dot({u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x}, w);
  };
  const auto p = [&](int column, int row) { return at[std::size_t(row * sheet.columns + column)]; };
  for (int r = 0; r + 1 < sheet.rows; ++r) {
    for (int c = 0; c + 1 < sheet.columns; ++c) {
      const Vec3 a = p(c, r), b = p(c + 1, r), e = p(c, r + 1), f = p(c + 1, r + 1);
      for (int s = 0; s + 1 < sheet.rows; ++s) {
        for (int d = 0; d + 1 < sheet.columns; ++d) {
          if (std::abs(c - d) <= 1 && std::abs(r - s) <= 1) continue;
          const Vec3 k = p(d, s), l = p(d + 1, s), m = p(d, s + 1), n = p(d + 1, s + 1);
          for (const auto& [from, to] : {std::pair{a, b}, {a, e}, {b, e}, {b, f}, {e, f}}) {
            for (const auto& [x, y, z] : {std::tuple{k, l, m}, {l, n, m}}) {
              if (side(x, y, z, from) * side(x, y, z, to) >= 0) continue;
              const double xy = side(from, to, x, y), yz = side(from, to, y, z), zx = side(from, to, z, x);
              if ((xy > 0 && yz > 0 && zx > 0) || (xy < 0 && yz < 0 && zx < 0)) return true;
            }
          }
        }
      }
    }
  }
  return false;
}

TEST(SelfCrossing, IsFoundWhereComparingEveryPairFindsIt) {
  Numbers numbers(7);
  int crossing = 0;
  for (int draw = 0; draw < 200; ++draw) {
    const Sheet sheet = flatSheet(3 + draw % 6, 3 + draw % 5);
    const double rough = numbers.between(0.1, 1.2), curl = numbers.between(0, 1);
    std::vector<Vec3> at = shaped(sheet, [&](int c, int r) {
      return Vec3{std::cos(curl * c) * 2, std::sin(curl * c) * 2, 1.0 * r};
    });
    for (Vec3& each : at) each = each + numbers.inCube(rough);
    const bool expected = crossesAnywhere(sheet, at);
    EXPECT_EQ(firstCrossing(sheet, at).has_value(), expected) << draw;
    crossing += expected ? 1 : 0;
  }
  EXPECT_GT(crossing, 20);
  EXPECT_LT(crossing, 180);
}

TEST(SelfCrossing, SurvivesNumbersThatAreNone) {
  const Sheet sheet = flatSheet(6, 6);
  std::vector<Vec3> at = shaped(sheet, [](int c, int r) { return Vec3{1.0 * c, 0, 1.0 * r}; });
  at[7].x = NAN, at[20].z = INFINITY, at[30].y = 1e300;
  EXPECT_FALSE(firstCrossing(sheet, at));
}

}  // namespace
}  // namespace tyg::test
