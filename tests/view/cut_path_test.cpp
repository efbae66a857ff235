// Cuts along a line on the screen, on cloth whose places in the window are known.
#include "view/cut_path.h"

#include <gtest/gtest.h>

#include <cmath>

#include "view/picking.h"

namespace tyg {
namespace {

constexpr glm::vec2 kWindow{800, 600};

/// Sheet in the plane z = 0, seen from the front.
class CutPathTest : public testing::Test {
 protected:
  void make(int columns, int rows) {
    sheet_ = {.columns = columns, .rows = rows, .spacing = 0.1, .pins = {}};
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) xyz_.insert(xyz_.end(), {0.1F * column, -0.1F * row, 0});
    }
    camera_.lookAlong(0, 0);
    camera_.frame(boxAround(xyz_), kWindow.x / kWindow.y);
  }
  /// Of grid coordinates, which may lie outside.
  [[nodiscard]] glm::vec2 place(float column, float row) const {
    return placeInWindow(camera_, {0.1F * column, -0.1F * row, 0}, kWindow);
  }
  [[nodiscard]] std::vector<CutLine> cut(glm::vec2 from, glm::vec2 to) const {
    return cutsAlong(camera_, from, to, kWindow, sheet_, xyz_);
  }

  Sheet sheet_;
  std::vector<float> xyz_;
  Camera camera_;
};

TEST_F(CutPathTest, ADragOnTheClothCutsFromItsBeginningToItsEnd) {
  make(11, 9);
  const auto cuts = cut(place(2.3F, 1.2F), place(7.6F, 6.4F));
  ASSERT_EQ(cuts.size(), 1U);
  constexpr double kPixel = 0.05;  // in cells
  EXPECT_NEAR(cuts[0].fromColumn, 2.3, kPixel);
  EXPECT_NEAR(cuts[0].fromRow, 1.2, kPixel);
  EXPECT_NEAR(cuts[0].toColumn, 7.6, kPixel);
  EXPECT_NEAR(cuts[0].toRow, 6.4, kPixel);
}

TEST_F(CutPathTest, ADragFromOutsideToOutsideGoesPastBothEdges) {
  make(11, 9);
  const auto cuts = cut(place(-3, 4.5F), place(14, 4.5F));
  ASSERT_EQ(cuts.size(), 1U);
  EXPECT_LT(cuts[0].fromColumn, -0.5);
  EXPECT_GT(cuts[0].toColumn, 10.5);
  const Missing missing = Missing().withCut(11, 9, cuts[0]);
  for (int column = 0; column < 11; ++column) EXPECT_TRUE(missing.has(4 * 11 + column, Missing::Down)) << column;
}

TEST_F(CutPathTest, ADragBesideTheClothOrWithoutLengthCutsNothing) {
  make(11, 9);
  EXPECT_TRUE(cut(place(-3, -2), place(14, -2)).empty());
  EXPECT_TRUE(cut(place(3, 3), place(3, 3)).empty());
}

TEST_F(CutPathTest, OnFoldedClothTheFrontLayerIsCut) {
  make(11, 9);
  for (int row = 5; row < 9; ++row) {  // folded up behind itself
    for (int column = 0; column < 11; ++column) {
      float* p = &xyz_[3 * std::size_t(row * 11 + column)];
      p[1] = -0.1F * float(8 - row), p[2] = -0.2F;
    }
  }
  for (const CutLine& line : cut(place(2.2F, 2.5F), place(6.8F, 2.5F))) {
    EXPECT_LT(line.fromRow, 5);
    EXPECT_LT(line.toRow, 5);
  }
}

TEST_F(CutPathTest, ABentClothIsCutAlongABentPath) {
  make(21, 21);
  for (std::size_t k = 0; k < xyz_.size(); k += 3) xyz_[k + 1] += 0.5F * std::sin(3 * xyz_[k]);
  const auto cuts = cut(place(-1, 10), place(22, 10));
  EXPECT_GT(cuts.size(), 2U);
  for (std::size_t k = 1; k < cuts.size(); ++k) {
    EXPECT_EQ(cuts[k].fromColumn, cuts[k - 1].toColumn);
    EXPECT_EQ(cuts[k].fromRow, cuts[k - 1].toRow);
  }
  Missing missing;
  for (const CutLine& line : cuts) missing = missing.withCut(21, 21, line);
  for (int column = 0; column < 21; ++column) {
    int gone = 0;
    for (int row = 0; row < 20; ++row) gone += int(missing.has(row * 21 + column, Missing::Down));
    EXPECT_GE(gone, 1) << "column " << column << " is in one piece";
  }
}

TEST_F(CutPathTest, AChainIsCutWhereTheLineCrossesIt) {
  make(1, 10);
  const auto cuts = cut(place(-1, 4.3F), place(1, 4.7F));
  ASSERT_EQ(cuts.size(), 1U);
  EXPECT_NEAR(cuts[0].fromRow, 4.5, 0.05);
  EXPECT_TRUE(Missing().withCut(1, 10, cuts[0]).has(4, Missing::Down));
  EXPECT_TRUE(cut(place(-2, 4.3F), place(-1, 4.7F)).empty());
}

TEST_F(CutPathTest, ASecondCutAcrossTheFirstLeavesNoThread) {
  make(11, 9);
  for (const CutLine& line : cut(place(5.5F, -2), place(5.5F, 11)))
    sheet_.missing = sheet_.missing.withCut(11, 9, line);
  for (std::size_t k = 0; k < xyz_.size(); k += 3) {
    if (k / 3 % 11 > 5) xyz_[k] += 0.2F;  // it has opened
  }
  for (const CutLine& line : cut(place(-3, 4.5F), place(16, 4.5F))) {
    sheet_.missing = sheet_.missing.withCut(11, 9, line);
  }
  for (int column = 0; column < 11; ++column) EXPECT_TRUE(sheet_.missing.has(4 * 11 + column, Missing::Down)) << column;
}

TEST_F(CutPathTest, AThreadBetweenTwoHolesIsCutByItself) {
  make(5, 3);
  sheet_.missing = Missing().withCut(5, 3, {1.5, -1, 1.5, 3}).withCut(5, 3, {2.5, -1, 2.5, 3});
  const auto cuts = cut(place(1.7F, 0.5F), place(2.3F, 0.5F));
  ASSERT_EQ(cuts.size(), 1U);
  EXPECT_TRUE(sheet_.missing.withCut(5, 3, cuts[0]).has(2, Missing::Down));
}

}  // namespace
}  // namespace tyg
