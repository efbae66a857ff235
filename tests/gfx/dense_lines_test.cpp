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

/// Blue of a flat sheet seen straight on, less the background's, in the middle of the picture.
std::vector<double> toneOf(int side, float scale = 1) {
  const auto context = makeOffscreen(kSize.x, kSize.y);
  Sheet sheet;
  sheet.columns = sheet.rows = side;
  sheet.spacing = 2.0 / (side - 1);
  sheet.start = Start::Hanging;
  std::vector<float> xyz;
  for (int i = 0; i < sheet.count(); ++i) {
    const Vec3 p = sheet.startPosition(i);
    xyz.insert(xyz.end(), {float(p.x), float(p.y), float(p.z)});
  }
  Camera camera;
  camera.lookAlong(0, 0);
  camera.frame(boxAround(xyz), 1);
  SheetRenderer renderer(sheet);
  DrawOptions options;
  options.ground = options.pins = false;
  options.scale = scale;
  const auto blue = [&](bool lines) {
    options.structural = lines;
    renderer.draw(xyz, camera, kSize, options);
    return context->readPixels();
  };
  const Picture with = blue(true), without = blue(false);
  std::vector<double> tones;
  for (int y = kSize.y / 3; y < 2 * kSize.y / 3; ++y) {
    for (int x = kSize.x / 3; x < 2 * kSize.x / 3; ++x) {
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

TEST(Lines, AreWiderWhereTheScaleIsLarger) { EXPECT_NEAR(meanOf(toneOf(9, 2)) / meanOf(toneOf(9)), 2, 0.2); }

}  // namespace
}  // namespace tyg
