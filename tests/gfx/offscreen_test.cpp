// Pictures drawn off-screen by every kind of context that this build has, compared with stored ones and each other.
// TYG_STORE_PICTURES=1 in the environment writes the stored pictures anew (look at them before you keep them).
#include "gfx/contexts/offscreen.h"

#include <glad/gl.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <vector>

#include "files.h"
#include "gfx/contexts/compute_context.h"
#include "gfx/passes/sheet_renderer.h"

namespace tyg {
namespace {

constexpr int kWidth = 320, kHeight = 200;
// Drivers differ in how they round at edges: single pixels may differ by much, the picture as a whole may not.
constexpr double kMeanDifference = 1.0;  // of 255, over all pixels and colours
constexpr int kClearlyOther = 48;        // of 255
constexpr double kShareClearlyOther = 0.01;

Sheet hangingSheet() {
  Sheet sheet;
  sheet.columns = sheet.rows = 12;
  sheet.spacing = 0.1;
  sheet.pins = {0, 11};
  return sheet;
}

/// A made-up wave, so that the picture depends on nothing but the drawing.
std::vector<float> waveOf(const Sheet& sheet) {
  std::vector<float> xyz;
  for (int i = 0; i < sheet.count(); ++i) {
    const Vec3 p = sheet.startPosition(i);
    const double swell = -p.y * p.y * 0.3 + 0.1 * std::sin(6 * p.x) * -p.y;
    xyz.insert(xyz.end(), {float(p.x), float(p.y), float(swell)});
  }
  return xyz;
}

/// The sheet and its wave in a unit of length of 1/unit metres.
Picture drawnInUnits(OffscreenKind kind, float unit) {
  const auto context = makeOffscreen(kind, kWidth, kHeight);
  Sheet sheet = hangingSheet();
  std::vector<float> xyz = waveOf(sheet);
  for (float& coordinate : xyz) coordinate *= unit;
  sheet.spacing *= unit;
  SheetRenderer renderer(sheet);
  Camera camera;
  camera.frame(boxAround(xyz), float(kWidth) / kHeight);
  renderer.draw(xyz, camera, {kWidth, kHeight}, {});
  return context->readPixels();
}

Picture drawn(OffscreenKind kind, const DrawOptions& options, const std::optional<ShownPush>& push = std::nullopt) {
  const auto context = makeOffscreen(kind, kWidth, kHeight);
  const Sheet sheet = hangingSheet();
  SheetRenderer renderer(sheet);
  const std::vector<float> xyz = waveOf(sheet);
  Camera camera;
  camera.frame(boxAround(xyz), float(kWidth) / kHeight);
  renderer.draw(xyz, camera, {kWidth, kHeight}, options, push);
  return context->readPixels();
}

TEST(SheetRenderer, RefusesASheetThatTheDriverCannotHoldAndSaysHowLargeItMayBe) {
  const auto context = makeOffscreen(kWidth, kHeight);
  Sheet sheet = hangingSheet();
  sheet.columns = sheet.rows = 40000;
  try {
    const SheetRenderer renderer(sheet);
    FAIL() << "a sheet of 1.6e9 particles was taken";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).rfind("sheet: found 1600000000 particles, allowed: up to ", 0), 0U)
        << error.what();
  }
}

const ShownPush kPush{.particle = 66, .force = {0.5, 0, 2}};
DrawOptions everything() {
  DrawOptions options;
  options.shear = options.bend = options.particles = true;
  options.background = Background::Light;
  return options;
}

void expectAlike(const Picture& a, const Picture& b) {
  ASSERT_EQ(a.width, b.width);
  ASSERT_EQ(a.height, b.height);
  double sum = 0;
  int other = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) {
    const int difference = std::abs(int(a.rgba[i]) - int(b.rgba[i]));
    sum += difference;
    other += difference > kClearlyOther ? 1 : 0;
  }
  EXPECT_LT(sum / double(a.rgba.size()), kMeanDifference);
  EXPECT_LT(other / double(a.rgba.size()), kShareClearlyOther);
}

int pixelsThatDiffer(const Picture& a, const Picture& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
    count += std::abs(a.rgba[i] - b.rgba[i]) + std::abs(a.rgba[i + 2] - b.rgba[i + 2]) > 20 ? 1 : 0;
  }
  return count;
}

