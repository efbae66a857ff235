// Surfaces in pictures by every kind of context: what light, shadows, cuts, patterns and lines do to their pixels.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "files.h"
#include "gfx/contexts/offscreen.h"
#include "gfx/passes/sheet_renderer.h"
#include "start_points.h"
#include "view/picking.h"

namespace tyg {
namespace {

constexpr glm::ivec2 kSize(320, 200);

/// A sheet of two metres a side in the x-y plane, which faces a camera that looks along -z.
Sheet upright(int particles = 21) {
  Sheet sheet;
  sheet.columns = sheet.rows = particles;
  sheet.spacing = 2.0 / (particles - 1);
  return sheet;
}

class SurfacePicture : public testing::TestWithParam<OffscreenKind> {
 protected:
  std::unique_ptr<Offscreen> context_ = makeOffscreen(GetParam(), kSize.x, kSize.y);
  Sheet sheet_ = upright();
  std::vector<float> xyz_ = startOf(sheet_);
  glm::vec3 middle_ = boxAround(xyz_).centre();
  Look look_{.colour = Vec3{0.6, 0.6, 0.6}};
  std::vector<Lamp> lamps_;
  std::vector<Body> bodies_;
  Camera camera_;
  DrawOptions options_{.show = Show::Surface, .pins = false, .ground = false};

