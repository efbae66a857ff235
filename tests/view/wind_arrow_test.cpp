// The arrow of a wind: a closed solid, along the wind, in the free part of the picture.
#include "view/wind_arrow.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tyg {
namespace {

TEST(WindArrow, IsAClosedSolidOfLengthOneWithNormalsThatPointOutward) {
  const std::vector<SolidVertex> arrow = arrowSolid();
  ASSERT_EQ(arrow.size() % 3, 0U);
  glm::vec3 sum(0), low(1), high(-1);
  for (std::size_t k = 0; k < arrow.size(); k += 3) {
    const glm::vec3 a = arrow[k].position, b = arrow[k + 1].position, c = arrow[k + 2].position;
    sum += glm::cross(b - a, c - a);
    for (std::size_t corner = k; corner < k + 3; ++corner) {
      EXPECT_NEAR(glm::length(arrow[corner].normal), 1, 1e-5);
      const glm::vec3 across(0, arrow[corner].normal.y, arrow[corner].normal.z);
      EXPECT_GE(glm::dot(across, arrow[corner].position), -1e-6);
      low = glm::min(low, arrow[corner].position), high = glm::max(high, arrow[corner].position);
    }
  }
  EXPECT_NEAR(glm::length(sum), 0, 1e-5) << "the areas of a closed surface cancel";
  EXPECT_FLOAT_EQ(high.x - low.x, 1);
}

TEST(WindArrow, PointsAlongTheWindAndGrowsWithItsSpeedWithinLimits) {
  float before = 0;
  for (const double speed : {0.1, 1.0, 10.0, 100.0, 1e6}) {
    const glm::mat4 model = windArrowModel({.velocity = {0, 0, -speed}});
    const glm::vec3 along(model * glm::vec4(1, 0, 0, 0));
    EXPECT_NEAR(along.z, -glm::length(along), 1e-6);
    EXPECT_GT(glm::length(along), before);
    EXPECT_LE(glm::length(along), ShownWind{}.longest);
    before = glm::length(along);
  }
}

TEST(WindArrow, StaysFiniteWithoutAWind) {
  const glm::mat4 model = windArrowModel({});
  for (int k = 0; k < 4; ++k) {
    for (int row = 0; row < 4; ++row) EXPECT_TRUE(std::isfinite(model[k][row]));
  }
}

}  // namespace
}  // namespace tyg
