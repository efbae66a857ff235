// The picture of two motions of one cloth.
#include "app/output/two_cloths.h"

#include <gtest/gtest.h>

#include "tyg/methods.h"

namespace tyg {
namespace {

TEST(TwoCloths, AreShownLargeWhereTheyDifferThoughAPieceHasFallenFar) {
  const Scene written = loadScene("cut", methodNames());
  Scene reduced = written;
  reduced.dt *= 1.5;
  constexpr double kFallen = 2.5;  // s
  const Picture picture = overlaid({written, "as written"}, {reduced, "reduced"}, kFallen, "Cut", {640, 360});
  int red = 0;
  for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
    red += picture.rgba[i] > picture.rgba[i + 1] + 40 && picture.rgba[i] > picture.rgba[i + 2] + 40 ? 1 : 0;
  }
  EXPECT_GT(red, 640 * 360 / 40);
}

}  // namespace
}  // namespace tyg