class OffscreenPicture : public testing::TestWithParam<OffscreenKind> {};

TEST_P(OffscreenPicture, LooksLikeTheStoredOnes) {
  const std::filesystem::path folder = TYG_SOURCE_DIR "/tests/gfx";
  for (const auto& [file, options, push] :
       {std::tuple{"plain.png", DrawOptions{}, std::optional<ShownPush>{}}, {"everything.png", everything(), kPush}}) {
    const Picture picture = drawn(GetParam(), options, push);
    if (std::getenv("TYG_STORE_PICTURES") != nullptr) writePng(picture, folder / file);
    SCOPED_TRACE(file);
    expectAlike(picture, readPicture(folder / file));
  }
}

TEST_P(OffscreenPicture, IsTheSameForAClothOfMicrometresAndOneOfMegametres) {
  const Picture usual = drawnInUnits(GetParam(), 1);
  for (const float unit : {1e-6F, 1e6F}) {
    SCOPED_TRACE(unit);
    expectAlike(drawnInUnits(GetParam(), unit), usual);
  }
}

TEST_P(OffscreenPicture, ShowsAWindByAnArrowThatPointsItsWayInBothBackgrounds) {
  for (const Background background : {Background::Dark, Background::Light}) {
    DrawOptions calm;
    calm.structural = calm.pins = calm.ground = false, calm.background = background;
    DrawOptions windy = calm;
    windy.wind = ShownWind{.velocity = {8, 0, 0}, .at = {0.5F, 0.5F}};
    const Picture without = drawn(GetParam(), calm), with = drawn(GetParam(), windy);
    const int pixels = pixelsThatDiffer(without, with);
    EXPECT_GT(pixels, 20);
    EXPECT_LT(pixels, kWidth * kHeight / 20);
    windy.wind->velocity = {-8, 0, 0};
    EXPECT_GT(pixelsThatDiffer(drawn(GetParam(), windy), with), pixels / 4) << "its head is at the other end";
    windy.over = true;
    calm.over = true;
    EXPECT_EQ(pixelsThatDiffer(drawn(GetParam(), windy), drawn(GetParam(), calm)), 0) << "a ghost has none of its own";
  }
}

TEST_P(OffscreenPicture, ShowsEachThingThatIsSwitchedOn) {
  DrawOptions nothing;
  nothing.structural = nothing.pins = false;
  const Picture empty = drawn(GetParam(), nothing);
  const auto shows = [&](bool DrawOptions::*thing) {
    DrawOptions options = nothing;
    options.*thing = true;
    return pixelsThatDiffer(empty, drawn(GetParam(), options));
  };
  EXPECT_GT(shows(&DrawOptions::structural), 2000);
  EXPECT_GT(shows(&DrawOptions::shear), 2000);
  EXPECT_GT(shows(&DrawOptions::bend), 1000);
  EXPECT_GT(shows(&DrawOptions::particles), 144);
  EXPECT_GT(shows(&DrawOptions::pins), 40);
  EXPECT_GT(pixelsThatDiffer(empty, drawn(GetParam(), nothing, kPush)), 100);
}

TEST_P(OffscreenPicture, ASecondSheetIsDrawnOverTheFirstInItsOwnColour) {
  const auto context = makeOffscreen(GetParam(), kWidth, kHeight);
  const Sheet sheet = hangingSheet();
  SheetRenderer first(sheet), second(sheet);
  std::vector<float> xyz = waveOf(sheet);
  Camera camera;
  camera.frame(boxAround(xyz), float(kWidth) / kHeight);
  const auto pixelsOf = [&](bool (*isColour)(int red, int green, int blue)) {
    const Picture picture = context->readPixels();
    int count = 0;
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
      count += isColour(picture.rgba[i], picture.rgba[i + 1], picture.rgba[i + 2]) ? 1 : 0;
    }
    return count;
  };
  const auto isGreen = [](int red, int green, int blue) { return green > red + 60 && green > blue + 60; };
  const auto isMagenta = [](int red, int green, int blue) { return red > green + 60 && blue > green + 60; };
  DrawOptions options;
  options.mesh = rgb(0xff00ff);
  first.draw(xyz, camera, {kWidth, kHeight}, options);
  const int magenta = pixelsOf(isMagenta);
  EXPECT_GT(magenta, 1000);
  for (std::size_t i = 0; i < xyz.size(); i += 3) xyz[i] += 0.05F;  // half a mesh aside
  options.mesh = rgb(0x00ff00);
  options.over = true;
  second.draw(xyz, camera, {kWidth, kHeight}, options);
  EXPECT_GT(pixelsOf(isGreen), 1000);
  EXPECT_GT(pixelsOf(isMagenta), magenta / 4);
}

