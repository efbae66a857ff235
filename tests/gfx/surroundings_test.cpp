// Surroundings that are kept from frame to frame are those that a frame of its own would show.
#include <gtest/gtest.h>

#include <vector>

#include "gfx/contexts/offscreen.h"
#include "gfx/passes/sheet_renderer.h"

namespace tyg {
namespace {

constexpr glm::ivec2 kSize(240, 160), kPart(200, 120);

class Surroundings : public testing::TestWithParam<OffscreenKind> {
 protected:
  Surroundings() {
    sheet_.columns = sheet_.rows = 8;
    sheet_.spacing = 0.1;
    for (int i = 0; i < sheet_.count(); ++i) {
      const Vec3 p = sheet_.startPosition(i);
      xyz_.insert(xyz_.end(), {float(p.x), float(p.y), float(p.z)});
    }
    camera_.frame(boxAround(xyz_), 1.5F);
  }
  Picture drawnBy(SheetRenderer& renderer, glm::ivec2 size = kSize) const {
    renderer.draw(xyz_, camera_, size, options_);
    return context_->readPixels();
  }
  /// Without what the frame before left in a part that this one does not draw.
  Picture drawnAnew(glm::ivec2 size = kSize) const {
    SheetRenderer renderer(sheet_);
    return drawnBy(renderer, size);
  }

  std::unique_ptr<Offscreen> context_ = makeOffscreen(GetParam(), kSize.x, kSize.y);
  Sheet sheet_;
  std::vector<float> xyz_;
  Camera camera_;
  DrawOptions options_;
};

TEST_P(Surroundings, AreTheSameInTheFirstFrameAndInEveryFrameOfACameraThatStands) {
  SheetRenderer renderer(sheet_);
  const Picture first = drawnBy(renderer);
  for (int frame = 0; frame < 4; ++frame) EXPECT_EQ(drawnBy(renderer).rgba, first.rgba) << frame;
}

TEST_P(Surroundings, FollowTheCameraTheColoursAndTheSizeAfterTheyWereKept) {
  SheetRenderer kept(sheet_);
  const auto follow = [&](const char* what, glm::ivec2 size = kSize) {
    for (int frame = 0; frame < 3; ++frame) {
      const Picture picture = drawnBy(kept, size);
      EXPECT_EQ(picture.rgba, drawnAnew(size).rgba) << what << ", frame " << frame;
    }
    return drawnBy(kept, size).rgba;
  };
  std::vector<std::vector<std::uint8_t>> seen{follow("at first")};
  camera_.turn(80, 10);
  seen.push_back(follow("turned"));
  camera_.approach(-2);
  seen.push_back(follow("farther"));
  options_.background = Background::Light;
  seen.push_back(follow("light"));
  options_.ground = false;
  seen.push_back(follow("no ground"));
  options_.ground = true;
  seen.push_back(follow("smaller", kPart));
  for (std::size_t k = 1; k < seen.size(); ++k) EXPECT_NE(seen[k], seen[k - 1]) << k;
}

INSTANTIATE_TEST_SUITE_P(Every, Surroundings, testing::ValuesIn(offscreenKinds().begin(), offscreenKinds().end()),
                         [](const auto& kind) { return std::string(nameOf(kind.param)); });

}  // namespace
}  // namespace tyg
