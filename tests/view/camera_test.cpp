// The camera, its framing and the arrow at the window's edge, without OpenGL.
#include "view/camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace tyg {
namespace {

constexpr float kRounding = 1e-4F;  // single precision over a few products
const Box kCloth{{-1, -2, -0.5F}, {1, 0, 0.5F}};
const glm::vec2 kWindow{1280, 720};

glm::vec3 ndc(const Camera& camera, const glm::vec3& point, float aspect) {
  const glm::vec4 clip = camera.projection(aspect) * camera.view() * glm::vec4(point, 1);
  return glm::vec3(clip) / clip.w;
}

TEST(Camera, FramesTheWholeClothAtEveryAspectRatio) {
  for (const float aspect : {0.3F, 1.0F, 1.78F, 4.0F}) {
    Camera camera;
    camera.frame(kCloth, aspect);
    float largest = 0;
    for (const glm::vec3& corner : kCloth.corners()) {
      const glm::vec3 seen = glm::abs(ndc(camera, corner, aspect));
      EXPECT_LT(seen.z, 1);
      largest = std::max({largest, seen.x, seen.y});
    }
    EXPECT_LT(largest, 0.95F);
    EXPECT_GT(largest, 0.7F) << "the view wastes room";
  }
}

TEST(Camera, FramesTheClothInTheFreePartOfAWindow) {
  constexpr float kWide = 16.0F / 9, kFree = 0.5F;  // aspects of the window and of its free part, the right half
  for (const float aspect : {0.4F, 0.5F * kWide}) {
    Camera camera;
    const float aside = kFree * kWide / 2;  // heights from the window's middle to that of its right half
    const auto corners = kCloth.corners();
    camera.watch(kCloth);
    camera.frame(corners, {.width = aspect, .toTheRight = aside});
    glm::vec2 low(1e9F), high(-1e9F);
    for (const glm::vec3& corner : kCloth.corners()) {
      const glm::vec2 seen(ndc(camera, corner, kWide));
      low = glm::min(low, seen), high = glm::max(high, seen);
    }
    EXPECT_NEAR((low.x + high.x) / 2, 0.5F, 0.02F);
    EXPECT_NEAR((low.y + high.y) / 2, 0, 0.02F);
    EXPECT_LT(high.x - low.x, 2 * aspect / kWide) << "wider than what is free";
    EXPECT_GT(std::max((high.x - low.x) * kWide / aspect, high.y - low.y), 1.4F) << "the view wastes room";
  }
}

TEST(Camera, FramesTheClothAboveWhatTakesTheLowerEdge) {
  Camera camera;
  const auto corners = kCloth.corners();
  camera.watch(kCloth);
  camera.frame(corners, {.width = 1.5F, .height = 0.5F, .above = 0.25F});
  glm::vec2 low(1e9F), high(-1e9F);
  for (const glm::vec3& corner : corners) {
    const glm::vec2 seen(ndc(camera, corner, 1.5F));
    low = glm::min(low, seen), high = glm::max(high, seen);
  }
  EXPECT_GT(low.y, 0);
  EXPECT_LT(high.y, 1);
  EXPECT_GT(high.y - low.y, 0.7F) << "the view wastes room";
}

TEST(Camera, KeepsPointsInViewWithTheLeastMoveThatDoes) {
  constexpr float kWide = 16.0F / 9;
  const FreePart lowerLeft{.width = kWide / 2, .height = 0.5F, .toTheRight = -kWide / 4, .above = -0.25F};
  Camera camera;
  camera.watch(kCloth);
  const auto corners = kCloth.corners();
  camera.frame(corners, lowerLeft);
  const auto moved = [&](const glm::vec3& way) {
    std::vector<glm::vec3> points(corners.begin(), corners.end());
    for (glm::vec3& point : points) point += way;
    const glm::vec3 eye = camera.eye();
    camera.keepInView(points, lowerLeft);
    for (const glm::vec3& point : points) {
      const glm::vec3 seen = ndc(camera, point, kWide);
      EXPECT_TRUE(seen.x > -1 && seen.x < 0 && seen.y > -1 && seen.y < 0 && seen.z < 1) << way.x << " " << way.y;
    }
    return camera.eye() - eye;
  };
  EXPECT_EQ(moved({}), glm::vec3(0)) << "all is seen";
  const glm::vec3 aside = moved(3.0F * camera.right());
  EXPECT_GT(glm::dot(aside, camera.right()), 1);
  EXPECT_LT(glm::length(aside), 3) << "the margin is used up first";
  moved(2.0F * camera.right() - 4.0F * camera.up() - camera.forward());
  const std::vector<glm::vec3> apart{{-9, 0, 0}, {9, 0, 0}};
  camera.keepInView(apart, {.width = kWide});
  EXPECT_LT(std::abs(ndc(camera, apart[0], kWide).x), 1) << "farther away where there is no other way";
  EXPECT_LT(std::abs(ndc(camera, apart[1], kWide).x), 1);
}

TEST(Camera, SlidingMovesWhatIsSeenSidewaysAndUp) {
  Camera camera;
  camera.frame(kCloth, 1);
  const float distance = camera.distance();
  camera.slide(0.25F, 0);  // of the height
  EXPECT_NEAR(ndc(camera, kCloth.centre(), 1).x, 0.5F, 0.05F);
  EXPECT_NEAR(camera.distance(), distance, 0.05F * distance);
  const float high = ndc(camera, kCloth.centre(), 1).y;
  camera.slide(0, -0.1F);
  EXPECT_NEAR(ndc(camera, kCloth.centre(), 1).y, high - 0.2F, 0.05F);
}

TEST(Camera, OrbitingKeepsTheClothWhereItIsSeenAndAsFarAway) {
  Camera camera;
  camera.frame(kCloth, 1);
  camera.slide(0.2F, 0.1F);
  const glm::vec3 before = ndc(camera, kCloth.centre(), 1), eye = camera.eye();
  const float distance = camera.distance(), yaw = camera.yaw(), pitch = camera.pitch();
  camera.orbit(100, -30, kCloth.centre());
  EXPECT_GT(camera.yaw(), yaw + 0.5F) << "to the right the cloth turns with the mouse";
  EXPECT_GT(camera.pitch(), pitch);
  EXPECT_GT(glm::distance(camera.eye(), eye), 0.3F * distance);
  EXPECT_NEAR(camera.distance(), distance, 1e-4F * distance);
  const glm::vec3 after = ndc(camera, kCloth.centre(), 1);
  EXPECT_NEAR(after.x, before.x, 1e-4F);
  EXPECT_NEAR(after.y, before.y, 1e-4F);
}

TEST(Camera, FramingKeepsTheDirection) {
  Camera camera;
  camera.lookAlong(1.2F, 0.3F);
  const glm::vec3 before = camera.forward();
  camera.frame(kCloth, 1.5F);
  EXPECT_EQ(camera.forward(), before);
}

TEST(Camera, FliesFasterFartherAway) {
  Camera near, far;
  near.frame(kCloth, 1);
  far.frame(kCloth, 1);
  far.approach(-10);
  const glm::vec3 nearBefore = near.eye(), farBefore = far.eye();
  near.move({.right = 1}, 0.05F);
  far.move({.right = 1}, 0.05F);
  const float ratio = glm::distance(far.eye(), farBefore) / glm::distance(near.eye(), nearBefore);
  EXPECT_GT(ratio, 2);
}

TEST(Camera, KeysMoveAlongTheEyesAxes) {
  Camera camera;
  camera.frame(kCloth, 1);
  const glm::vec3 before = camera.eye();
  camera.move({.forward = 1}, 0.05F);
  EXPECT_NEAR(glm::dot(glm::normalize(camera.eye() - before), camera.forward()), 1, kRounding);
  const glm::vec3 ahead = camera.eye();
  camera.move({.up = -1}, 0.05F);
  EXPECT_LT(camera.eye().y, ahead.y);
}

TEST(Camera, ScrollingComesNearerButNeverThrough) {
  Camera camera;
  camera.frame(kCloth, 1);
  const float before = camera.distance();
  camera.approach(1);
  EXPECT_LT(camera.distance(), before);
}

TEST(Camera, CannotLookStraightUp) {
  Camera camera;
  camera.turn(0, -1e6F);
  EXPECT_LT(camera.pitch(), 1.5708F);
  EXPECT_GT(glm::length(glm::cross(camera.forward(), glm::vec3(0, 1, 0))), 0.01F);
}

TEST(Camera, StaysFiniteWhateverComesIn) {
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
  Camera camera;
  for (const float bad : {nan, infinite, -infinite, 1e38F}) {
    camera.turn(bad, bad);
    camera.move({bad, bad, bad}, bad);
    camera.approach(bad);
    camera.watch({glm::vec3(bad), glm::vec3(bad)});
    camera.frame({glm::vec3(-bad), glm::vec3(bad)}, bad);
    const glm::mat4 both = camera.projection(bad) * camera.view();
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) EXPECT_TRUE(std::isfinite(both[i][j])) << bad;
    }
  }
}

