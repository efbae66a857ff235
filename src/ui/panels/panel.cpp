// Words that several panels show under the mouse.
#include "ui/panels/panel.h"

#include <fmt/core.h>
#include <imgui.h>

#include "tyg/method.h"

namespace tyg {

std::string aboutMethod(const Method& method) {
  const std::string cost = method.evaluationsPerStep < 0
                               ? "as many force evaluations as it needs"
                               : fmt::format("{} force evaluation{} a step", method.evaluationsPerStep,
                                             method.evaluationsPerStep == 1 ? "" : "s");
  return fmt::format("{}: {}\norder {}, {}", method.label, method.scheme, method.order, cost);
}

void tip(const PanelScope& scope, const std::string& text) {
  if (!scope.tips || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 1);  // what is disabled is pale, and what is said of it is not
  ImGui::SetTooltip("%s", text.c_str());
  ImGui::PopStyleVar();
}

}  // namespace tyg
