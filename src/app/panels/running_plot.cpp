// See running_plot.h.
#include "app/panels/running_plot.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include "app/viewer.h"

namespace tyg {
namespace {

constexpr float kSmall = 0.8F;  // of the text, for numbers at axes

/// Round numbers around the curves' range.
struct Range {
  double low = 0, high = 1, step = 1;
};

Range rangeOf(const RunningSeries& series, std::span<const RunningCurve> curves) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const RunningCurve& curve : curves) {
    for (std::size_t k = 0; k < series.size(); ++k) {
      const double value = double(curve.scale) * double(series.value(k, curve.channel));
      low = std::min(low, value), high = std::max(high, value);
    }
  }
  if (!(high >= low) || std::isinf(high) || std::isinf(low)) return {};
  constexpr double kFlat = 1e-9;  // of the value: what differs by less is drawn as one
  if (high - low <= kFlat * std::max(std::abs(high), std::abs(low)) + 1e-30) {
    const double half = std::max(std::abs(high), 1e-9) / 2;
    low -= half, high += half;
  }
  const double wanted = (high - low) / 3, power = std::pow(10.0, std::floor(std::log10(wanted)));
  const double ratio = wanted / power;
  const double step = power * (ratio < 1.5 ? 1 : ratio < 3.5 ? 2 : ratio < 7.5 ? 5 : 10);
  return {step * std::floor(low / step), step * std::ceil(high / step), step};
}

using Text = std::array<char, 32>;
Text numberText(double value, double step) {
  Text text{};
  std::snprintf(text.data(), text.size(), "%.4g", std::abs(value) < step / 1e6 ? 0.0 : value);
  return text;
}

/// One moment of the curves, beside the cursor.
void readOut(const RunningSeries& series, std::size_t moment, std::span<const RunningCurve> curves) {
  ImGui::BeginTooltip();
  ImGui::Text("%.3f s", series.time(moment));
  for (const RunningCurve& curve : curves) {
    const ImVec4 ink = ImGui::ColorConvertU32ToFloat4(curve.colour);
    ImGui::TextColored(ink, "%.4g", double(curve.scale) * double(series.value(moment, curve.channel)));
  }
  ImGui::TextUnformatted("click to go back to it");
  ImGui::EndTooltip();
}

}  // namespace

void runningPlot(const PanelScope& scope, const char* title, const RunningSeries& series,
                 std::span<const RunningCurve> curves, float height) {
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, small = kSmall * scope.size;
  const bool clicked = ImGui::InvisibleButton(title, {width, std::ceil(height)});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImFont* font = ImGui::GetFont();
  const auto write = [&](float x, float y, const char* text) {
    list.AddText(font, small, {std::round(x), std::round(y)}, scope.colours.dim, text);
  };
  const auto extent = [&](const char* text) { return font->CalcTextSizeA(small, 1e6F, 0, text).x; };

  const Range range = rangeOf(series, curves);
  const float left = origin.x + extent("-0.00001") + small, right = origin.x + width;
  const float top = origin.y + 1.4F * small, bottom = origin.y + height - 1.5F * small;
  list.AddText(font, small, origin, scope.colours.text, title);
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
    const Text text = numberText(value, range.step);
    write(left - extent(text.data()) - 0.4F * small, y(value) - 0.5F * small, text.data());
  }
  if (series.size() == 0) return;
  const double end = series.time(series.size() - 1), begin = std::max(series.time(0), end - series.window());
  const double span = std::max(series.window(), 1e-12);
  const auto x = [&](double time) { return right - float((end - time) / span) * (right - left); };
  Text text{};
  std::snprintf(text.data(), text.size(), "%.2f s", begin);
  if (x(begin) + extent(text.data()) + small < right - extent("000.00 s"))
    write(x(begin), bottom + 0.2F * small, text.data());
  std::snprintf(text.data(), text.size(), "%.2f s", end);
  write(right - extent(text.data()), bottom + 0.2F * small, text.data());
  for (const RunningCurve& curve : curves) {
    for (std::size_t k = 0; k < series.size(); ++k) {
      list.PathLineTo({x(series.time(k)), y(double(curve.scale) * double(series.value(k, curve.channel)))});
    }
    list.PathStroke(curve.colour, 0, 1.8F);
  }
  const float cursor = ImGui::GetMousePos().x;
  if (!ImGui::IsItemHovered() || cursor < x(begin) || cursor > right) return;
  std::size_t under = series.size() - 1;
  while (under > 0 && x(series.time(under)) > cursor) --under;
  const float at = x(series.time(under));
  list.AddLine({at, top}, {at, bottom}, scope.colours.dim);
  readOut(series, under, curves);
  if (clicked) scope.viewer.turnToTime(series.time(under));
}

}  // namespace tyg
