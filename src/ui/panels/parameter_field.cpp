// Made of ImGui's own sliders and fields.
#include "ui/panels/parameter_field.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <string>

namespace tyg {
namespace {

constexpr int kLog = ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp;

/// Three fields, of which the last one also has the unit, and room for it.
bool vectorFields(const std::string& id, std::array<double, 3>& xyz, double most, const std::string& number,
                  const std::string& unit) {
  const double least = -most;
  const float between = ImGui::GetStyle().ItemInnerSpacing.x / 2, unitWidth = ImGui::CalcTextSize(unit.c_str()).x;
  const float width = std::max(1.0F, (ImGui::CalcItemWidth() - unitWidth - 2 * between) / 3);
  bool moved = false;
  ImGui::BeginGroup();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (axis > 0) ImGui::SameLine(0, between);
    ImGui::SetNextItemWidth(axis == 2 ? width + unitWidth : width);
    const std::string name = fmt::format("{} {}", id, axis), format = axis == 2 ? number + unit : number;
    moved = ImGui::DragScalar(name.c_str(), ImGuiDataType_Double, &xyz.at(axis), float(most / 2000), &least, &most,
                              format.c_str(), ImGuiSliderFlags_AlwaysClamp) ||
            moved;
  }
  ImGui::EndGroup();
  return moved;
}

}  // namespace

bool logSlider(const char* id, double& value, double scale, std::array<double, 2> range, const char* format) {
  double shown = value * scale;
  if (!ImGui::SliderScalar(id, ImGuiDataType_Double, &shown, range.data(), &range[1], format, kLog)) return false;
  value = shown / scale;
  return true;
}

void parameterField(const Parameter& parameter, std::string_view unit, Scene& wanted) {
  const std::string id = fmt::format("##{}", parameter.key), number = fmt::format("%.{}g", parameter.digits);
  const std::string unitAfter = unit.empty() ? "" : fmt::format(" {}", unit);
  Vec3 value = parameter.get(wanted);
  if (parameter.count == 1) {
    constexpr double kLeastShare = 1e-5;  // of the largest number, where 0 is none
    const double least = parameter.allowed == Allowed::Positive ? kLeastShare * parameter.mostByHand : 0;
    const std::string format = number + unitAfter;
    if (logSlider(id.c_str(), value.x, 1, {least, parameter.mostByHand}, format.c_str())) parameter.set(wanted, value);
    return;
  }
  std::array<double, 3> xyz{value.x, value.y, value.z};
  if (vectorFields(id, xyz, parameter.mostByHand, number, unitAfter)) parameter.set(wanted, {xyz[0], xyz[1], xyz[2]});
}

}  // namespace tyg
