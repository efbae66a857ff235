// What a cut takes from a grid, held against the rule spelled out spring by spring.
#include <gtest/gtest.h>

#include <set>

#include "core/scene/springs_of_particle.h"
#include "test_systems.h"

namespace tyg::test {
namespace {

using Pair = std::pair<int, int>;

std::set<Pair> springsLeft(const Sheet& sheet) {
  std::set<Pair> left;
  for (const Family family : {Family::Structural, Family::Shear, Family::Bend}) {
    for (const SpringEnds& ends : springsOf(sheet, family)) {
      left.insert({std::min(ends.first, ends.second), std::max(ends.first, ends.second)});
    }
  }
  return left;
}

std::set<Pair> taken(const Sheet& before, const Sheet& after) {
  std::set<Pair> gone = springsLeft(before);
  for (const Pair& pair : springsLeft(after)) gone.erase(pair);
  return gone;
}

Sheet cutSheet(Sheet sheet, const CutLine& line) {
  sheet.missing = sheet.missing.withCut(sheet.columns, sheet.rows, line);
  return sheet;
}

TEST(Cuts, BetweenTwoColumnsTakeWhatCrossesAndNothingElse) {
  const Sheet sheet = makeSheet(emptyWorld(4, 3)), cut = cutSheet(sheet, {1.5, -1, 1.5, 5});
  EXPECT_TRUE(sheet.missing.none());
  for (const Pair& pair : springsLeft(sheet)) {
    const bool crosses = (pair.first % 4 < 2) != (pair.second % 4 < 2);
    EXPECT_EQ(springsLeft(cut).count(pair), crosses ? 0U : 1U) << pair.first << "-" << pair.second;
  }
  for (int particle = 0; particle < 8; ++particle) {
    EXPECT_EQ(cut.missing.has(particle, Missing::Cell), particle % 4 == 1) << particle;
  }
}

TEST(Cuts, ThroughParticlesLeaveThemOnTheSideOfLargerColumnsOrRows) {
  const Sheet sheet = makeSheet(emptyWorld(4, 4));
  EXPECT_EQ(taken(sheet, cutSheet(sheet, {2, -1, 2, 5})), taken(sheet, cutSheet(sheet, {1.5, -1, 1.5, 5})));
  EXPECT_EQ(taken(sheet, cutSheet(sheet, {2, 5, 2, -1})), taken(sheet, cutSheet(sheet, {2, -1, 2, 5})));
  EXPECT_EQ(taken(sheet, cutSheet(sheet, {-1, 2, 5, 2})), taken(sheet, cutSheet(sheet, {5, 1.5, -1, 1.5})));
}

TEST(Cuts, EndWhereTheyEnd) {
  const Sheet sheet = makeSheet(emptyWorld(5, 5));
  // Up to the middle of the cell between rows 1 and 2: the diagonals meet the cut's end there and go too.
  const Sheet cut = cutSheet(sheet, {1.5, -1, 1.5, 1.5});
  const auto isGone = [&](int column, int row, Missing::Bit bit) { return cut.missing.has(row * 5 + column, bit); };
  EXPECT_TRUE(isGone(1, 0, Missing::Right) && isGone(1, 1, Missing::Right));
  EXPECT_FALSE(isGone(1, 2, Missing::Right));
  EXPECT_TRUE(isGone(1, 1, Missing::DownRight) && isGone(1, 1, Missing::DownLeft) && isGone(1, 1, Missing::Cell));
  EXPECT_FALSE(isGone(1, 2, Missing::DownRight) || isGone(1, 2, Missing::Cell));
  EXPECT_TRUE(cutSheet(sheet, {1.3, 1.2, 1.7, 1.2}).missing.none()) << "within a cell nothing is crossed";
}

/// The rule of docs/model.md for one spring, with nothing left out for speed.
bool ruleTakes(CutLine cut, double ax, double ay, double bx, double by) {
  double nx = cut.toRow - cut.fromRow, ny = cut.fromColumn - cut.toColumn;
  if (nx < 0 || (nx == 0 && ny < 0)) nx = -nx, ny = -ny;
  const auto isBeyond = [&](double x, double y) { return nx * (x - cut.fromColumn) + ny * (y - cut.fromRow) >= 0; };
  const auto beside = [&](double x, double y) { return (bx - ax) * (y - ay) - (by - ay) * (x - ax); };
  const double from = beside(cut.fromColumn, cut.fromRow), to = beside(cut.toColumn, cut.toRow);
  return isBeyond(ax, ay) != isBeyond(bx, by) && !(from > 0 && to > 0) && !(from < 0 && to < 0);
}

TEST(Cuts, AtRandomFollowTheRuleForEverySpring) {
  Numbers numbers(5);
  for (int draw = 0; draw < 300; ++draw) {
    const int columns = 1 + int(numbers.between(0, 9)), rows = 1 + int(numbers.between(0, 9));
    const auto place = [&](int count) {
      const double exact = numbers.between(-2, count + 1);
      return numbers.coin() ? std::round(2 * exact) / 2 : exact;
    };
    const CutLine line{place(columns), place(rows), place(columns), place(rows)};
    if (line.fromColumn == line.toColumn && line.fromRow == line.toRow) continue;
    const Sheet sheet = makeSheet(emptyWorld(columns, rows)), cut = cutSheet(sheet, line);
    const std::set<Pair> left = springsLeft(cut);
    for (const Pair& pair : springsLeft(sheet)) {
      const bool isTaken = ruleTakes(line, pair.first % columns, int(pair.first / columns), pair.second % columns,
                                     int(pair.second / columns));
      ASSERT_EQ(left.count(pair), isTaken ? 0U : 1U) << "draw " << draw;
    }
  }
}

TEST(Cuts, CountTheSpringsThatAreLeft) {
  const Sheet cut = cutSheet(makeSheet(emptyWorld(6, 6)), {0.3, -1, 4.2, 6});
  for (const Family family : {Family::Structural, Family::Shear, Family::Bend}) {
    EXPECT_EQ(springCount(cut, family), static_cast<long long>(springsOf(cut, family).size()));
    EXPECT_LT(springCount(cut, family), springCount(makeSheet(emptyWorld(6, 6)), family));
  }
}

}  // namespace
}  // namespace tyg::test
