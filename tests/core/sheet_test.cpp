// The sheet at rest: start shapes, names of particles, springs as pairs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "test_systems.h"
#include "tyg/sheet.h"

namespace tyg::test {
namespace {

/// Positions and the distance between them are rounded a few times.
constexpr double kRounding = 16 * std::numeric_limits<double>::epsilon();

Sheet sheetOf(int columns, int rows) { return {columns, rows, 0.1, 0.018, Start::Hanging, {}}; }

TEST(Sheet, HangsInTheXyPlaneCentredUnderRowZero) {
  const Sheet sheet = sheetOf(4, 3);
  EXPECT_EQ(sheet.startPosition(0), (Vec3{-1.5 * 0.1, 0, 0}));
  EXPECT_EQ(sheet.startPosition(3), (Vec3{1.5 * 0.1, 0, 0}));
  EXPECT_EQ(sheet.startPosition(9), (Vec3{-0.5 * 0.1, -2 * 0.1, 0}));
}

TEST(Sheet, LiesFlatInTheXzPlaneTowardsTheViewer) {
  Sheet sheet = sheetOf(4, 3);
  sheet.start = Start::Flat;
  EXPECT_EQ(sheet.startPosition(9), (Vec3{-0.5 * 0.1, 0, 2 * 0.1}));
}

TEST(Sheet, SizeIsTheLargerSide) {
  EXPECT_DOUBLE_EQ(sheetOf(4, 3).size(), 0.3);
  EXPECT_DOUBLE_EQ(sheetOf(4, 11).size(), 1.0);
  EXPECT_DOUBLE_EQ(sheetOf(1, 1).size(), 0.1);
}

TEST(Sheet, KnowsItsParticlesByNameAndByNumber) {
  const Sheet sheet = sheetOf(4, 3);
  const std::vector<std::pair<Place, int>> expected = {{{"top-left"}, 0},      {{"top-right"}, 3}, {{"bottom-left"}, 8},
                                                       {{"bottom-right"}, 11}, {{"middle"}, 6},    {{"", 0, 0}, 0},
                                                       {{"", 3, 0}, 3},        {{"", 1, 2}, 9}};
  for (const auto& [place, particle] : expected) {
    EXPECT_EQ(particleAt(sheet, place), particle) << place.name;
    EXPECT_EQ(particlesAt(sheet, place), std::vector<int>{particle}) << place.name;
  }
}

TEST(Sheet, KnowsItsSetsByName) {
  const Sheet sheet = sheetOf(4, 3);
  EXPECT_EQ(particlesAt(sheet, {"top"}), (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(particlesAt(sheet, {"left"}), (std::vector<int>{0, 4, 8}));
  EXPECT_EQ(particlesAt(sheet, {"corners"}), (std::vector<int>{0, 3, 8, 11}));
}

TEST(Sheet, RefusesSetsWhereOneParticleIsAskedFor) {
  for (const char* name : {"top", "left", "corners", "centre", "Middle"}) {
    EXPECT_THROW((void)particleAt(sheetOf(4, 3), {name}), InputError) << name;
  }
}

TEST(Sheet, RefusesPlacesOutsideAndSaysWhatIsInside) {
  for (const Place& place : {Place{"", 4, 0}, Place{"", 0, 3}, Place{"", -1, 0}, Place{"", 0, -1}}) {
    try {
      (void)particlesAt(sheetOf(4, 3), place);
      ADD_FAILURE() << "[" << place.column << ", " << place.row << "] was taken";
    } catch (const InputError& mistake) {
      EXPECT_NE(std::string(mistake.what()).find("columns 0 to 3 and rows 0 to 2"), std::string::npos)
          << mistake.what();
    }
  }
}

TEST(Sheet, ListsEachPinOnceInAscendingOrder) {
  Scene scene;
  scene.columns = 3, scene.rows = 2;
  scene.pins = {{"corners"}, {"top"}, {"", 0, 0}};
  EXPECT_EQ(makeSheet(scene).pins, (std::vector<int>{0, 1, 2, 3, 5}));
  scene.pins = {{"", 3, 0}};
  EXPECT_THROW((void)makeSheet(scene), InputError);
}

TEST(Sheet, OfOneParticleIsItsOwnCorners) {
  Scene scene;
  scene.pins = {{"corners"}, {"middle"}};
  EXPECT_EQ(makeSheet(scene).pins, std::vector<int>{0});
}

long long listed(const Sheet& sheet, Family family) { return static_cast<long long>(springsOf(sheet, family).size()); }

TEST(Springs, AreAsManyAsTheGridHasPairs) {
  for (const auto& [columns, rows] : {std::pair{1, 1}, {2, 1}, {1, 5}, {2, 2}, {3, 3}, {7, 4}, {20, 20}}) {
    const Sheet sheet = sheetOf(columns, rows);
    EXPECT_EQ(listed(sheet, Family::Structural), (columns - 1) * rows + columns * (rows - 1));
    EXPECT_EQ(listed(sheet, Family::Shear), 2 * (columns - 1) * (rows - 1));
    EXPECT_EQ(listed(sheet, Family::Bend), std::max(columns - 2, 0) * rows + columns * std::max(rows - 2, 0));
    for (const Family family : {Family::Structural, Family::Shear, Family::Bend}) {
      EXPECT_EQ(springCount(sheet, family), listed(sheet, family));
    }
  }
}

TEST(Springs, JoinEachPairOnce) {
  std::set<std::pair<int, int>> pairs;
  const Sheet sheet = sheetOf(6, 5);
  for (const Family family : {Family::Structural, Family::Shear, Family::Bend}) {
    for (const SpringEnds& spring : springsOf(sheet, family)) {
      EXPECT_TRUE(pairs.insert(std::minmax(spring.first, spring.second)).second) << spring.first << spring.second;
    }
  }
}

TEST(Springs, AreAtRestInBothStartShapes) {
  for (const Start start : {Start::Hanging, Start::Flat}) {
    Sheet sheet = sheetOf(6, 5);
    sheet.start = start;
    for (const Family family : {Family::Structural, Family::Shear, Family::Bend}) {
      for (const SpringEnds& spring : springsOf(sheet, family)) {
        const double apart = length(sheet.startPosition(spring.first) - sheet.startPosition(spring.second));
        EXPECT_NEAR(apart, restLength(sheet, family), kRounding);
      }
    }
  }
}

TEST(Springs, RestAtTheModelsLengths) {
  const Sheet sheet = sheetOf(6, 5);
  EXPECT_DOUBLE_EQ(restLength(sheet, Family::Structural), 0.1);
  EXPECT_DOUBLE_EQ(restLength(sheet, Family::Shear), 0.1414213562373095);
  EXPECT_DOUBLE_EQ(restLength(sheet, Family::Bend), 0.2);
}

TEST(Springs, OfTheLargestSheetAreCountedWithoutOverflow) {
  const Sheet sheet = sheetOf(kLargestCount, kLargestCount);
  EXPECT_EQ(springCount(sheet, Family::Structural), 2LL * 4095 * 4096);
  EXPECT_EQ(springCount(sheet, Family::Shear), 2LL * 4095 * 4095);
  EXPECT_EQ(springCount(sheet, Family::Bend), 2LL * 4094 * 4096);
}

}  // namespace
}  // namespace tyg::test
