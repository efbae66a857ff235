// Programs that several renderers share.
#include "gfx/passes/programs.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "gfx/contexts/offscreen.h"
#include "gfx/passes/sheet_renderer.h"

namespace tyg {
namespace {

constexpr glm::ivec2 kSize(160, 120);

TEST(Programs, AreMadeOnceForEachTextAndItsDefines) {
  const auto context = makeOffscreen(kSize.x, kSize.y);
  Programs programs;
  const GlProgram& plain = programs.get("surface", "#define PLAIN\n");
  EXPECT_NE(&plain, &programs.get("surface"));
  EXPECT_NE(&plain, &programs.get("lines"));
  EXPECT_EQ(&plain, &programs.get("surface", "#define PLAIN\n"));
  EXPECT_THROW((void)programs.get("no such shader"), std::runtime_error);
}

TEST(Programs, ThatAreSharedDrawTheSamePicturesAsThoseOfEachRenderer) {
  const auto context = makeOffscreen(kSize.x, kSize.y);
  struct Drawn {
    Sheet sheet;
    DrawOptions options;
    std::vector<float> xyz;
  };
  const std::vector<Body> bodies{{.shape = Shape::Ball, .radius = 0.3}, {.shape = Shape::Plane, .at = {0, -1, 0}}};
  std::vector<Drawn> all(3);
  for (std::size_t k = 0; k < all.size(); ++k) {
    Drawn& drawn = all[k];
    drawn.sheet.columns = drawn.sheet.rows = 6 + 3 * int(k);
    drawn.sheet.spacing = 1.0 / (drawn.sheet.columns - 1);
    drawn.options.shear = drawn.options.particles = k == 1;
    drawn.options.show = k == 1 ? Show::Lines : Show::Surface;
    if (k == 2) drawn.options.bodies = bodies;
    for (int i = 0; i < drawn.sheet.count(); ++i) {
      const Vec3 p = drawn.sheet.startPosition(i);
      drawn.xyz.insert(drawn.xyz.end(), {float(p.x), float(p.y), float(p.z)});
    }
  }
  const auto pictureOf = [&](const Drawn& drawn, SheetRenderer& renderer) {
    Camera camera;
    camera.frame(boxAround(drawn.xyz), float(kSize.x) / float(kSize.y));
    renderer.draw(drawn.xyz, camera, kSize, drawn.options);
    return context->readPixels().rgba;
  };
  const auto programs = std::make_shared<Programs>();
  for (int turn = 0; turn < 2; ++turn) {
    for (const Drawn& drawn : all) {
      SheetRenderer shared(drawn.sheet, programs), own(drawn.sheet);
      EXPECT_EQ(pictureOf(drawn, shared), pictureOf(drawn, own)) << drawn.sheet.columns;
    }
  }
}

}  // namespace
}  // namespace tyg
