// Strains of sheets whose springs are known.
#include "view/stretch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace tyg {
namespace {

constexpr double kRounding = 1e-6;  // positions are floats

Sheet smallSheet() {
  Sheet sheet;
  sheet.columns = 4, sheet.rows = 3, sheet.spacing = 0.5;
  return sheet;
}
std::vector<float> drawnOut(const Sheet& sheet, double across, double down) {
  std::vector<float> xyz;
  for (int particle = 0; particle < sheet.count(); ++particle) {
    const Vec3 at = sheet.startPosition(particle);
    xyz.insert(xyz.end(), {float(across * at.x), float(down * at.y), float(at.z)});
  }
  return xyz;
}

TEST(Stretch, OfASheetAtRestIsZero) {
  const Sheet sheet = smallSheet();
  for (const Family family : {Family::Structural, Family::Shear, Family::Bend}) {
    const Stretch stretch = stretchOf(sheet, drawnOut(sheet, 1, 1), family);
    EXPECT_NEAR(stretch.mean, 0, kRounding);
    EXPECT_NEAR(stretch.largest, 0, kRounding);
    EXPECT_NEAR(stretch.smallest, 0, kRounding);
  }
}

TEST(Stretch, TellsTheLargestTheSmallestAndTheMean) {
  const Sheet sheet = smallSheet();
  const Stretch stretch = stretchOf(sheet, drawnOut(sheet, 1.2, 0.9), Family::Structural);
  EXPECT_NEAR(stretch.largest, 0.2, kRounding);
  EXPECT_NEAR(stretch.smallest, -0.1, kRounding);
  EXPECT_NEAR(stretch.mean, (9 * 0.2 - 8 * 0.1) / 17, kRounding);  // 9 springs across, 8 down
  EXPECT_NEAR(stretch.rms, std::sqrt((9 * 0.04 + 8 * 0.01) / 17), kRounding);
}

TEST(Stretch, AgreesWithTheListedSprings) {
  const Sheet sheet = smallSheet();
  std::vector<float> xyz = drawnOut(sheet, 1, 1);
  for (std::size_t i = 0; i < xyz.size(); ++i) xyz[i] += 0.01F * float((7 * i) % 11);
  for (const Family family : {Family::Structural, Family::Shear, Family::Bend}) {
    double largest = -1;
    for (const SpringEnds& spring : springsOf(sheet, family)) {
      double square = 0;
      for (const std::size_t axis : {0, 1, 2}) {
        const double apart =
            double(xyz[3 * std::size_t(spring.first) + axis]) - double(xyz[3 * std::size_t(spring.second) + axis]);
        square += apart * apart;
      }
      largest = std::max(largest, std::sqrt(square) / restLength(sheet, family) - 1);
    }
    EXPECT_NEAR(stretchOf(sheet, xyz, family).largest, largest, kRounding);
  }
}

TEST(Stretch, OfAFamilyWithoutSpringsIsZero) {
  Sheet sheet;
  const std::array<float, 3> one{1, 2, 3};
  EXPECT_EQ(stretchOf(sheet, one, Family::Bend).largest, 0);
}

}  // namespace
}  // namespace tyg
