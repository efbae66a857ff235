// Draws the ramp piece by piece between its stops, and its numbers below it.
#include "ui/panels/colour_bar.h"

#include <fmt/core.h>
#include <imgui.h>

#include <cmath>

namespace tyg {
namespace {

Colour packed(const glm::vec3& colour) { return ImGui::ColorConvertFloat4ToU32({colour.r, colour.g, colour.b, 1}); }

}  // namespace

void colourBar(const PanelScope& scope, Ramp ramp, double low, double high, const char* unit) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, thick = 0.7F * scope.size, small = 0.85F * scope.size;
  const RampColours& colours = coloursOf(ramp, scope.background);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float piece = width / float(colours.size() - 1);
  for (std::size_t k = 0; k + 1 < colours.size(); ++k) {
    const Colour left = packed(colours.at(k)), right = packed(colours.at(k + 1));
    list.AddRectFilledMultiColor({at.x + float(k) * piece, at.y}, {at.x + float(k + 1) * piece, at.y + thick}, left,
                                 right, right, left);
  }
  for (const int k : {0, 1, 2}) {
    const std::string text = fmt::format("{:.3g} {}", low + 0.5 * k * (high - low), k == 1 ? "" : unit);
    const float extent = ImGui::GetFont()->CalcTextSizeA(small, 1e6F, 0, text.c_str()).x;
    list.AddText(ImGui::GetFont(), small, {at.x + 0.5F * float(k) * (width - extent), at.y + 1.15F * thick},
                 scope.colours.dim, text.c_str());
  }
  ImGui::Dummy({width, std::ceil(1.15F * thick + 1.1F * small)});  // ImGui's windows fit whole pixels
}

double steadyTop(double before, double value) {
  if (before > 0 && value <= before && value > before / 5) return before;
  if (!(value > 0) || std::isinf(value)) return before;
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (value <= step * power) return step * power;
  }
  return 10 * power;
}

}  // namespace tyg
