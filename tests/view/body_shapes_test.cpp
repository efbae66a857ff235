// Bodies as things to draw: closed meshes on the surfaces that the cloth touches, and what a view holds of them.
#include "view/body_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

namespace tyg {
namespace {

constexpr float kRounding = 1e-5F;  // single precision over a few products, lengths about 1 m

Body ball() { return {.shape = Shape::Ball, .at = {0.5, -1, 2}, .radius = 0.4, .name = "ball"}; }
Body capsule() { return {.shape = Shape::Capsule, .at = {1, 2, 3}, .axis = {0.6, -0.4, 0.2}, .radius = 0.3}; }
Body box() { return {.shape = Shape::Box, .at = {0, 1, 0}, .half = {0.3, 0.5, 0.7}, .radius = 0.1}; }
Body plane() { return {.shape = Shape::Plane, .at = {0, -1, 0}, .normal = {0.6, 0.8, 0}}; }
const Box kCloth{{-1, 0, 0}, {1, 0, 2}};

/// From the surface of a solid outward to a point in the world's axes, m.
float heightAbove(const Body& body, const glm::vec3& point) {
  const glm::vec3 at(body.at.x, body.at.y, body.at.z), axis(body.axis.x, body.axis.y, body.axis.z);
  glm::vec3 from = point - at;
  if (body.shape == Shape::Capsule) from -= std::clamp(glm::dot(from, axis) / glm::dot(axis, axis), 0.0F, 1.0F) * axis;
  if (body.shape == Shape::Box) {
    const glm::vec3 core = glm::vec3(body.half.x, body.half.y, body.half.z) - float(body.radius);
    from -= glm::clamp(from, -core, core);
  }
  return glm::length(from) - float(body.radius);
}

/// By the formulas of solid geometry, m3; a rounded box is its core with a layer around it.
double volumeOf(const Body& body) {
  const double r = body.radius, pi = std::numbers::pi, sphere = 4.0 / 3 * pi * r * r * r;
  if (body.shape == Shape::Capsule) return sphere + pi * r * r * std::hypot(body.axis.x, body.axis.y, body.axis.z);
  if (body.shape != Shape::Box) return sphere;
  const double a = 2 * (body.half.x - r), b = 2 * (body.half.y - r), c = 2 * (body.half.z - r);
  return sphere + a * b * c + 2 * r * (a * b + b * c + c * a) + pi * r * r * (a + b + c);
}

class BodySolid : public testing::TestWithParam<Body> {};

TEST_P(BodySolid, HasEachEdgeOnceInEachDirection) {
  const std::vector<SolidVertex> solid = bodySolid(GetParam(), 4);
  ASSERT_EQ(solid.size() % 3, 0U);
  using Corner = std::array<long, 3>;
  const auto cornerOf = [](const glm::vec3& p) {  // the same for places that differ by rounding
    return Corner{std::lround(p.x * 1e4F), std::lround(p.y * 1e4F), std::lround(p.z * 1e4F)};
  };
  std::map<std::pair<Corner, Corner>, int> edges;
  for (std::size_t k = 0; k < solid.size(); k += 3) {
    for (std::size_t side = 0; side < 3; ++side) {
      ++edges[{cornerOf(solid[k + side].position), cornerOf(solid[k + (side + 1) % 3].position)}];
    }
  }
  for (const auto& [edge, times] : edges) {
    EXPECT_EQ(times, 1);
    EXPECT_EQ(edges.count({edge.second, edge.first}), 1U);
  }
}

TEST_P(BodySolid, LiesOnTheSurfaceWithNormalsOutOfIt) {
  const Body& body = GetParam();
  const glm::mat4 model = bodyModel(body);
  const std::vector<SolidVertex> solid = bodySolid(body, 8);
  constexpr float kStep = 0.01F;  // m
  for (const SolidVertex& vertex : solid) {
    const glm::vec3 place(model * glm::vec4(vertex.position, 1)), normal(model * glm::vec4(vertex.normal, 0));
    EXPECT_NEAR(heightAbove(body, place), 0, kRounding);
    EXPECT_NEAR(heightAbove(body, place + kStep * normal), kStep, kRounding);
  }
  for (std::size_t k = 0; k < solid.size(); k += 3) {
    const glm::vec3 a = solid[k].position, b = solid[k + 1].position, c = solid[k + 2].position;
    EXPECT_GT(glm::dot(glm::cross(b - a, c - a), solid[k].normal + solid[k + 1].normal + solid[k + 2].normal), 0);
  }
}

TEST_P(BodySolid, HasTheVolumeOfTheBody) {
  const std::vector<SolidVertex> solid = bodySolid(GetParam(), 16);
  double six = 0;
  for (std::size_t k = 0; k < solid.size(); k += 3) {
    six += glm::dot(solid[k].position, glm::cross(solid[k + 1].position, solid[k + 2].position));
  }
  EXPECT_NEAR(six / 6, volumeOf(GetParam()), 0.005 * volumeOf(GetParam())) << "flat pieces lie a little inside";
}

std::string nameOf(const testing::TestParamInfo<Body>& body) {
  constexpr std::array kNames{"Plane", "Ball", "Capsule", "Box"};
  return kNames.at(static_cast<std::size_t>(body.param.shape));
}
INSTANTIATE_TEST_SUITE_P(Every, BodySolid, testing::Values(ball(), capsule(), box()), nameOf);

TEST(BodyShapes, AreWhereTheirMotionsHaveTakenThem) {
  Scene scene;
  scene.bodies = {ball(), box()};
  scene.moves = {{.what = {}, .velocity = {2, 0, 0}, .at = 1, .duration = 0.5, .body = "ball"}};
  std::vector<Body> bodies;
  for (const auto& [time, x] : {std::pair{0.0, 0.5}, {1.25, 1.0}, {9.0, 1.5}}) {
    placeBodies(scene, time, bodies);
    ASSERT_EQ(bodies.size(), 2U);
    EXPECT_NEAR(bodies[0].at.x, x, 1e-12);
    EXPECT_EQ(bodies[1], box());
  }
}

TEST(BodyShapes, AViewHoldsABodyThatIsNear) {
  std::vector<glm::vec3> points;
  addBodyPoints(std::array{ball()}, kCloth, points);
  const Box around = boxAround({&points[0].x, 3 * points.size()});
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(around.high[axis] - around.low[axis], 0.8, 0.05);
  EXPECT_NEAR(glm::distance(around.centre(), glm::vec3(0.5F, -1, 2)), 0, 0.05);
}

TEST(BodyShapes, AViewHoldsNothingThatWouldMakeTheClothTiny) {
  Body far = ball(), huge = ball();
  far.at = {100, 0, 0};
  huge.at = {0, -1000.5, 0}, huge.radius = 1000;
  Body deep = plane();
  deep.at = {0, -1000, 0};
  std::vector<glm::vec3> points;
  addBodyPoints(std::array{far}, kCloth, points);
  EXPECT_TRUE(points.empty());
  addBodyPoints(std::array{huge, deep}, kCloth, points);
  EXPECT_FALSE(points.empty());
  for (const glm::vec3& point : points) EXPECT_LT(glm::distance(point, kCloth.centre()), 3 * kCloth.size());
}

TEST(BodyShapes, AViewHoldsWhatOfAPlaneIsUnderTheCloth) {
  std::vector<glm::vec3> points;
  addBodyPoints(std::array{plane()}, kCloth, points);
  ASSERT_FALSE(points.empty());
  for (const glm::vec3& p : points) EXPECT_NEAR(0.6F * p.x + 0.8F * (p.y + 1), 0, kRounding);
}

TEST(BodyShapes, ThePatchOfAPlaneReachesUnderTheClothAndTheBodies) {
  Body away = ball();
  away.at = {8, 0, 0};
  const PlanePatch patch = patchOf(plane(), kCloth, std::array{plane(), away});
  EXPECT_NEAR(glm::distance(glm::cross(patch.across, patch.along), glm::vec3(0.6F, 0.8F, 0)), 0, kRounding);
  for (const glm::vec3& point : {kCloth.low, kCloth.high, glm::vec3(8, 0, 0)}) {
    const glm::vec3 from = point - patch.middle;
    EXPECT_LT(std::hypot(glm::dot(from, patch.across), glm::dot(from, patch.along)), patch.radius);
  }
  EXPECT_GT(patch.radius, patchOf(plane(), kCloth, {}).radius);
}

TEST(BodyShapes, AreDrawnFromNearerThanTheClothWhereTheyAreNearer) {
  Camera camera;
  camera.frame(kCloth, 1.6F);
  EXPECT_EQ(nearestWith(camera, {}), camera.nearest());
  const glm::vec3 close = camera.eye() + 0.5F * camera.forward();
  Body before = ball();
  before.at = {close.x, close.y, close.z};
  EXPECT_LT(nearestWith(camera, std::array{before}), 0.1F);
  EXPECT_GT(nearestWith(camera, std::array{before}), 0);
}

}  // namespace
}  // namespace tyg
