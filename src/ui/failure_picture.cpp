// The pattern is a piece of the sheet: what moves one way is of one colour, what moves the other way of the other.
#include "ui/failure_picture.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/panels/style.h"

namespace tyg {
namespace {

// In sizes of the text.
constexpr float kPattern = 5, kPlot = 9, kPad = 0.6F, kLine = 1.3F;
constexpr float kLeastCloth = 8;  // what the cloth keeps, across to the left of the picture, or below it

ImU32 mixed(float share, Background background) {
  const RampColours& ramp = coloursOf(Ramp::Balanced, background);
  const float place = std::clamp((share + 1) / 2, 0.0F, 1.0F) * float(ramp.size() - 1);
  const auto k = std::min(static_cast<std::size_t>(place), ramp.size() - 2);
  const glm::vec3 c = glm::mix(ramp.at(k), ramp.at(k + 1), place - float(k));
  return ImGui::ColorConvertFloat4ToU32({c.r, c.g, c.b, 1});
}

/// Particles as discs on a grid.
void drawPattern(const TextWriter& writer, ImVec2 at, const FailingMotion& motion) {
  constexpr int kCount = 8;
  const float stride = kPattern * writer.size / float(kCount);
  const int columns = motion.columns > 1 ? kCount : 1, rows = motion.rows > 1 ? kCount : 1;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const auto share = float(std::cos(motion.qx * column + motion.qy * row));
      writer.list->AddCircleFilled({at.x + (float(column) + 0.5F) * stride, at.y + (float(row) + 0.5F) * stride},
                                   0.42F * stride, mixed(share, writer.background), 12);
    }
  }
}

/// In joules: `10 J`, `1e-06 J`.
std::string powerOfTen(double exponent) { return fmt::format("{:g} J", std::pow(10, exponent)); }

/// The kinetic energy, which grows by the same factor in the same time: a straight line on this scale.
void drawEnergy(const TextWriter& writer, ImVec2 from, ImVec2 to, std::span<const BreakRecord::Moment> moments) {
  const Colours& ink = coloursOn(writer.background);
  const auto decades = [](double joules) {
    constexpr double kLeast = 1e-12;
    return std::log10(std::max(joules, kLeast));
  };
  double low = decades(moments.front().kinetic), high = low;
  for (const BreakRecord::Moment& moment : moments) {
    low = std::min(low, decades(moment.kinetic)), high = std::max(high, decades(moment.kinetic));
  }
  low = std::floor(low), high = std::max(std::ceil(high), low + 1);
  writer.list->AddRectFilled(from, to, ink.field);
  const double first = moments.front().time, last = std::max(moments.back().time, first + 1e-9);
  ImVec2 before;
  for (std::size_t k = 0; k < moments.size(); ++k) {
    const ImVec2 here{from.x + float((moments[k].time - first) / (last - first)) * (to.x - from.x),
                      to.y - float((decades(moments[k].kinetic) - low) / (high - low)) * (to.y - from.y)};
    if (k > 0) writer.list->AddLine(before, here, ink.past, std::max(2.0F, writer.size / 8));
    before = here;
  }
  TextWriter small = writer;
  small.size *= 0.8F;
  const float inside = 0.2F * writer.size;
  // The line rises from the lower left to the upper right: the other two corners are free.
  const std::string least = powerOfTen(low);
  small.write({from.x + inside, from.y + inside}, ink.text, powerOfTen(high));
  small.write({to.x - small.extent(least).x - inside, to.y - small.size - inside}, ink.text, least);
}

}  // namespace

ImVec2 drawFailurePicture(TextWriter writer, ImVec2 upper, ImVec2 lower, const Viewer& viewer) {
  // In a window of fewer lines, and between panels, it is smaller, to leave the cloth in view.
  constexpr float kLines = 36, kSmallest = 0.6F;
  writer.size *= std::clamp(ImGui::GetIO().DisplaySize.y / (kLines * writer.size), kSmallest, 1.0F);
  const std::optional<FailingMotion>& motion = viewer.run().failure().motion();
  const auto moments = viewer.run().breaking();
  const bool breaks = moments.size() > 1 && viewer.run().showsBreaking();
  if (!motion && !breaks) return {};
  const std::string name = motion ? "fails first: " + motion->name : "";
  const bool isWave = motion && motion->columns > 0;
  const float patternSizes = isWave ? kPattern + kPad : 0, plotSizes = breaks ? kPlot + kPad : 0;
  const auto widthNow = [&] {
    return std::max(writer.extent(name).x, (patternSizes + plotSizes - kPad) * writer.size) + 2 * kPad * writer.size;
  };
  writer.size *= std::clamp((lower.x - upper.x) / widthNow(), kSmallest, 1.0F);
  const float size = writer.size, pad = kPad * size, width = std::floor(widthNow());
  const float height = 2 * pad + (isWave || breaks ? kLine + kPattern : 1) * size;
  const ImVec2 from{lower.x - width, upper.y};
  const bool beside = from.x - kLeastCloth * size >= upper.x;
  if (from.x < upper.x || from.y + height + (beside ? 0 : kLeastCloth * size) > lower.y) return {};
  writer.shade(from, {lower.x, from.y + height});
  writer.write({from.x + pad, from.y + pad}, coloursOn(writer.background).text, name);
  const ImVec2 at{from.x + pad, from.y + pad + kLine * size};
  if (isWave) drawPattern(writer, at, *motion);
  const ImVec2 taken = beside ? ImVec2{width, 0} : ImVec2{0, height};
  if (!breaks) return taken;
  const float left = at.x + patternSizes * size;
  writer.write({left, motion ? at.y : at.y - kLine * size}, coloursOn(writer.background).dim, "kinetic energy");
  drawEnergy(writer, {left, motion ? at.y + kLine * size : at.y}, {left + kPlot * size, at.y + kPattern * size},
             moments);
  return taken;
}

}  // namespace tyg
