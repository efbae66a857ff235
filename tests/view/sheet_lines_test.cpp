// A sheet as lines: which particles they join, and the arrow of a push.
#include "view/sheet_lines.h"

#include <gtest/gtest.h>

namespace tyg {
namespace {

Sheet sheetOf(int columns, int rows) {
  Sheet sheet;
  sheet.columns = columns, sheet.rows = rows;
  return sheet;
}

TEST(SheetLines, EachFamilyHasTwoIndicesPerSpring) {
  const Sheet sheet = sheetOf(5, 4);
  EXPECT_EQ(linesOf(sheet, Family::Structural).size(), 2U * (4 * 4 + 5 * 3));
  EXPECT_EQ(linesOf(sheet, Family::Shear).size(), 2U * (2 * 4 * 3));
  EXPECT_EQ(linesOf(sheet, Family::Bend).size(), 2U * (3 * 4 + 5 * 2));
}

TEST(SheetLines, ASingleParticleHasNone) {
  for (const Family family : {Family::Structural, Family::Shear, Family::Bend}) {
    EXPECT_TRUE(linesOf(sheetOf(1, 1), family).empty());
  }
}

TEST(SheetLines, TheGroundLiesBelowAHangingCloth) {
  Sheet sheet = sheetOf(20, 20);
  sheet.spacing = 0.1;
  EXPECT_LT(groundHeight(sheet), sheet.startPosition(sheet.count() - 1).y);
}

TEST(Arrow, RunsFromTheParticleAlongTheForce) {
  constexpr float kRounding = 1e-5F;  // single precision
  const glm::vec3 foot(1, 2, 3);
  for (const glm::vec3& force : {glm::vec3(0, 0, 2), glm::vec3(0, -5, 0), glm::vec3(1, 1, 1)}) {
    const auto points = arrowPoints(foot, force, 0.5F);
    EXPECT_EQ(points[0], foot);
    EXPECT_NEAR(glm::distance(points[1], foot + 0.5F * glm::normalize(force)), 0, kRounding);
  }
}

TEST(Arrow, IsVisibleFromBehind) {
  const auto points = arrowPoints(glm::vec3(0), glm::vec3(0, 0, 2), 1);
  for (int i = 2; i < kArrowPoints; ++i) {
    EXPECT_GT(glm::length(glm::vec2(points[static_cast<std::size_t>(i)])), 0.05F);
  }
}

TEST(Arrow, GrowsWithTheForceWithinTheSheetsMeasure) {
  Sheet sheet = sheetOf(11, 11);
  sheet.spacing = 0.1;
  EXPECT_LT(arrowLength(sheet, 1), arrowLength(sheet, 3));
  EXPECT_GE(arrowLength(sheet, 0), 0.0999F);
  EXPECT_LE(arrowLength(sheet, 1e9), 0.5001F);
}

}  // namespace
}  // namespace tyg
