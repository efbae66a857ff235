// Draws with ImGui's draw lists: ImGui itself has no such plot.
#include "ui/panels/running_plot.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "view/round_step.h"
#include "viewer/viewer.h"

namespace tyg {
namespace {

constexpr float kSmall = 0.8F;  // of the text, for numbers at axes

/// Round numbers around the curves' range.
struct Range {
  double low = 0, high = 1, step = 1;
};

Range rangeOf(const RunningSeries& series, std::span<const RunningCurve> curves, double least) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const RunningCurve& curve : curves) {
    for (std::size_t k = 0; k < series.size(); ++k) {
      const double value = curve.value(series, k);
      low = std::min(low, value), high = std::max(high, value);
    }
  }
  if (!(high >= low) || std::isinf(high) || std::isinf(low)) return {};
  if (low == 0 && high == 0 && least == 0) return {-1, 1, 1};
  constexpr double kFlat = 1e-5;  // of the value: samples are floats, and numbers at the axis are to differ
  least = std::max({least, kFlat * std::abs(high), kFlat * std::abs(low), 1e-30});
  if (high - low < least) {
    const double middle = (low + high) / 2;
    low = middle - least / 2, high = middle + least / 2;
  }
  const double step = roundStep((high - low) / 3);
  return {step * std::floor(low / step), step * std::ceil(high / step), step};
}

/// With as many digits as tell one line of the grid from the next.
std::string numberText(double value, double step) {
  if (std::abs(value) < step / 1e6) return "0";
  const int digits = -static_cast<int>(std::floor(std::log10(step) + 1e-9));
  constexpr int kMostDigits = 6;
  if (digits <= kMostDigits) return fmt::format("{:.{}f}", value, std::max(0, digits));
  const int significant = 2 + static_cast<int>(std::floor(std::log10(std::abs(value) / step) + 1e-9));
  return fmt::format("{:.{}g}", value, std::clamp(significant, 2, kMostDigits + 1));
}

/// The values of the curves at one sample, beside the cursor.
void readOut(const RunningSeries& series, std::size_t sample, std::span<const RunningCurve> curves, const char* unit) {
  ImGui::BeginTooltip();
  ImGui::Text("%.3f s: a click goes there", series.time(sample));
  for (const RunningCurve& curve : curves) {
    const ImVec4 ink = ImGui::ColorConvertU32ToFloat4(curve.colour);
    ImGui::TextColored(ink, "%s %.4g %s", curve.name.c_str(), curve.value(series, sample), unit);
  }
  ImGui::EndTooltip();
}

constexpr double kShortest = 1;  // s, of a plot whose series has only begun
constexpr double kGap = 0.5;     // s between samples: a time that was not seen

}  // namespace

void runningPlot(const PanelScope& scope, const RunningPlot& plot, const RunningSeries& series,
                 std::span<const RunningCurve> curves) {
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, small = kSmall * scope.size;
  ImGui::InvisibleButton(plot.title, {width, std::ceil(plot.height)});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImFont* font = ImGui::GetFont();
  const auto write = [&](float x, float y, const std::string& text) {
    list.AddText(font, small, {std::round(x), std::round(y)}, scope.colours.dim, text.c_str());
  };
  const auto extent = [&](const std::string& text) { return font->CalcTextSizeA(small, 1e6F, 0, text.c_str()).x; };

  const Range range = rangeOf(series, curves, plot.least);
  const float left = origin.x + extent("-0.00001") + small, right = origin.x + width;
  const float top = origin.y + 1.4F * small, bottom = origin.y + plot.height - 1.5F * small;
  list.AddText(font, small, origin, scope.colours.text, (std::string(plot.title) + ", " + plot.unit).c_str());
  list.AddRectFilled({left, top}, {right, bottom}, scope.colours.field);
  const auto y = [&](double value) {
    return bottom - float((value - range.low) / (range.high - range.low)) * (bottom - top);
  };
  const bool crowded = y(range.low) - y(range.low + range.step) < 1.2F * small;
  const int steps = int(std::lround((range.high - range.low) / range.step));
  for (int k = 0; k <= steps; ++k) {
    const double value = range.low + k * range.step;
    list.AddLine({left, y(value)}, {right, y(value)}, faded(scope.colours.dim, 0.25F));
    if (crowded && k != 0 && k != steps) continue;
    const std::string text = numberText(value, range.step);
    write(left - extent(text) - 0.4F * small, y(value) - 0.5F * small, text);
  }
  if (series.size() == 0) return;
  const double end = series.time(series.size() - 1), begin = std::max(series.time(0), end - series.window());
  const double span = std::clamp(end - begin, kShortest, series.window());
  const auto x = [&](double time) { return right - float((end - time) / span) * (right - left); };
  const std::string first = fmt::format("{:.2f} s", begin), last = fmt::format("{:.2f} s", end);
  if (x(begin) + extent(first) + small < right - extent(last)) write(x(begin), bottom + 0.2F * small, first);
  write(right - extent(last), bottom + 0.2F * small, last);
  for (const RunningCurve& curve : curves) {
    const auto stroke = [&] { list.PathStroke(curve.colour, 0, 1.8F); };
    for (std::size_t k = 0; k < series.size(); ++k) {
      const double value = curve.value(series, k);
      if (std::isnan(value) || (k > 0 && series.time(k) - series.time(k - 1) > kGap)) stroke();
      if (!std::isnan(value)) list.PathLineTo({x(series.time(k)), y(value)});
    }
    stroke();
  }
  Viewer& viewer = scope.viewer;
  const auto mark = [&](double time, Colour colour) {
    if (time >= begin && time <= end) list.AddLine({x(time), top}, {x(time), bottom}, colour, 1.5F);
  };
  if (viewer.run().timeline().past) mark(viewer.run().shown().time(), scope.colours.accent);
  if (!ImGui::IsItemHovered() && !ImGui::IsItemActive()) return;
  const double wanted = end - double(right - ImGui::GetMousePos().x) / double(right - left) * span;
  const std::size_t under = series.at(std::clamp(wanted, begin, end));
  mark(series.time(under), scope.colours.dim);
  readOut(series, under, curves, plot.unit);
  if (ImGui::IsItemActive() && series.time(under) != viewer.run().shown().time())
    viewer.run().turnToTime(series.time(under));
}

}  // namespace tyg
