// A window of ImGui's, so that no panel below it feels the mouse, with text of ours in it.
#include "ui/all_keys.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "tyg/methods.h"
#include "ui/panels/panel.h"
#include "ui/panels/style.h"

namespace tyg {
namespace {

// In sizes of the text.
constexpr float kLine = 1.35F, kPad = 0.7F, kBetween = 1.6F;
constexpr std::size_t kMostColumns = 4;
constexpr std::string_view kTitle = "All keys. A click on a line does what its key does. F1 or Esc closes the list.";

struct Columns {
  std::vector<std::vector<const HelpLine*>> lines;
  std::vector<KeyList::Widths> widths;
  float width = 0, height = 0;  ///< with the title, in sizes of the text
};

Columns columnsOf(const TextWriter& writer, std::span<const HelpLine> lines, std::size_t count) {
  Columns columns;
  const std::size_t each = (lines.size() + count - 1) / count;
  for (std::size_t first = 0; first < lines.size(); first += each) {
    std::vector<const HelpLine*> column;
    for (std::size_t k = first; k < std::min(first + each, lines.size()); ++k) column.push_back(&lines[k]);
    columns.widths.push_back(KeyList::widthsOf(writer, column));
    columns.width += columns.widths.back().all + (first > 0 ? kBetween : 0);
    columns.lines.push_back(std::move(column));
  }
  columns.width = std::max(columns.width, writer.extent(kTitle).x / writer.size) + 2 * kPad;
  columns.height = kLine * float(each + 1) + 2 * kPad;
  return columns;
}

}  // namespace

void AllKeys::draw(TextWriter writer, std::span<const HelpLine> lines,
                   const std::function<bool(const HelpLine&)>& isOn) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  Columns best;
  float size = 0;
  for (std::size_t count = 1; count <= kMostColumns; ++count) {
    Columns columns = columnsOf(writer, lines, count);
    const float fits = std::min({writer.size, screen.x / columns.width, screen.y / columns.height});
    if (fits > size) size = fits, best = std::move(columns);
  }
  writer.size = size;
  list_.clear();
  const ImVec2 extent{std::floor(size * best.width), std::floor(size * best.height)};
  const ImVec2 at{std::floor((screen.x - extent.x) / 2), std::floor((screen.y - extent.y) / 2)};
  applyStyle(writer.background, size);
  ImGui::SetNextWindowPos(at);
  ImGui::SetNextWindowSize(extent);
  ImGui::SetNextWindowBgAlpha(1);
  if (!shown_) ImGui::SetNextWindowFocus();
  shown_ = true;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  constexpr int kPlain = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                         ImGuiWindowFlags_NoNav;
  if (ImGui::Begin("##all keys", nullptr, kPlain)) {
    writer.list = ImGui::GetWindowDrawList();
    float x = at.x + kPad * size;
    writer.write({x, at.y + kPad * size}, coloursOn(writer.background).text, kTitle);
    for (std::size_t column = 0; column < best.lines.size(); ++column) {
      float y = at.y + (kPad + kLine) * size;
      for (const HelpLine* line : best.lines[column]) {
        list_.draw(writer, {x, y}, best.widths[column], *line, isOn(*line));
        const ImVec2 corner{x + best.widths[column].all * size, y + kLine * size};
        if (line->action() == InputAction::ChooseMethod && inside(ImGui::GetIO().MousePos, {x, y}, corner)) {
          ImGui::SetTooltip("%s", aboutMethod(methods()[line->method]).c_str());
        }
        y += kLine * size;
      }
      x += (best.widths[column].all + kBetween) * size;
    }
  }
  ImGui::End();
  ImGui::PopStyleVar();
}

}  // namespace tyg