  void look(float yaw, float pitch = 0) {
    camera_.lookAlong(yaw, pitch);
    camera_.watch(boxAround(xyz_));
    camera_.frame(boxAround(xyz_), float(kSize.x) / float(kSize.y));
  }
  Picture picture() {
    DrawOptions options = options_;
    options.look = &look_, options.lamps = lamps_, options.bodies = bodies_;
    camera_.watch(boxAround(xyz_));
    SheetRenderer renderer(sheet_);
    renderer.draw(xyz_, camera_, kSize, options);
    return context_->readPixels();
  }
  /// The pixel in which a point (m) is seen.
  [[nodiscard]] glm::ivec3 at(const Picture& picture, const glm::vec3& point) const {
    const glm::ivec2 place = placeInWindow(camera_, point, glm::vec2(kSize));
    const std::size_t i = 4 * (std::size_t(place.y) * std::size_t(kSize.x) + std::size_t(place.x));
    return {picture.rgba.at(i), picture.rgba.at(i + 1), picture.rgba.at(i + 2)};
  }
  [[nodiscard]] int brightness(const Picture& picture, const glm::vec3& point) const {
    const glm::ivec3 colour = at(picture, point);
    return colour.r + colour.g + colour.b;
  }
  int brightnessOfMiddle() { return brightness(picture(), middle_); }
};

TEST_P(SurfacePicture, TheSideTowardsTheLampIsBrighterSeenFromEitherSide) {
  for (const float yaw : {0.0F, 3.14159F}) {
    look(yaw);
    const glm::vec3 forward = camera_.forward();
    lamps_ = {{.direction = {forward.x, forward.y, forward.z}}};
    const int lit = brightnessOfMiddle();
    lamps_ = {{.direction = {-forward.x, -forward.y, -forward.z}}};
    const int unlit = brightnessOfMiddle();
    EXPECT_GT(lit, unlit + 100);
    EXPECT_GT(unlit, 100) << "some light comes through, and nothing is black";
  }
}

TEST_P(SurfacePicture, LightFollowsTheNormalOfEachPixel) {
  for (std::size_t i = 0; i < xyz_.size(); i += 3) {  // half of a cylinder, which bulges towards the eye
    const float angle = (xyz_[i] - middle_.x) * 1.5F;
    xyz_[i] = std::sin(angle), xyz_[i + 2] = std::cos(angle);
  }
  look(0);
  lamps_ = {{.direction = {-1, 0, -1}}};  // from the right and the front
  const Picture seen = picture();
  const auto onCylinder = [&](float angle) { return brightness(seen, {std::sin(angle), middle_.y, std::cos(angle)}); };
  EXPECT_GT(onCylinder(0.7F), onCylinder(0.1F));
  EXPECT_GT(onCylinder(0.1F), onCylinder(-0.5F));
  EXPECT_GT(onCylinder(-0.5F), onCylinder(-1.1F));
  const int first = onCylinder(0), second = onCylinder(0.04F);
  EXPECT_LE(std::abs(first - second), 12) << "no facets";
}

TEST_P(SurfacePicture, LampsHaveColoursAndPlacesAndBodiesTakeTheSameLight) {
  look(0);
  lamps_ = {{.direction = {0, 0, -1}, .colour = {1, 0, 0}}};
  EXPECT_GT(at(picture(), middle_).r, at(picture(), middle_).g + 60);
  lamps_ = {{.at = Vec3{middle_.x - 1, middle_.y, middle_.z + 0.5}}};
  const Picture besideLamp = picture();
  EXPECT_GT(brightness(besideLamp, middle_ - glm::vec3(0.8F, 0, 0)),
            brightness(besideLamp, middle_ + glm::vec3(0.8F, 0, 0)) + 60);
  bodies_ = {{.shape = Shape::Ball, .at = {middle_.x, middle_.y, middle_.z + 1}, .radius = 0.5}};
  const glm::vec3 onBall = middle_ + glm::vec3(0, 0, 1.5F);
  lamps_ = {{.direction = {0, 0, -1}, .colour = {0, 0, 1}}};
  EXPECT_GT(at(picture(), onBall).b, at(picture(), onBall).r + 20);
}

/// The sheet is level then, at y = 0.
std::vector<float> levelled(std::vector<float> xyz) {
  for (std::size_t i = 0; i < xyz.size(); i += 3) std::swap(xyz[i + 1], xyz[i + 2]);
  return xyz;
}

TEST_P(SurfacePicture, TheShadowLiesWhereTheLightIsKeptFromTheFloor) {
  xyz_ = levelled(xyz_);
  bodies_ = {{.shape = Shape::Plane, .at = {0, -1, 0}}};
  options_.background = Background::Light;
  const glm::vec3 middle = boxAround(xyz_).centre();
  look(0, -0.7F);
  camera_.approach(-6);
  lamps_ = {{.direction = {1, -1, 0}}};  // its shadow lies one metre to the right
  const Picture with = picture();
  options_.show = Show::Lines, options_.structural = false;
  const Picture without = picture();
  const auto darker = [&](float right, float back) {
    const glm::vec3 there(middle.x + right, -0.99F, middle.z - back);
    return brightness(without, there) - brightness(with, there);
  };
  EXPECT_GT(darker(1.7F, 0), 60);
  EXPECT_GT(darker(1.2F, -0.9F), 60);
  EXPECT_EQ(darker(2.4F, 0), 0);
  EXPECT_EQ(darker(-1.6F, 0), 0) << "beside the cloth, away from its shadow";
  lamps_.front().colour = {0, 0, 0};
  options_.show = Show::Surface;
  EXPECT_EQ(brightness(picture(), {middle.x + 1.7F, -0.99F, middle.z}),
            brightness(without, {middle.x + 1.7F, -0.99F, middle.z}))
      << "a lamp that does not shine";
}

TEST_P(SurfacePicture, TheGroundTakesAShadowOnlyWhileItIsShownAndSeenFromAbove) {
  xyz_ = levelled(xyz_);
  lamps_ = {{.direction = {0, -1, 0}}};
  options_.background = Background::Light;
  const glm::vec3 middle = boxAround(xyz_).centre();
  const glm::vec3 below(middle.x, -2.6F, middle.z - 0.8F);  // 1.3 sides below the start
  const auto darkerBelow = [&](float pitch, bool ground) {
    options_.ground = ground;
    look(0, pitch);
    camera_.approach(-16);
    options_.show = Show::Surface;
    const int with = brightness(picture(), below);
    options_.show = Show::Lines, options_.structural = false;
    return brightness(picture(), below) - with;
  };
  EXPECT_GT(darkerBelow(-0.25F, true), 60);
  EXPECT_EQ(darkerBelow(-0.25F, false), 0);
  EXPECT_EQ(darkerBelow(0.6F, true), 0);
}

TEST_P(SurfacePicture, WhatIsBelowTheFloorCastsNoShadowOnIt) {
  xyz_ = levelled(xyz_);
  lamps_ = {{.direction = {0, -1, 0}}};
  bodies_ = {{.shape = Shape::Plane, .at = {0, 0.5, 0}}};
  look(0, -1.2F);
  const auto hidden = picture().rgba;
  options_.show = Show::Lines, options_.structural = false;
  EXPECT_EQ(hidden, picture().rgba);
}

TEST_P(SurfacePicture, ACutThatOpensShowsWhatIsBehind) {
  look(0);
  sheet_.missing = sheet_.missing.withCut(21, 21, {10.5, -1, 10.5, 21});
  const glm::ivec3 background = at(picture(), middle_ + glm::vec3(1.3F, 0, 0));
  const glm::vec3 cut = middle_ + glm::vec3(0.05F, 0, 0);
  EXPECT_NE(at(picture(), cut), background) << "closed, it is cloth";
  for (int i = 0; i < sheet_.count(); ++i) {
    if (i % 21 > 10) xyz_[3 * std::size_t(i)] += 0.3F;
  }
  const Picture open = picture();
  EXPECT_EQ(at(open, middle_ + glm::vec3(0.2F, 0, 0)), background);
  EXPECT_EQ(at(open, middle_ + glm::vec3(0.2F, 0.7F, 0)), background);
  EXPECT_NE(at(open, middle_ + glm::vec3(0.03F, 0, 0)), background) << "half a cell on this side ...";
  EXPECT_NE(at(open, middle_ + glm::vec3(0.37F, 0, 0)), background) << "... and on that one";
}

TEST_P(SurfacePicture, AWeaveIsSeenFromNearAndFadesBeforeItIsTooFine) {
  const auto unevenness = [&](Weave weave) {
    look_.weave = weave;
    const Picture seen = picture();
    int least = 1000, most = 0;
    for (int step = -20; step <= 20; ++step) {
      const int here = brightness(seen, middle_ + glm::vec3(float(step) * 0.004F, float(step) * 0.005F, 0));
      least = std::min(least, here), most = std::max(most, here);
    }
    return most - least;
  };
  look(0);
  EXPECT_LE(unevenness(Weave::None), 6);
  EXPECT_LE(unevenness(Weave::Plain), 12) << "threads of a pixel and less";
  camera_.approach(14);
  EXPECT_GT(unevenness(Weave::Plain), 60);
}

TEST_P(SurfacePicture, ChecksAreDarkBrightAndBetween) {
  look_ = {.colour = Vec3{0.7, 0, 0}, .weave = Weave::Checker};
  look(0);
  const Picture seen = picture();
  const auto greenAt = [&](int check, int row) {  // twelve a side; at the upper left a dark one
    const glm::vec3 corner = glm::vec3(middle_.x - 1, middle_.y + 1, 0);
    return at(seen, corner + glm::vec3((float(check) + 0.5F) / 6, -(float(row) + 0.5F) / 6, 0)).g;
  };
  EXPECT_LT(greenAt(4, 4), 20);
  EXPECT_GT(greenAt(5, 5), 120);
  EXPECT_GT(greenAt(4, 5), greenAt(4, 4) + 40);
  EXPECT_LT(greenAt(5, 4), greenAt(5, 5) - 40);
}

TEST_P(SurfacePicture, APictureLiesOnTheClothWithItsUpperRowAbove) {
  const Folder folder;
  Picture image{.width = 64, .height = 64, .rgba = {}};
  for (int i = 0; i < 64 * 64; ++i) {
    const bool upper = i / 64 < 32, left = i % 64 < 32;
    for (const int part : {upper ? 220 : 0, left ? 220 : 0, 0, 255}) image.rgba.push_back(std::uint8_t(part));
  }
  writePng(image, folder / "image.png");
  look_ = {.colour = Vec3{0, 0, 1}, .image = (folder / "image.png").string()};
  look(0);
  const Picture seen = picture();
  const glm::ivec3 upperLeft = at(seen, middle_ + glm::vec3(-0.5F, 0.5F, 0));
  const glm::ivec3 lowerLeft = at(seen, middle_ + glm::vec3(-0.5F, -0.5F, 0));
  const glm::ivec3 upperRight = at(seen, middle_ + glm::vec3(0.5F, 0.5F, 0));
  EXPECT_GT(std::min(upperLeft.r, upperLeft.g), 90);
  EXPECT_LT(lowerLeft.r, 10);
  EXPECT_GT(lowerLeft.g, 90);
  EXPECT_GT(upperRight.r, 90);
  EXPECT_LT(upperRight.g, 10);
  look_.image = (folder / "none.png").string();
  EXPECT_GT(at(picture(), middle_).b, 90) << "without a picture the cloth has its colour";
}

TEST_P(SurfacePicture, NumbersColourTheSurfaceAsTheyColourLines) {
  std::vector<float> values;
  for (int i = 0; i < sheet_.count(); ++i) values.push_back(float(i % 21));
  options_.colouring = {.by = Colouring::By::Particle, .ramp = Ramp::Balanced, .low = 0, .high = 20, .values = values};
  look(0);
  const Picture byNumber = picture();
  const glm::ivec3 little = at(byNumber, middle_ - glm::vec3(0.9F, 0, 0));
  const glm::ivec3 much = at(byNumber, middle_ + glm::vec3(0.9F, 0, 0));
  EXPECT_GT(little.b, little.r + 60);
  EXPECT_GT(much.r, much.b + 60);
  for (std::size_t i = 0; i < xyz_.size(); i += 3) xyz_[i] *= xyz_[i] > middle_.x ? 1.1F : 1;
  options_.colouring = {.by = Colouring::By::Strain, .ramp = Ramp::Balanced, .low = -0.1F, .high = 0.1F, .values = {}};
  look(0);
  const Picture byStrain = picture();
  const glm::vec3 right(middle_.x + 0.8F, middle_.y, 0), left(middle_.x - 0.6F, middle_.y, 0);
  EXPECT_GT(at(byStrain, right).r, at(byStrain, right).b + 60);
  EXPECT_LT(std::abs(at(byStrain, left).r - at(byStrain, left).b), 40);
}

TEST_P(SurfacePicture, LinesOnASurfaceAreSeenWholeFromBothSidesAndAtASlant) {
  sheet_ = upright(6);  // its lines are far apart at every slant
  xyz_ = startOf(sheet_);
  options_.mesh = rgb(0xff00ff);
  look_.colour = Vec3{0.08, 0.09, 0.12};  // as the ground
  const auto magenta = [](const Picture& picture) {
    int count = 0;
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
      count += picture.rgba[i] > picture.rgba[i + 1] + 20 && picture.rgba[i + 2] > picture.rgba[i + 1] + 20 ? 1 : 0;
    }
    return count;
  };
  for (const float yaw : {0.0F, 0.8F, 1.4F, 3.14159F, 3.9F}) {
    look(yaw);
    options_.show = Show::Lines;
    options_.opacity = 0.55F;
    const int alone = magenta(picture());
    options_.show = Show::Both;
    options_.opacity = 1;
    EXPECT_NEAR(magenta(picture()), alone, 0.12 * alone) << yaw;
    options_.show = Show::Surface;
    EXPECT_EQ(magenta(picture()), 0) << yaw;
  }
}

TEST_P(SurfacePicture, AChainHasNoSurfaceAndIsDrawnAsLines) {
  sheet_.columns = 1;
  xyz_ = startOf(sheet_);
  look(0);
  const Picture asSurface = picture();
  options_.show = Show::Lines;
  EXPECT_EQ(asSurface.rgba, picture().rgba);
}

TEST_P(SurfacePicture, LinesAreTheSameWhateverTheLookIs) {
  options_.show = Show::Lines, options_.ground = true;
  look(0.4F, -0.3F);
  const Picture plain = picture();
  look_ = {.colour = Vec3{1, 0, 0}, .weave = Weave::Plain};
  lamps_ = {{.direction = {1, -1, 0}, .colour = {1, 0, 0}}};
  EXPECT_EQ(picture().rgba, plain.rgba);
}

INSTANTIATE_TEST_SUITE_P(Every, SurfacePicture, testing::ValuesIn(offscreenKinds().begin(), offscreenKinds().end()),
                         [](const auto& kind) { return std::string(nameOf(kind.param)); });

}  // namespace
}  // namespace tyg
