// Breaks the lines itself, because ImGui breaks them differently from the rest of the window.
#include "ui/panels/paragraph.h"

#include <imgui.h>

#include "util/wrapped.h"

namespace tyg {

void paragraph(std::string_view text, Colour colour) {
  const auto widthOf = [](std::string_view part) {
    return ImGui::CalcTextSize(part.data(), part.data() + part.size()).x;
  };
  const std::string lines = wrapped(text, ImGui::GetContentRegionAvail().x, widthOf);
  ImGui::PushStyleColor(ImGuiCol_Text, colour);
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(lines.data(), lines.data() + lines.size());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

}  // namespace tyg
