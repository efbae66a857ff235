// Which particle a click means, without OpenGL.
#include "view/picking.h"

#include <gtest/gtest.h>

#include <vector>

#include "start_points.h"

namespace tyg {
namespace {

const glm::vec2 kWindow{1000, 800};

Sheet sheetOf(int columns, int rows) {
  Sheet sheet;
  sheet.columns = columns, sheet.rows = rows, sheet.spacing = 0.1;
  return sheet;
}

Camera cameraOn(const std::vector<float>& xyz) {
  Camera camera;
  camera.frame(boxAround(xyz), kWindow.x / kWindow.y);
  return camera;
}

glm::vec2 pixelOf(const Camera& camera, const std::vector<float>& xyz, int particle) {
  const auto at = 3 * static_cast<std::size_t>(particle);
  const glm::vec4 clip =
      camera.projection(kWindow.x / kWindow.y) * camera.view() * glm::vec4(xyz[at], xyz[at + 1], xyz[at + 2], 1);
  return {(clip.x / clip.w + 1) / 2 * kWindow.x, (1 - clip.y / clip.w) / 2 * kWindow.y};
}

TEST(Picking, FindsEveryParticleUnderTheCursorOnSheetsOfAllShapes) {
  for (const auto& [columns, rows] : {std::pair{1, 1}, {1, 9}, {9, 1}, {2, 2}, {20, 20}, {37, 11}}) {
    const Sheet sheet = sheetOf(columns, rows);
    const std::vector<float> xyz = startOf(sheet);
    const Camera camera = cameraOn(xyz);
    for (int particle = 0; particle < sheet.count(); ++particle) {
      EXPECT_EQ(pickParticle(camera, pixelOf(camera, xyz, particle), kWindow, sheet, xyz), particle)
          << columns << "x" << rows;
    }
  }
}

TEST(Picking, TakesTheLayerThatTheEyeSeesFirst) {
  // The upper half lies in the plane z = 0, the lower half is folded up behind it.
  Sheet sheet = sheetOf(5, 10);
  std::vector<float> xyz = startOf(sheet);
  for (std::size_t i = 25; i < 50; ++i) {
    xyz[3 * i + 1] = -0.1F * static_cast<float>(9 - i / 5);
    xyz[3 * i + 2] = -0.3F;
  }
  const Camera camera = cameraOn(xyz);
  const int front = 2 * 5 + 2;
  EXPECT_EQ(pickParticle(camera, pixelOf(camera, xyz, front), kWindow, sheet, xyz), front);
  const int behind = 7 * 5 + 2;
  const auto picked = pickParticle(camera, pixelOf(camera, xyz, behind), kWindow, sheet, xyz);
  ASSERT_TRUE(picked.has_value());
  EXPECT_LT(*picked, 25) << "picked through the front layer";
}

TEST(Picking, AClickBesideTheClothFindsNothingBeyondTheRadius) {
  const Sheet sheet = sheetOf(20, 20);
  const std::vector<float> xyz = startOf(sheet);
  const Camera camera = cameraOn(xyz);
  const glm::vec2 corner = pixelOf(camera, xyz, 0), outward{-0.8F, -0.6F};
  EXPECT_EQ(pickParticle(camera, corner + 8.0F * outward, kWindow, sheet, xyz), 0);
  EXPECT_EQ(pickParticle(camera, corner + 30.0F * outward, kWindow, sheet, xyz), std::nullopt);
}

TEST(Picking, AMissByAFewPixelsBesideAnEdgeFindsTheNearerEndOfTheSpringThere) {
  const Sheet sheet = sheetOf(4, 4);
  const std::vector<float> xyz = startOf(sheet);
  const Camera camera = cameraOn(xyz);
  const glm::vec2 left = pixelOf(camera, xyz, 4), below = pixelOf(camera, xyz, 8);  // of the left edge
  const glm::vec2 out = glm::normalize(left - pixelOf(camera, xyz, 5));
  ASSERT_GT(glm::distance(left, below), 5 * kPickRadius);
  for (const float share : {0.4F, 0.6F}) {
    const glm::vec2 near = glm::mix(left, below, share) + 0.6F * kPickRadius * out;
    EXPECT_EQ(pickParticle(camera, near, kWindow, sheet, xyz), share < 0.5F ? 4 : 8);
    const glm::vec2 far = glm::mix(left, below, share) + 1.5F * kPickRadius * out;
    EXPECT_EQ(pickParticle(camera, far, kWindow, sheet, xyz), std::nullopt);
  }
  Sheet cut = sheet;
  cut.missing = cut.missing.withCut(4, 4, {-1, 1.5, 4, 1.5});
  EXPECT_EQ(pickParticle(camera, glm::mix(left, below, 0.4F) + 0.6F * kPickRadius * out, kWindow, cut, xyz),
            std::nullopt)
      << "there is no spring any more";
}

TEST(Picking, FindsNothingBetweenTwoPartsOfACutCloth) {
  Sheet sheet = sheetOf(10, 10);
  std::vector<float> xyz = startOf(sheet);
  for (std::size_t i = 50; i < 100; ++i) xyz[3 * i + 1] -= 1;
  const Camera camera = cameraOn(xyz);
  const glm::vec2 between = (pixelOf(camera, xyz, 44) + pixelOf(camera, xyz, 54)) / 2.0F;
  EXPECT_TRUE(pickParticle(camera, between, kWindow, sheet, xyz)) << "stretched cells";
  sheet.missing = sheet.missing.withCut(10, 10, {-1, 4.5, 10, 4.5});
  EXPECT_FALSE(pickParticle(camera, between, kWindow, sheet, xyz));
  EXPECT_EQ(pickParticle(camera, pixelOf(camera, xyz, 44), kWindow, sheet, xyz), 44);
}

TEST(Picking, NeverPicksBehindTheEyeOrWhatIsNotFinite) {
  const Sheet sheet = sheetOf(6, 6);
  std::vector<float> xyz = startOf(sheet);
  Camera camera = cameraOn(xyz);
  const glm::vec2 place = pixelOf(camera, xyz, 14);
  xyz[3 * 14] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_NE(pickParticle(camera, place, kWindow, sheet, xyz), 14);
  camera.lookAlong(camera.yaw() + 3.14159F, -camera.pitch());
  for (const glm::vec2 cursor : {glm::vec2(500, 400), glm::vec2(10, 10), place}) {
    EXPECT_EQ(pickParticle(camera, cursor, kWindow, sheet, xyz), std::nullopt);
  }
}

TEST(Picking, TheLineOfSightThroughAParticleMeetsIt) {
  constexpr float kRounding = 1e-4F;  // m, single precision at a distance of a few metres
  const Sheet sheet = sheetOf(20, 20);
  const std::vector<float> xyz = startOf(sheet);
  const Camera camera = cameraOn(xyz);
  const glm::vec3 particle(xyz[3 * 45], xyz[3 * 45 + 1], xyz[3 * 45 + 2]);
  const Ray ray = sightLine(camera, pixelOf(camera, xyz, 45), kWindow);
  EXPECT_NEAR(glm::length(glm::cross(particle - ray.origin, ray.direction)), 0, kRounding);
  EXPECT_GT(glm::dot(particle - ray.origin, ray.direction), 0);
}

TEST(PickBody, FindsTheFirstSurfaceOnALineOfSight) {
  const std::vector<Body> bodies = {
      {.shape = Shape::Plane, .at = {0, -1, 0}},
      {.shape = Shape::Ball, .at = {0, 0, -5}, .radius = 1},
      {.shape = Shape::Box, .at = {0, 0, -9}, .half = {2, 1, 0.5}, .radius = 0.1},
      {.shape = Shape::Capsule, .at = {-3, 0, -4}, .axis = {0, 2, 0}, .radius = 0.5},
  };
  struct Sighting {
    glm::vec3 to;
    std::optional<std::size_t> body;
    float distance;
  };
  // From the origin, along the way to a point. The flat front of the box is at z = -8.5.
  const Sighting sightings[] = {
      {{0, 0, -1}, 1, 4},
      {{1.85F, 0, -8.5F}, 2, std::hypot(1.85F, 8.5F)},
      {{-3, 1, -4}, 3, std::hypot(3.0F, 1.0F, 4.0F) - 0.5F * std::hypot(3.0F, 1.0F, 4.0F) / 5},
      {{0, -1, -1}, std::nullopt, 0},
      {{0, 0, 1}, std::nullopt, 0},
      {{-3, 2.6F, -4}, std::nullopt, 0},
  };
  for (const Sighting& sighting : sightings) {
    const auto picked = pickBody({glm::vec3(0), glm::normalize(sighting.to)}, bodies);
    ASSERT_EQ(picked.has_value(), sighting.body.has_value()) << sighting.to.x << " " << sighting.to.y;
    if (!picked) continue;
    EXPECT_EQ(picked->body, *sighting.body);
    EXPECT_NEAR(picked->distance, sighting.distance, 2e-3F);
  }
}

TEST(PickBody, AnEyeWithinABodySeesWhatIsOutside) {
  const std::vector<Body> bodies = {{.shape = Shape::Ball, .at = {0, 0, 0}, .radius = 1},
                                    {.shape = Shape::Ball, .at = {0, 0, -5}, .radius = 1}};
  const auto picked = pickBody({glm::vec3(0), {0, 0, -1}}, bodies);
  ASSERT_TRUE(picked);
  EXPECT_EQ(picked->body, 1U);
}

TEST(MiddleInView, LeavesOutWhatHasFallenOutOfSight) {
  const Sheet sheet = sheetOf(9, 9);
  const std::vector<float> whole = startOf(sheet);
  const Camera camera = cameraOn(whole);
  const glm::vec3 middle = middleInView(camera, kWindow, whole);
  EXPECT_LT(glm::distance(middle, boxAround(whole).centre()), 1e-6F);
  std::vector<float> cut = whole;
  const std::size_t half = 3 * 9 * 4;
  for (std::size_t k = half; k < cut.size(); k += 3) cut[k + 1] -= 100;
  const glm::vec3 left = boxAround(std::span(whole).first(half)).centre();
  EXPECT_LT(glm::distance(middleInView(camera, kWindow, cut), left), 1e-6F);
  std::vector<float> gone = whole;
  for (std::size_t k = 1; k < gone.size(); k += 3) gone[k] -= 100;
  EXPECT_LT(glm::distance(middleInView(camera, kWindow, gone), boxAround(gone).centre()), 1e-4F);
}

}  // namespace
}  // namespace tyg
