// The surface of a cloth: its normals, and what is drawn beside cuts, by areas and lengths of triangles.
#include "view/cloth_surface.h"

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

using Triangle = std::array<glm::vec3, 3>;

glm::vec3 areaOf(const Triangle& t) { return 0.5F * glm::cross(t[1] - t[0], t[2] - t[0]); }

float longestSide(const Triangle& t) {
  return std::max({glm::distance(t[0], t[1]), glm::distance(t[1], t[2]), glm::distance(t[2], t[0])});
}

/// All that is drawn of a sheet.
std::vector<Triangle> drawn(const Sheet& sheet, const std::vector<float>& xyz) {
  ClothSurface surface(sheet);
  surface.follow(xyz);
  std::vector<Triangle> all;
  const auto at = [&](std::uint32_t i) { return glm::vec3(xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]); };
  const auto& whole = surface.triangles();
  for (std::size_t i = 0; i < whole.size(); i += 3) all.push_back({at(whole[i]), at(whole[i + 1]), at(whole[i + 2])});
  const auto& pieces = surface.pieces();
  for (std::size_t i = 0; i < pieces.size(); i += 3) {
    all.push_back({pieces[i].position, pieces[i + 1].position, pieces[i + 2].position});
  }
  return all;
}

double totalArea(const std::vector<Triangle>& triangles) {
  double sum = 0;
  for (const Triangle& triangle : triangles) sum += glm::length(areaOf(triangle));
  return sum;
}

double areaAtRest(const Sheet& sheet) { return (sheet.columns - 1) * (sheet.rows - 1) * sheet.spacing * sheet.spacing; }

CutLine randomCut(const Sheet& sheet, std::mt19937& random) {
  std::uniform_real_distribution<double> column(-2, sheet.columns + 1), row(-2, sheet.rows + 1);
  return {column(random), row(random), column(random), row(random)};
}

TEST(ClothSurface, AFlatSheetHasItsAreaAndNormalsAcrossIt) {
  const Sheet sheet = sheetOf(7, 5);
  const std::vector<float> xyz = startOf(sheet);
  EXPECT_NEAR(totalArea(drawn(sheet, xyz)), areaAtRest(sheet), 1e-6);
  ClothSurface surface(sheet);
  surface.follow(xyz);
  EXPECT_TRUE(surface.pieces().empty());
  for (const glm::vec3& normal : surface.normals()) EXPECT_NEAR(glm::normalize(normal).z, -1, 1e-6);
}

TEST(ClothSurface, NormalsOfASphereArePartsOfItsRadii) {
  const Sheet sheet = sheetOf(41, 41);
  std::vector<float> xyz = startOf(sheet);
  for (std::size_t i = 0; i < xyz.size(); i += 3) {
    const glm::vec3 p = glm::normalize(glm::vec3(xyz[i] / 4, xyz[i + 1] / 4 + 0.5F, 1));
    xyz[i] = p.x, xyz[i + 1] = p.y, xyz[i + 2] = p.z;
  }
  ClothSurface surface(sheet);
  surface.follow(xyz);
  for (int row = 1; row + 1 < sheet.rows; ++row) {
    for (int column = 1; column + 1 < sheet.columns; ++column) {
      const auto i = std::size_t(row * sheet.columns + column);
      const glm::vec3 radius(xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]);
      EXPECT_LT(glm::dot(glm::normalize(surface.normals()[i]), radius), -0.9999F);
    }
  }
}

TEST(ClothSurface, HasTheSheetsAreaAtRestWhateverIsCutAndTurnsNowhereOver) {
  std::mt19937 random(1);
  for (int k = 0; k < 300; ++k) {
    Sheet sheet = sheetOf(2 + k % 7, 2 + k % 5);
    for (int cut = 0; cut <= k % 4; ++cut) {
      sheet.missing = sheet.missing.withCut(sheet.columns, sheet.rows, randomCut(sheet, random));
    }
    const auto triangles = drawn(sheet, startOf(sheet));
    EXPECT_NEAR(totalArea(triangles), areaAtRest(sheet), 1e-6) << k;
    for (const Triangle& triangle : triangles) EXPECT_LE(areaOf(triangle).z, 1e-9) << k;
  }
}

/// Moves what lies to the right of a line on the grid.
std::vector<float> apart(const Sheet& sheet, std::vector<float> xyz, double column, double slope, const glm::vec3& by) {
  for (int i = 0; i < sheet.count(); ++i) {
    if (i % sheet.columns < column + slope * (i / sheet.columns)) continue;
    for (int axis = 0; axis < 3; ++axis) xyz[std::size_t(3 * i + axis)] += by[axis];
  }
  return xyz;
}

