// The sheet at rest: springs as pairs, rest lengths, names of particles, start shapes, pins.
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>

#include "test_systems.h"

namespace tyg::test {
namespace {

constexpr Family kFamilies[] = {Family::Structural, Family::Shear, Family::Bend};

struct Grid {
  int columns, rows;
};
constexpr Grid kGrids[] = {{1, 1}, {2, 1}, {1, 2}, {1, 7}, {2, 2}, {3, 2}, {2, 3}, {7, 5}, {20, 20}};

Sheet sheetOf(int columns, int rows) {
  Sheet sheet;
  sheet.columns = columns, sheet.rows = rows, sheet.spacing = 0.25;
  return sheet;
}

TEST(Sheet, HasAsManySpringsAsTheFormulasSay) {
  for (const auto& [c, r] : kGrids) {
    const Sheet sheet = sheetOf(c, r);
    const long long structural = (c - 1) * r + c * (r - 1), shear = 2 * (c - 1) * (r - 1);
    const long long bend = std::max(0, c - 2) * r + c * std::max(0, r - 2);
    EXPECT_EQ(springCount(sheet, Family::Structural), structural) << c << "x" << r;
    EXPECT_EQ(springCount(sheet, Family::Shear), shear) << c << "x" << r;
    EXPECT_EQ(springCount(sheet, Family::Bend), bend) << c << "x" << r;
  }
}

TEST(Sheet, ListsEverySpringOnce) {
  for (const auto& [columns, rows] : kGrids) {
    const Sheet sheet = sheetOf(columns, rows);
    std::set<std::pair<int, int>> seen;
    for (const Family family : kFamilies) {
      const std::vector<SpringEnds> springs = springsOf(sheet, family);
      EXPECT_EQ(static_cast<long long>(springs.size()), springCount(sheet, family)) << columns << "x" << rows;
      for (const SpringEnds& spring : springs) {
        const bool isNew = seen.insert(std::minmax(spring.first, spring.second)).second;
        EXPECT_TRUE(isNew) << spring.first << " and " << spring.second << " are joined twice";
      }
    }
  }
}

TEST(Sheet, CountsTheSpringsOfTheLargestWithoutOverflow) {
  const Sheet sheet = sheetOf(kLargestCount, kLargestCount);
  EXPECT_EQ(springCount(sheet, Family::Structural), 2LL * 4095 * 4096);
  EXPECT_EQ(springCount(sheet, Family::Shear), 2LL * 4095 * 4095);
  EXPECT_EQ(springCount(sheet, Family::Bend), 2LL * 4094 * 4096);
}

TEST(Sheet, StartsWithEverySpringAtItsRestLength) {
  constexpr double kRounding = 1e-14;  // m: differences of coordinates of a few metres
  for (const Start start : {Start::Hanging, Start::Flat}) {
    Sheet sheet = sheetOf(7, 5);
    sheet.start = start;
    EXPECT_EQ(restLength(sheet, Family::Structural), 0.25);
    EXPECT_EQ(restLength(sheet, Family::Shear), 0.25 * std::sqrt(2.0));
    EXPECT_EQ(restLength(sheet, Family::Bend), 0.5);
    for (const Family family : kFamilies) {
      for (const auto& [first, second] : springsOf(sheet, family)) {
        const double apart = length(sheet.startPosition(first) - sheet.startPosition(second));
        EXPECT_NEAR(apart, restLength(sheet, family), kRounding) << first << " to " << second;
      }
    }
  }
}

TEST(Sheet, HangsDownwardsFromHeightZeroAroundTheMiddle) {
  const Sheet sheet = sheetOf(4, 3);
  EXPECT_EQ(sheet.startPosition(0), (Vec3{-0.375, 0, 0}));
  EXPECT_EQ(sheet.startPosition(3), (Vec3{0.375, 0, 0}));
  EXPECT_EQ(sheet.startPosition(2 * 4 + 1), (Vec3{-0.125, -0.5, 0}));
  EXPECT_EQ(sheetOf(1, 3).startPosition(2), (Vec3{0, -0.5, 0}));
}

TEST(Sheet, LiesFlatTowardsTheViewerAtHeightZero) {
  Sheet sheet = sheetOf(4, 3);
  sheet.start = Start::Flat;
  EXPECT_EQ(sheet.startPosition(0), (Vec3{-0.375, 0, 0}));
  EXPECT_EQ(sheet.startPosition(2 * 4 + 1), (Vec3{-0.125, 0, 0.5}));
}

TEST(Sheet, HasTheSizeOfItsLargerSide) {
  EXPECT_EQ(sheetOf(9, 5).size(), 2.0);
  EXPECT_EQ(sheetOf(5, 9).size(), 2.0);
  EXPECT_EQ(sheetOf(1, 1).size(), 0.25);
}

TEST(Sheet, FindsParticlesByNameAndByColumnAndRow) {
  const Sheet sheet = sheetOf(6, 5);
  EXPECT_EQ(particleAt(sheet, {"top-left"}), 0);
  EXPECT_EQ(particleAt(sheet, {"top-right"}), 5);
  EXPECT_EQ(particleAt(sheet, {"bottom-left"}), 24);
  EXPECT_EQ(particleAt(sheet, {"bottom-right"}), 29);
  EXPECT_EQ(particleAt(sheet, {"middle"}), 2 * 6 + 3);
  EXPECT_EQ(particleAt(sheet, {"", 4, 1}), 10);
  EXPECT_EQ(particlesAt(sheet, {"", 4, 1}), std::vector<int>{10});
  EXPECT_EQ(particlesAt(sheet, {"middle"}), std::vector<int>{15});
  EXPECT_EQ(particleAt(sheetOf(1, 1), {"middle"}), 0);
}

TEST(Sheet, FindsSetsOfParticlesByName) {
  const Sheet sheet = sheetOf(3, 4);
  EXPECT_EQ(particlesAt(sheet, {"top"}), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(particlesAt(sheet, {"left"}), (std::vector<int>{0, 3, 6, 9}));
  EXPECT_EQ(particlesAt(sheet, {"corners"}), (std::vector<int>{0, 2, 9, 11}));
}

TEST(Sheet, RefusesPlacesThatItDoesNotHave) {
  const Sheet sheet = sheetOf(3, 4);
  for (const Place& place : {Place{"", 3, 0}, Place{"", 0, 4}, Place{"", -1, 0}, Place{"", 0, -1}, Place{"bottom"}}) {
    EXPECT_THROW(particleAt(sheet, place), InputError) << place.name << place.column << "," << place.row;
    EXPECT_THROW(particlesAt(sheet, place), InputError) << place.name << place.column << "," << place.row;
  }
  EXPECT_THROW(particleAt(sheet, {"top"}), InputError) << "a set is not one particle";
}

TEST(Sheet, HasItsPinsInOrderAndEachOnce) {
  Scene scene = emptyWorld(3, 4);
  scene.pins = {{"", 1, 2}, {"corners"}, {"left"}, {"top-left"}, {"", 1, 2}};
  EXPECT_EQ(makeSheet(scene).pins, (std::vector<int>{0, 2, 3, 6, 7, 9, 11}));
  scene.columns = scene.rows = 1;
  scene.pins = {{"corners"}};
  EXPECT_EQ(makeSheet(scene).pins, std::vector<int>{0});
}

TEST(Sheet, IsThatOfItsScene) {
  Scene scene = emptyWorld(3, 4);
  scene.spacing = 0.5, scene.particleMass = 0.02, scene.start = Start::Flat;
  const Sheet sheet = makeSheet(scene);
  EXPECT_EQ(sheet.columns, 3);
  EXPECT_EQ(sheet.rows, 4);
  EXPECT_EQ(sheet.count(), 12);
  EXPECT_EQ(sheet.spacing, 0.5);
  EXPECT_EQ(sheet.particleMass, 0.02);
  EXPECT_EQ(sheet.start, Start::Flat);
  EXPECT_TRUE(sheet.pins.empty());
  scene.pins = {{"", 3, 0}};
  EXPECT_THROW(makeSheet(scene), InputError);
}

}  // namespace
}  // namespace tyg::test