TEST(EdgeArrow, IsAbsentWhileTheClothIsInView) {
  Camera camera;
  camera.frame(kCloth, kWindow.x / kWindow.y);
  EXPECT_FALSE(edgeArrow(camera, kCloth, kWindow, 30).has_value());
}

TEST(EdgeArrow, PointsLeftWhenTheCameraLooksTooFarRight) {
  Camera camera;
  camera.frame(kCloth, kWindow.x / kWindow.y);
  camera.lookAlong(camera.yaw() + 1.3F, 0);
  const auto arrow = edgeArrow(camera, kCloth, kWindow, 30);
  ASSERT_TRUE(arrow.has_value());
  EXPECT_LT(arrow->direction.x, -0.7F);
  EXPECT_NEAR(arrow->tip.x, 30, 0.5F);
}

TEST(EdgeArrow, PointsToTheShorterWayWhenTheClothIsBehindTheEye) {
  Camera camera;
  camera.frame(kCloth, kWindow.x / kWindow.y);
  camera.lookAlong(camera.yaw() + 2.8F, 0);
  const auto arrow = edgeArrow(camera, kCloth, kWindow, 30);
  ASSERT_TRUE(arrow.has_value());
  EXPECT_LT(arrow->direction.x, 0);
  EXPECT_NEAR(glm::length(arrow->direction), 1, kRounding);
  EXPECT_GE(arrow->tip.y, 29.5F);
  EXPECT_LE(arrow->tip.y, kWindow.y - 29.5F);
}

TEST(Box, LeavesOutPositionsThatAreNotFinite) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::array<float, 9> xyz{0, 1, 2, nan, 0, 0, 3, -1, 5};
  const Box box = boxAround(xyz);
  EXPECT_EQ(box.low, glm::vec3(0, -1, 2));
  EXPECT_EQ(box.high, glm::vec3(3, 1, 5));
}

}  // namespace
}  // namespace tyg
