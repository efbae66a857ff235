// Finer sheets of the same cloth.
#include "study/motion/refinement.h"

#include <gtest/gtest.h>

#include "test_systems.h"
#include "tyg/methods.h"

namespace tyg::test {
namespace {

std::vector<SheetDistance> distances(Scene scene, const std::vector<Grid>& grids) {
  scene.tolerance = 1e-9;
  const SampledMotion motion = sampledRun(scene, findMethod("dopri54"), sampleTimes(scene));
  return sheetDistances(scene, motion, grids, 1, [](double) { return true; });
}

TEST(Refinement, AFallingSheetIsTheSameOnEveryGrid) {
  Scene scene = emptyWorld(3, 4);
  scene.gravity = {0.3, -9.81, 0};
  const std::vector<SheetDistance> found = distances(scene, {{5, 7}, {9, 13}});
  ASSERT_EQ(found.size(), 2U);
  for (const SheetDistance& sheet : found) EXPECT_LT(sheet.distance.largest, 1e-12);  // rounding
}

TEST(Refinement, AChainThatSagsUnderItsWeightDiffersByHowTheWeightIsSharedOut) {
  // At rest each link carries the weight below it. n links of stiffness k, particles of mass M/(n+1): the lowest
  // particle sags by sum_j j m g / k = M g n / (2 k). Twice the links in series, each still of stiffness k, sag twice
  // as far.
  Scene scene = hangingChain(4, 0.25, 0.02, {200, 0.5});
  scene.drag = 0.1;
  scene.duration = 20;
  const double weight = 5 * 0.02 * 9.81;
  const SheetDistance finer = distances(scene, {{1, 9}}).at(0);
  EXPECT_GE(finer.distance.largest, 0.95 * weight * 4 / (2 * 200));
}

TEST(Refinement, OnlySheetsThatHoldEveryParticleAreAllowed) {
  const Scene scene = emptyWorld(20, 10);
  EXPECT_NO_THROW(checkFiner(scene, {39, 19}));
  EXPECT_NO_THROW(checkFiner(scene, {58, 28}));
  for (const Grid& wrong : {Grid{40, 20}, {39, 28}, {10, 10}, {39, 10}, {1, 1}}) {
    EXPECT_THROW(checkFiner(scene, wrong), InputError) << wrong.columns << "x" << wrong.rows;
  }
  EXPECT_NO_THROW(checkFiner(emptyWorld(1, 20), {1, 39}));
  EXPECT_THROW(checkFiner(emptyWorld(1, 20), {2, 39}), InputError);
}

}  // namespace
}  // namespace tyg::test