/// Of the pixels of columns [from, to): red minus blue, summed.
double warmth(const Picture& picture, int from, int to) {
  double sum = 0;
  for (int row = 0; row < picture.height; ++row) {
    for (int column = from; column < to; ++column) {
      const std::size_t i = 4 * static_cast<std::size_t>(row * picture.width + column);
      sum += picture.rgba[i] - picture.rgba[i + 2];
    }
  }
  return sum;
}

TEST_P(OffscreenPicture, NumbersOfTheParticlesColourTheLinesBetweenThem) {
  const Sheet sheet = hangingSheet();
  std::vector<float> values;
  values.reserve(static_cast<std::size_t>(sheet.count()));
  for (int i = 0; i < sheet.count(); ++i) values.push_back(float(i % sheet.columns));
  DrawOptions options;
  options.pins = options.ground = false;
  options.colouring = {.by = Colouring::By::Particle, .ramp = Ramp::Growing, .low = 0, .high = 11, .values = values};
  const Picture coloured = drawn(GetParam(), options);
  // The ramp on dark ground ends in yellow.
  EXPECT_GT(warmth(coloured, kWidth / 2, kWidth), warmth(coloured, 0, kWidth / 2) + 1e5);
  options.colouring.values = {};  // a number for nobody
  EXPECT_LT(warmth(drawn(GetParam(), options), kWidth / 2, kWidth), 0);
}

TEST_P(OffscreenPicture, StrainColoursStretchedLinesWarmAndSlackOnesCold) {
  DrawOptions options;
  options.pins = options.ground = false;
  options.colouring = {.by = Colouring::By::Strain, .ramp = Ramp::Balanced, .low = 0.5, .high = 2, .values = {}};
  EXPECT_LT(warmth(drawn(GetParam(), options), 0, kWidth), 0);  // all of it below the middle of that range
  options.colouring.low = -2, options.colouring.high = -0.5;
  EXPECT_GT(warmth(drawn(GetParam(), options), 0, kWidth), 0);
}

TEST_P(OffscreenPicture, AClothCanBeTranslucent) {
  DrawOptions nothing, faint, full;
  nothing.structural = nothing.pins = faint.pins = full.pins = false;
  faint.opacity = 0.3F;
  const auto contrast = [&, empty = drawn(GetParam(), nothing)](const DrawOptions& options) {
    const Picture picture = drawn(GetParam(), options);
    double sum = 0;
    for (std::size_t i = 0; i < picture.rgba.size(); ++i) sum += std::abs(picture.rgba[i] - empty.rgba[i]);
    return sum;
  };
  const double all = contrast(full);
  EXPECT_GT(contrast(faint), 0.1 * all);
  EXPECT_LT(contrast(faint), 0.6 * all);  // overlapping lines add up to a little more than 0.3
}

TEST_P(OffscreenPicture, SurvivesPositionsThatAreNotNumbersAndAnEyeInsideTheCloth) {
  const auto context = makeOffscreen(GetParam(), kWidth, kHeight);
  const Sheet sheet = hangingSheet();
  SheetRenderer renderer(sheet);
  std::vector<float> xyz = waveOf(sheet);
  Camera camera;
  camera.frame(boxAround(xyz), 1.6F);
  camera.approach(20);
  camera.approach(20);
  xyz[30] = std::nanf("");
  renderer.draw(xyz, camera, {kWidth, kHeight}, everything(), kPush);
  renderer.draw(xyz, camera, {0, 0}, everything(), ShownPush{.particle = 100000, .force = {}});
  EXPECT_THROW(renderer.draw({}, camera, {kWidth, kHeight}, everything()), std::invalid_argument);
  const Picture picture = context->readPixels();
  for (std::size_t i = 3; i < picture.rgba.size(); i += 4) ASSERT_EQ(picture.rgba[i], 255);
}

constexpr glm::ivec2 kSmall(128, 80);

