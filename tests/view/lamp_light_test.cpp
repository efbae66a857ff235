// Where light comes from, and where shadows fall.
#include "view/lamp_light.h"

#include <gtest/gtest.h>

namespace tyg {
namespace {

const Floor kGround{.at = {0, -1, 0}, .normal = {0, 1, 0}};
const Box kCloth{{-0.5F, 0, -0.5F}, {0.5F, 1, 0.5F}};

/// Where the shadow of a point falls, m.
glm::vec3 fallsTo(const FloorShadow& shadow, const glm::vec3& point) {
  const glm::vec4 at = shadow.projection * glm::vec4(point, 1);
  return shadow.middle + at.x / at.w * shadow.across + at.y / at.w * shadow.along;
}

void expectNear(const glm::vec3& is, const glm::vec3& wanted) {
  EXPECT_LT(glm::distance(is, wanted), 1e-5F) << is.x << ' ' << is.y << ' ' << is.z;
}

TEST(LampLight, ASceneWithoutLampsHasOneFromAbove) {
  const Lights lights = lightsOf({});
  ASSERT_EQ(lights.count, 1);
  EXPECT_GT(lights.lights[0].from.y, 0.5F);
  EXPECT_NEAR(glm::length(lights.lights[0].from), 1, 1e-6);
}

TEST(LampLight, LampsAreFarAwayOrAtAPlace) {
  const std::vector<Lamp> lamps{{.direction = {0, -2, 0}}, {.at = Vec3{1, 2, 3}, .colour = {0.5, 0, 1}}};
  const Lights lights = lightsOf(lamps);
  ASSERT_EQ(lights.count, 2);
  EXPECT_EQ(lights.lights[0].from, glm::vec4(0, 1, 0, 0));
  EXPECT_EQ(lightsOf(std::vector<Lamp>{{.direction = {0, -1e-30, 0}}}).lights[0].from, glm::vec4(0, 1, 0, 0));
  EXPECT_EQ(lights.lights[1].from, glm::vec4(1, 2, 3, 1));
  EXPECT_EQ(lights.lights[1].colour, glm::vec3(0.5F, 0, 1));
}

TEST(LampLight, AShadowLiesWhereTheLightOfAFarLampEnds) {
  const Light light{{glm::normalize(glm::vec3(-1, 2, 0.5F)), 0}, glm::vec3(1)};
  const auto shadow = shadowOn(kGround, light, kCloth, {});
  ASSERT_TRUE(shadow);
  for (const glm::vec3& corner : kCloth.corners()) {
    const glm::vec3 there = corner - (corner.y + 1) / light.from.y * glm::vec3(light.from);
    expectNear(fallsTo(*shadow, corner), there);
    const glm::vec4 inMask = shadow->projection * glm::vec4(corner, 1);
    EXPECT_LE(std::max(std::abs(inMask.x), std::abs(inMask.y)), 1.00001F * inMask.w) << "all of it is in the mask";
  }
}

TEST(LampLight, AShadowOfANearLampGrowsWithTheDistance) {
  const Light light{{0, 3, 0, 1}, glm::vec3(1)};
  const auto shadow = shadowOn(kGround, light, kCloth, {});
  ASSERT_TRUE(shadow);
  expectNear(fallsTo(*shadow, {0.5F, 1, 0}), {1, -1, 0});
  expectNear(fallsTo(*shadow, {0.5F, 0, 0}), {0.5F * 4 / 3, -1, 0});
}

TEST(LampLight, ATiltedFloorIsMetWhereItIs) {
  const Floor slope{.at = {0, -1, 0}, .normal = glm::normalize(glm::vec3(1, 1, 0))};
  const Light light{{0, 1, 0, 0}, glm::vec3(1)};
  const auto shadow = shadowOn(slope, light, kCloth, {});
  ASSERT_TRUE(shadow);
  expectNear(fallsTo(*shadow, {0.25F, 1, 0.5F}), {0.25F, -1.25F, 0.5F});
}

TEST(LampLight, ThereIsNoShadowOfALampBelowOrBesideAndNoneTooFarAway) {
  EXPECT_FALSE(shadowOn(kGround, {{0, -1, 0, 0}, glm::vec3(1)}, kCloth, {}));
  EXPECT_FALSE(shadowOn(kGround, {{0, 0.5F, 0, 1}, glm::vec3(1)}, kCloth, {}));
  EXPECT_FALSE(shadowOn(kGround, {{glm::normalize(glm::vec3(1, 0.01F, 0)), 0}, glm::vec3(1)}, kCloth, {}));
}

TEST(LampLight, TheMaskHoldsTheShadowsOfBodiesToo) {
  const std::vector<Body> bodies{{.shape = Shape::Plane, .at = {0, -1, 0}},
                                 {.shape = Shape::Ball, .at = {1, 0, 0}, .radius = 0.5}};
  const auto floor = floorOf(bodies, std::nullopt);
  ASSERT_TRUE(floor);
  const auto shadow = shadowOn(*floor, {{0, 1, 0, 0}, glm::vec3(1)}, kCloth, bodies);
  ASSERT_TRUE(shadow);
  const glm::vec4 rim = shadow->projection * glm::vec4(1.5F, 0, 0, 1);
  EXPECT_LE(std::max(std::abs(rim.x), std::abs(rim.y)), 1.00001F * rim.w);
}

TEST(LampLight, TheFloorIsAPlaneOfTheSceneElseTheGroundThatIsShown) {
  const std::vector<Body> bodies{{.shape = Shape::Ball}, {.shape = Shape::Plane, .at = {0, -2, 0}}};
  EXPECT_EQ(floorOf(bodies, -5.0F)->at.y, -2);
  EXPECT_EQ(floorOf({}, -5.0F)->at.y, -5);
  EXPECT_FALSE(floorOf({}, std::nullopt));
}

}  // namespace
}  // namespace tyg
