// Bodies in pictures by every kind of context: what they hide, what they do not hide, and whether they can be seen.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "gfx/contexts/offscreen.h"
#include "gfx/passes/sheet_renderer.h"
#include "start_points.h"

namespace tyg {
namespace {

constexpr glm::ivec2 kSize(320, 200);

Sheet flatSheet() {
  Sheet sheet;
  sheet.columns = sheet.rows = 21;
  sheet.spacing = 0.1;
  sheet.start = Start::Flat;
  return sheet;
}
Vec3 middleOf(std::span<const float> xyz) {
  const glm::vec3 middle = boxAround(xyz).centre();
  return {middle.x, middle.y, middle.z};
}
Body floorAt(double y) { return {.shape = Shape::Plane, .at = {0, y, 0}}; }
Body ballAt(const Vec3& at) { return {.shape = Shape::Ball, .at = at, .radius = 0.4}; }

/// Out of every picture: lines before bodies fade less with distance, and are compared with such lines.
const std::vector<Body> kElsewhere{ballAt({0, 1000, 0})};

/// Magenta lines on a ground without a grid.
DrawOptions lines() {
  DrawOptions options;
  options.ground = options.pins = false;
  options.mesh = rgb(0xff00ff);
  return options;
}
int magentaIn(const Picture& picture) {
  int count = 0;
  for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
    count += picture.rgba[i] > picture.rgba[i + 1] + 40 && picture.rgba[i + 2] > picture.rgba[i + 1] + 40 ? 1 : 0;
  }
  return count;
}

/// By WCAG 2: from 1 for equal colours to 21 for black on white.
double contrast(const Picture& a, const Picture& b, std::size_t i) {
  const auto luminance = [i](const Picture& picture) {
    const auto linear = [](int value) {
      const double share = value / 255.0;
      return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(picture.rgba[i]) + 0.7152 * linear(picture.rgba[i + 1]) +
           0.0722 * linear(picture.rgba[i + 2]);
  };
  const double one = luminance(a), other = luminance(b);
  return (std::max(one, other) + 0.05) / (std::min(one, other) + 0.05);
}

class BodyPicture : public testing::TestWithParam<OffscreenKind> {
 protected:
  std::unique_ptr<Offscreen> context_ = makeOffscreen(GetParam(), kSize.x, kSize.y);
  Sheet sheet_ = flatSheet();
  std::vector<float> xyz_ = startOf(sheet_);
  Camera camera_;
  DrawOptions options_ = lines();

  Picture draw(SheetRenderer& renderer, std::span<const Body> bodies) {
    DrawOptions options = options_;
    options.bodies = bodies;
    renderer.draw(xyz_, camera_, kSize, options);
    return context_->readPixels();
  }
  /// By a renderer of its own, of the cloth as seen at this pitch, radians.
  Picture picture(const std::vector<Body>& bodies, float pitch = -0.6F) {
    camera_.lookAlong(0.3F, pitch);
    camera_.frame(boxAround(xyz_), float(kSize.x) / float(kSize.y));
    SheetRenderer renderer(sheet_);
    return draw(renderer, bodies);
  }
};

TEST_P(BodyPicture, ABodyHidesTheLinesBehindItAndNoneBeforeIt) {
  const Vec3 middle = middleOf(xyz_);
  const int all = magentaIn(picture(kElsewhere));
  const glm::vec3 towardsEye = -camera_.forward();
  const auto ballBefore = [&](double way) {
    return ballAt({middle.x + way * towardsEye.x, middle.y + way * towardsEye.y, middle.z + way * towardsEye.z});
  };
  EXPECT_GT(all, 4000);
  EXPECT_LT(magentaIn(picture({ballBefore(1)})), 0.9 * all);
  EXPECT_NEAR(magentaIn(picture({ballBefore(-1)})), all, 0.005 * all);
}

TEST_P(BodyPicture, APlaneHidesWhatIsBelowItFromAboveAndNothingFromBelow) {
  const int above = magentaIn(picture(kElsewhere)), below = magentaIn(picture(kElsewhere, 0.6F));
  EXPECT_LT(magentaIn(picture({floorAt(0.3)})), 0.01 * above);
  EXPECT_NEAR(magentaIn(picture({floorAt(-0.3)}, 0.6F)), below, 0.005 * below);
}

TEST_P(BodyPicture, LinesOfAClothThatLiesOnAPlaneAreSeenAtEverySlant) {
  const double sunk = 0.05 * sheet_.spacing;  // a layer of contact
  for (const float pitch : {-1.5F, -0.6F, -0.2F}) {
    const int all = magentaIn(picture(kElsewhere, pitch));
    EXPECT_NEAR(magentaIn(picture({floorAt(sunk)}, pitch)), all, 0.005 * all) << pitch;
  }
}

TEST_P(BodyPicture, LinesOfAClothThatLiesOnABallAreSeen) {
  // The sheet drawn on the upper part of a ball, whose particles lie on its surface: the lines between them cut into
  // it.
  Body ball{.shape = Shape::Ball, .at = middleOf(xyz_), .radius = 1.2};
  for (std::size_t i = 0; i < xyz_.size(); i += 3) {
    const double x = 0.6 * (xyz_[i] - ball.at.x), z = 0.6 * (xyz_[i + 2] - ball.at.z);
    xyz_[i] = float(ball.at.x + x), xyz_[i + 2] = float(ball.at.z + z);
    xyz_[i + 1] = float(ball.at.y + std::sqrt(ball.radius * ball.radius - x * x - z * z));
  }
  const int all = magentaIn(picture(kElsewhere, -1.5F));
  EXPECT_GT(all, 4000);
  EXPECT_NEAR(magentaIn(picture({ball}, -1.5F)), all, 0.02 * all) << "soft edges mix with another colour";
}

TEST_P(BodyPicture, BodiesAndTheClothOnThemCanBeToldFromTheGroundInBothBackgrounds) {
  constexpr double kSeen = 1.25, kRead = 2;  // contrasts: of a large area, of lines
  const Vec3 middle = middleOf(xyz_);
  const std::vector<Body> ball{{.shape = Shape::Ball, .at = {middle.x, middle.y - 0.7, middle.z}, .radius = 0.6}};
  options_.mesh.reset();
  for (const Background background : {Background::Dark, Background::Light}) {
    options_.background = background;
    const Picture both = picture(ball);
    options_.structural = false;
    const Picture alone = picture(ball), empty = picture({});
    options_.structural = true;
    std::vector<double> ofBody, ofLines;
    for (std::size_t i = 0; i < alone.rgba.size(); i += 4) {
      if (contrast(alone, empty, i) < 1.05) continue;
      ofBody.push_back(contrast(alone, empty, i));
      if (contrast(both, alone, i) > 1.05) ofLines.push_back(contrast(both, alone, i));
    }
    ASSERT_GT(ofBody.size(), 2000U);
    ASSERT_GT(ofLines.size(), 500U);
    std::ranges::sort(ofBody), std::ranges::sort(ofLines);
    EXPECT_GT(ofBody[ofBody.size() / 10], kSeen);
    EXPECT_GT(ofLines[ofLines.size() / 2], kRead) << "half of the pixels of a line are its soft edge";
  }
}

TEST_P(BodyPicture, FollowsBodiesThatMoveOrChangeAndForgetsThoseThatGo) {
  const Vec3 middle = middleOf(xyz_);
  const Body first = ballAt({middle.x, middle.y + 0.5, middle.z});
  Body moved = first, larger = first;
  moved.at.x += 0.5, larger.radius = 0.6;
  (void)picture({});
  SheetRenderer kept(sheet_);
  for (const std::vector<Body>& bodies :
       {std::vector{first}, {moved}, {larger}, {floorAt(-1), first}, {}, {first, moved}, {}}) {
    const Picture seen = draw(kept, bodies);
    EXPECT_EQ(seen.rgba, picture(bodies).rgba);
    EXPECT_EQ(seen.rgba == picture({}).rgba, bodies.empty());
  }
}

TEST_P(BodyPicture, AGhostHasNoneOfItsOwn) {
  const std::vector<Body> bodies{ballAt(middleOf(xyz_)), floorAt(-0.5)};
  const auto ghostWith = [&](const std::vector<Body>& shown) {
    options_.structural = options_.over = false;
    (void)picture({});
    options_.structural = options_.over = true;
    return magentaIn(picture(shown));
  };
  const int all = ghostWith(kElsewhere);
  EXPECT_NEAR(ghostWith(bodies), all, 0.005 * all);
}

INSTANTIATE_TEST_SUITE_P(Every, BodyPicture, testing::ValuesIn(offscreenKinds().begin(), offscreenKinds().end()),
                         [](const auto& kind) { return std::string(nameOf(kind.param)); });

}  // namespace
}  // namespace tyg
