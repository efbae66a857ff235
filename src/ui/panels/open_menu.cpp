// The list is read once, when the menu opens: reading a folder in every frame would make the window wait for the disk.
#include "ui/panels/open_menu.h"

#include <imgui.h>

#include <algorithm>
#include <utility>

#include "util/visible_text.h"
#include "viewer/opened_file.h"
#include "viewer/viewer.h"

namespace tyg {

bool OpenMenu::draw(const PanelScope& scope) {
  if (ImGui::Button("Open")) {
    files_ = openableFiles(std::filesystem::current_path());
    path_.fill('\0');
    focus_ = true;
    ImGui::OpenPopup("open a file");
  }
  tip(scope, "a scene (.toml), the log of a run or a motion of your own program (.csv)");
  if (!ImGui::BeginPopup("open a file")) return false;
  const Done done = drawMenu(scope);
  if (done != Done::Nothing) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
  return done == Done::Opened;
}

/// Esc leaves the field, and the menu with it. What was refused leaves the menu open, for another choice.
OpenMenu::Done OpenMenu::drawMenu(const PanelScope& scope) {
  constexpr float kWidth = 20, kLines = 12;  // in sizes of the text
  ImGui::SetNextItemWidth(kWidth * scope.size);
  if (std::exchange(focus_, false)) ImGui::SetKeyboardFocusHere();
  const bool typed = ImGui::InputTextWithHint("##path", "path of a .toml or .csv file, Enter", path_.data(),
                                              path_.size(), ImGuiInputTextFlags_EnterReturnsTrue);
  if (ImGui::IsItemDeactivated() && !typed && !ImGui::IsMouseDown(ImGuiMouseButton_Left)) return Done::Closed;
  const auto open = [&](const std::string& path) {
    const bool opened = scope.viewer.open(path);
    focus_ = !opened;
    return opened ? Done::Opened : Done::Nothing;
  };
  if (typed && path_.front() != '\0') return open(typedPath(path_.data()));
  if (files_.empty()) ImGui::TextDisabled("no .toml and no .csv file in the current folder");
  const float line = ImGui::GetTextLineHeightWithSpacing();
  const float height = line * std::min(kLines, static_cast<float>(files_.size()));
  Done done = Done::Nothing;
  if (!files_.empty() && ImGui::BeginChild("##files", {kWidth * scope.size, height})) {
    for (std::size_t k = 0; k < files_.size(); ++k) {
      ImGui::PushID(static_cast<int>(k));
      if (ImGui::Selectable(oneLine(files_[k]).c_str())) done = open(files_[k]);
      ImGui::PopID();
    }
  }
  if (!files_.empty()) ImGui::EndChild();
  return done;
}

}  // namespace tyg