TEST(ClothSurface, HalvesThatFlyApartAreDrawnAsHalves) {
  for (const double slope : {0.0, 0.4, 1.0, -0.7}) {
    Sheet sheet = sheetOf(20, 10);
    const double column = 9.5;
    sheet.missing = sheet.missing.withCut(sheet.columns, sheet.rows, {column - slope, -1, column + 10 * slope, 10});
    for (const glm::vec3& by : {glm::vec3(3, 0, 0), glm::vec3(0, -5, 2), glm::vec3(-1, 1, -4)}) {
      const auto triangles = drawn(sheet, apart(sheet, startOf(sheet), column, slope, by));
      EXPECT_NEAR(totalArea(triangles), areaAtRest(sheet), 2e-6);
      for (const Triangle& triangle : triangles) EXPECT_LE(longestSide(triangle), 1.4143F * sheet.spacing);
    }
  }
}

TEST(ClothSurface, SinglesAndStripsThatFlyApartHaveNoLongTriangles) {
  Sheet sheet = sheetOf(9, 6);
  for (int k = 0; k < 8; ++k) {  // into columns of one particle each, the last of which are cut across too
    sheet.missing = sheet.missing.withCut(sheet.columns, sheet.rows, {k + 0.5, -1, k + 0.5, 6});
  }
  for (int k = 0; k < 5; ++k) {
    sheet.missing = sheet.missing.withCut(sheet.columns, sheet.rows, {5.7, k + 0.5, 9, k + 0.5});
  }
  std::mt19937 random(2);
  std::uniform_real_distribution<float> away(-3, 3);
  std::vector<float> xyz = startOf(sheet);
  std::vector<glm::vec3> ofColumns(9);
  for (glm::vec3& by : ofColumns) by = {away(random), away(random), away(random)};
  for (int i = 0; i < sheet.count(); ++i) {
    const bool isSingle = i % sheet.columns > 5;
    const glm::vec3 by =
        isSingle ? glm::vec3(away(random), away(random), away(random)) : ofColumns[std::size_t(i % sheet.columns)];
    for (int axis = 0; axis < 3; ++axis) xyz[std::size_t(3 * i + axis)] += by[axis];
  }
  for (const Triangle& triangle : drawn(sheet, xyz)) EXPECT_LE(longestSide(triangle), 1.4143F * sheet.spacing);
}

TEST(ClothSurface, ASlitOpensAndItsEndStaysJoined) {
  Sheet sheet = sheetOf(5, 5);
  sheet.missing = sheet.missing.withCut(5, 5, {1.5, -1, 1.5, 1.5});  // takes two sides
  ClothSurface surface(sheet);
  const std::vector<float> xyz = startOf(sheet);
  surface.follow(xyz);
  float lowest = 0;
  for (const ClothVertex& vertex : surface.pieces()) lowest = std::max(lowest, vertex.place.y);
  EXPECT_EQ(lowest, 2);
  const auto isEnd = [](const ClothVertex& vertex) { return vertex.place == glm::vec2(1.5F, 1.5F); };
  const auto end = std::ranges::find_if(surface.pieces(), isEnd);
  ASSERT_NE(end, surface.pieces().end()) << "the slit ends in the middle of a cell";
  EXPECT_NEAR(end->position.y, -0.15, 1e-6);
}

TEST(ClothSurface, NormalsBesideACutAreThoseOfTheirOwnSide) {
  Sheet sheet = sheetOf(8, 4);
  sheet.missing = sheet.missing.withCut(8, 4, {3.5, -1, 3.5, 4});
  std::vector<float> xyz = startOf(sheet);
  for (int i = 0; i < sheet.count(); ++i) {  // the right half is turned out of the plane by a right angle
    const int column = i % sheet.columns;
    if (column > 3) xyz[std::size_t(3 * i)] = 0.9F, xyz[std::size_t(3 * i + 2)] = 0.1F * float(column);
  }
  ClothSurface surface(sheet);
  surface.follow(xyz);
  for (int i = 0; i < sheet.count(); ++i) {
    const glm::vec3 normal = glm::normalize(surface.normals()[std::size_t(i)]);
    EXPECT_NEAR(i % sheet.columns <= 3 ? -normal.z : normal.x, 1, 1e-5);
  }
  for (const ClothVertex& vertex : surface.pieces()) {
    EXPECT_EQ(vertex.particle % 8 <= 3, vertex.place.x <= 3.5F && vertex.position.z == 0) << "a side of its own";
  }
}

TEST(ClothSurface, ParticlesTakeTheStrainOfTheirMostStrainedSpring) {
  Sheet sheet = sheetOf(4, 3);
  std::vector<float> xyz = startOf(sheet);
  for (int row = 0; row < 3; ++row) xyz[std::size_t(3 * (4 * row + 3))] += 0.05F;  // the last column, to the right
  std::vector<float> strains;
  particleStrains(sheet, xyz, strains);
  for (int i = 0; i < sheet.count(); ++i) EXPECT_NEAR(strains[std::size_t(i)], i % 4 >= 2 ? 0.5 : 0, 1e-5);
  sheet.missing = sheet.missing.withCut(4, 3, {2.5, -1, 2.5, 3});
  particleStrains(sheet, xyz, strains);
  for (const float strain : strains) EXPECT_NEAR(strain, 0, 1e-5);
}

}  // namespace
}  // namespace tyg
