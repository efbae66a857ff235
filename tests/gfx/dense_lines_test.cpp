// Meshes whose lines lie so near to each other that no pixel shows a single one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "gfx/contexts/offscreen.h"
#include "gfx/passes/sheet_renderer.h"

namespace tyg {
namespace {

constexpr glm::ivec2 kSize(320, 320);

struct View {
  Start start = Start::Hanging;  ///< a sheet that hangs is seen straight on, one that lies as windows show it first
  float scale = 1;
  Show show = Show::Lines;
};

/// Blue of a sheet of 2 m, less the background's, in the middle of the picture.
std::vector<double> toneOf(int side, const View& view = {}) {
  const auto context = makeOffscreen(kSize.x, kSize.y);
  Sheet sheet;
  sheet.columns = sheet.rows = side;
  sheet.spacing = 2.0 / (side - 1);
  sheet.start = view.start;
  std::vector<float> xyz;
  for (int i = 0; i < sheet.count(); ++i) {
    const Vec3 p = sheet.startPosition(i);
    xyz.insert(xyz.end(), {float(p.x), float(p.y), float(p.z)});
  }
  Camera camera;
  if (view.start == Start::Hanging) camera.lookAlong(0, 0);
  camera.frame(boxAround(xyz), 1);
  SheetRenderer renderer(sheet);
  DrawOptions options;
  options.ground = options.pins = false;
  options.scale = view.scale;
  options.show = view.show;
  const auto blue = [&](bool lines) {
    options.structural = lines;
    renderer.draw(xyz, camera, kSize, options);
    return context->readPixels();
  };
  const Picture with = blue(true), without = blue(false);
  const int part = view.start == Start::Hanging ? 6 : 12;  // what lies is low in the picture
  std::vector<double> tones;
  for (int y = kSize.y / 2 - kSize.y / part; y < kSize.y / 2 + kSize.y / part; ++y) {
    for (int x = kSize.x / 2 - kSize.x / part; x < kSize.x / 2 + kSize.x / part; ++x) {
      const auto i = 4 * std::size_t(y * kSize.x + x) + 2;
      tones.push_back(with.rgba[i] - without.rgba[i]);
    }
  }
  return tones;
}

double meanOf(const std::vector<double>& numbers) {
  double sum = 0;
  for (const double number : numbers) sum += number;
  return sum / double(numbers.size());
}
/// How much they differ from each other, as a share of their mean.
double unevenness(const std::vector<double>& numbers) {
  const double mean = meanOf(numbers);
  double sum = 0;
  for (const double number : numbers) sum += (number - mean) * (number - mean);
  return std::sqrt(sum / double(numbers.size())) / mean;
}

TEST(DenseLines, OfMeshesUnderTwoPixelsAreAnEvenTone) {
  for (const int side : {150, 190, 230, 300, 400}) {  // 1.9 to 0.7 pixels from line to line
    const std::vector<double> tones = toneOf(side);
    EXPECT_GT(meanOf(tones), 40) << side;
    EXPECT_LT(unevenness(tones), 0.08) << side;
  }
  EXPECT_GT(unevenness(toneOf(40)), 0.3) << "lines that one can tell apart";
}

TEST(DenseLines, HaveAsMuchInkAsThoseThatStandALittleFartherApart) {
  const double apart = meanOf(toneOf(60));
  for (const int side : {120, 240, 480}) EXPECT_NEAR(meanOf(toneOf(side)), apart, 0.15 * apart) << side;
}

/// How much pixels differ from those left and right of them, as a share of their mean.
double roughness(const std::vector<double>& tones) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < tones.size(); ++i) {
    const double differs = tones[i] - (tones[i - 1] + tones[i + 1]) / 2;
    sum += differs * differs;
  }
  return std::sqrt(sum / double(tones.size())) / meanOf(tones);
}

TEST(DenseLines, ShowNoPatternThatTheyFormWithThePixels) {
  for (const int side : {60, 66, 77, 90, 110})
    EXPECT_LT(roughness(toneOf(side, {.start = Start::Flat})), 0.023) << side;
}

TEST(DenseLines, LeaveASurfaceItsColour) {
  for (const int side : {150, 300}) EXPECT_NEAR(meanOf(toneOf(side, {.show = Show::Both})), 0, 1) << side;
  EXPECT_LT(meanOf(toneOf(20, {.show = Show::Both})), -10) << "lines that one can tell apart";
}

TEST(Lines, AreWiderWhereTheScaleIsLarger) { EXPECT_NEAR(meanOf(toneOf(9, {.scale = 2})) / meanOf(toneOf(9)), 2, 0.2); }

}  // namespace
}  // namespace tyg
