// Neighbours that move against each other get opposite signs.
#include "view/against_neighbours.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace tyg {
namespace {

TEST(AgainstNeighbours, ACheckerboardHasOppositeSignsAndAFlatSheetNone) {
  Sheet sheet;
  sheet.columns = 6, sheet.rows = 5, sheet.spacing = 0.1;
  std::vector<float> xyz, values(std::size_t(sheet.count()), 9);
  for (int i = 0; i < sheet.count(); ++i) {
    const Vec3 p = sheet.startPosition(i);
    xyz.insert(xyz.end(), {float(p.x), float(p.y), 0});
  }
  againstNeighbours(sheet, xyz, values);
  for (const float value : values) EXPECT_LT(std::abs(value), 1.001F);
  for (int i = 0; i < sheet.count(); ++i) {
    xyz[3 * std::size_t(i) + 2] = (i % 6 + i / 6) % 2 == 0 ? 0.02F : -0.02F;
  }
  againstNeighbours(sheet, xyz, values);
  for (int row = 1; row < 4; ++row) {
    for (int column = 1; column < 5; ++column) {
      const std::size_t i = std::size_t(6 * row + column);
      EXPECT_LT(values[i] * values[i - 1], 0) << column << " " << row;
      EXPECT_NEAR(std::abs(values[i]), 1, 1e-3);
    }
  }
  const std::vector<float> still(xyz.size(), 0.5F);
  againstNeighbours(sheet, still, values);
  for (const float value : values) EXPECT_EQ(value, 0);
}

}  // namespace
}  // namespace tyg