/// The share of the picture's width or height, whichever is more, over which a cloth at its start can be seen.
double shareSeen(Offscreen& context, const Sheet& sheet) {
  std::vector<float> xyz;
  for (int i = 0; i < sheet.count(); ++i) {
    const Vec3 p = sheet.startPosition(i);
    xyz.insert(xyz.end(), {float(p.x), float(p.y), float(p.z)});
  }
  Camera camera;
  camera.frame(boxAround(xyz), float(kSmall.x) / float(kSmall.y));
  SheetRenderer renderer(sheet);
  DrawOptions options;
  options.ground = options.pins = false;
  const auto pictureWith = [&](bool cloth) {
    options.structural = cloth;
    renderer.draw(xyz, camera, kSmall, options, std::nullopt);
    return context.readPixels();
  };
  const Picture empty = pictureWith(false), seen = pictureWith(true);
  glm::ivec2 low = kSmall, high(-1, -1);
  for (int y = 0; y < kSmall.y; ++y) {
    for (int x = 0; x < kSmall.x; ++x) {
      const auto i = 4 * std::size_t(y * kSmall.x + x);
      if (seen.rgba[i + 2] - empty.rgba[i + 2] < 24) continue;
      low = glm::min(low, glm::ivec2(x, y)), high = glm::max(high, glm::ivec2(x, y));
    }
  }
  return std::max(double(high.x - low.x + 1) / kSmall.x, double(high.y - low.y + 1) / kSmall.y);
}

TEST(SheetRenderer, ShowsEveryShapeOfClothInAFairShareOfThePicture) {
  const auto context = makeOffscreen(kSmall.x, kSmall.y);
  std::vector<glm::ivec2> shapes{{500, 1}, {1, 500}, {4096, 1}, {1, 4096}, {2000, 2}, {3, 1000}};
  for (int columns = 1; columns <= 40; ++columns) {
    for (int rows = 1; rows <= 40; ++rows) shapes.emplace_back(columns, rows);
  }
  for (const glm::ivec2 shape : shapes) {
    for (const Start start : {Start::Flat, Start::Hanging}) {
      Sheet sheet;
      sheet.columns = shape.x, sheet.rows = shape.y, sheet.start = start;
      const double least = sheet.count() == 1 ? 0.01 : 0.5;  // a single particle is a disc
      EXPECT_GE(shareSeen(*context, sheet), least)
          << shape.x << "x" << shape.y << (start == Start::Flat ? " flat" : "");
    }
  }
}

/// Of the context that is current, 43 for OpenGL 4.3.
int versionNow() {
  GLint major = 0, minor = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &major), glGetIntegerv(GL_MINOR_VERSION, &minor);
  return 10 * major + minor;
}

TEST_P(OffscreenPicture, IsMadeWhereACardCanComputeIfTheDriverHasWhatThatTakes) {
  try {
    (void)makeComputeContext();
  } catch (const std::runtime_error& error) {
    GTEST_SKIP() << error.what();
  }
  const auto context = makeOffscreen(GetParam(), kWidth, kHeight);
  EXPECT_GE(versionNow(), 43);
  EXPECT_NE(context->find()("glDispatchCompute"), nullptr);
}

INSTANTIATE_TEST_SUITE_P(Every, OffscreenPicture, testing::ValuesIn(offscreenKinds().begin(), offscreenKinds().end()),
                         [](const auto& kind) { return std::string(nameOf(kind.param)); });

TEST(Offscreen, AllKindsDrawTheSamePicture) {
  const Picture first = drawn(offscreenKinds().front(), everything(), kPush);
  for (const OffscreenKind kind : offscreenKinds()) expectAlike(first, drawn(kind, everything(), kPush));
}

TEST(Offscreen, RefusesSizesThatNoPictureHas) {
  EXPECT_THROW(makeOffscreen(0, 100), std::runtime_error);
  EXPECT_THROW(makeOffscreen(100, 100000), std::runtime_error);
}

TEST(Picture, ComesBackFromPngAsItWas) {
  Picture picture{3, 2, {}};
  for (int i = 0; i < 24; ++i) picture.rgba.push_back(static_cast<std::uint8_t>(i * 10));
  const Folder folder;
  const auto path = folder / "picture.png";
  writePng(picture, path);
  const Picture back = readPicture(path);
  EXPECT_EQ(back.rgba, picture.rgba);
  EXPECT_EQ(back.width, 3);
}

}  // namespace
}  // namespace tyg
