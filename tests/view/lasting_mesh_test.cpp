// The mesh that stays the same while its sheet is cut: its area, its sides, and that it opens where the sheet does.
#include "view/lasting_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "start_points.h"

namespace tyg {
namespace {

Sheet sheetOf(int columns, int rows) {
  Sheet sheet;
  sheet.columns = columns, sheet.rows = rows, sheet.spacing = 0.1;
  return sheet;
}

Sheet randomlyCut(Sheet sheet, int cuts, std::mt19937& random) {
  std::uniform_real_distribution<double> column(-2, sheet.columns + 1), row(-2, sheet.rows + 1);
  for (int k = 0; k < cuts; ++k) {
    const CutLine line{column(random), row(random), column(random), row(random)};
    sheet.missing = sheet.missing.withCut(sheet.columns, sheet.rows, line);
  }
  return sheet;
}

/// The area of each half of a quad, as a vector.
std::array<glm::vec3, 2> areasOf(const LastingMesh& mesh, const std::array<std::uint32_t, 4>& quad) {
  const auto at = [&](std::size_t i) { return mesh.points()[quad.at(i)]; };
  return {0.5F * glm::cross(at(1) - at(0), at(2) - at(0)), 0.5F * glm::cross(at(2) - at(0), at(3) - at(0))};
}

TEST(LastingMesh, OfAWholeSheetIsItsCells) {
  const Sheet sheet = sheetOf(7, 5);
  LastingMesh mesh(sheet);
  mesh.follow(sheet, startOf(sheet));
  EXPECT_EQ(mesh.quads().size(), 24U);
  EXPECT_EQ(mesh.points().size(), 35U);
  for (const glm::vec3& normal : mesh.normals()) EXPECT_NEAR(normal.z, -1, 1e-6);
}

TEST(LastingMesh, HasTheSheetsAreaBeforeAndAfterAnyCutsAndTurnsNowhereOver) {
  std::mt19937 random(1);
  for (int k = 0; k < 300; ++k) {
    const Sheet whole = sheetOf(2 + k % 7, 2 + k % 5);
    const Sheet between = randomlyCut(whole, k % 3, random), last = randomlyCut(between, k % 4, random);
    LastingMesh mesh(last);
    for (const Sheet& now : {whole, between, last}) {
      mesh.follow(now, startOf(now));
      double sum = 0;
      for (const auto& quad : mesh.quads()) {
        for (const glm::vec3& area : areasOf(mesh, quad)) {
          EXPECT_LE(area.z, 1e-9) << k;
          sum += glm::length(area);
        }
      }
      EXPECT_NEAR(sum, (now.columns - 1) * (now.rows - 1) * 0.01, 1e-6) << k;
    }
  }
}

TEST(LastingMesh, ItsFirstPointsAreTheParticlesWhateverIsCut) {
  std::mt19937 random(2);
  const Sheet sheet = randomlyCut(sheetOf(6, 6), 3, random);
  const std::vector<float> xyz = startOf(sheet);
  LastingMesh mesh(sheet);
  mesh.follow(sheet, xyz);
  for (std::size_t i = 0; i < 36; ++i) {
    EXPECT_EQ(mesh.points()[i], glm::vec3(xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]));
    EXPECT_EQ(mesh.places()[i], glm::vec2(float(i % 6), float(i / 6)));
  }
}

TEST(LastingMesh, HalvesThatFlyApartAreJoinedByNothingAndBeforeByAllTheirPoints) {
  const Sheet whole = sheetOf(8, 6);
  Sheet cut = whole;
  cut.missing = cut.missing.withCut(8, 6, {3.3, -1, 4.7, 6});
  LastingMesh mesh(cut);
  std::vector<float> xyz = startOf(cut);
  mesh.follow(whole, xyz);
  const std::vector<glm::vec3> before = mesh.points();
  for (std::size_t i = 48; i < before.size(); ++i) {
    const glm::vec2 place = mesh.places()[i];
    EXPECT_LT(glm::distance(before[i], {0.1F * place.x - 0.35F, before[i].y, 0}), 1e-6F) << "in the middle of a side";
  }
  for (int i = 0; i < 48; ++i) {
    const double column = i % 8, row = i / 8;
    if (column > 3.3 + 1.4 * (row + 1) / 7) xyz[std::size_t(3 * i)] += 5;
  }
  mesh.follow(cut, xyz);
  for (const auto& quad : mesh.quads()) {
    for (const std::uint32_t a : quad) {
      for (const std::uint32_t b : quad) EXPECT_LT(glm::distance(mesh.points()[a], mesh.points()[b]), 0.15F);
    }
  }
}

}  // namespace
}  // namespace tyg
