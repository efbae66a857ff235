// A line with one action is a button as a whole; one with several has a button for each key.
#include "ui/key_list.h"

#include <imgui.h>

#include <algorithm>

#include "ui/panels/style.h"

namespace tyg {
namespace {

constexpr float kGap = 0.8F;   // between keys and words, in sizes of the text
constexpr float kOver = 0.2F;  // by which a button reaches beyond its words, likewise

bool canBePressed(const Input& input) {
  return !isMouse(input.key) && input.key != kControlDrag && input.key != kShiftDrag;
}

bool sameAction(const HelpLine& line) {
  return std::ranges::all_of(line.inputs, [&](const Input* input) { return input->action == line.action(); });
}

}  // namespace

KeyList::Widths KeyList::widthsOf(const TextWriter& writer, std::span<const HelpLine* const> lines) {
  float keys = 0, words = 0;
  for (const HelpLine* line : lines) {
    keys = std::max(keys, writer.extent(line->keys()).x);
    words = std::max(words, writer.extent(line->help).x);
  }
  return {keys / writer.size + kGap, (keys + words) / writer.size + kGap};
}

void KeyList::draw(const TextWriter& writer, ImVec2 at, const Widths& widths, const HelpLine& line, bool on) {
  const Colours& ink = coloursOn(writer.background);
  const float over = kOver * writer.size;
  const auto button = [&](float from, float to, const Input& input) {
    if (!canBePressed(input)) return;
    const Area area{{at.x + from - over, at.y - over}, {at.x + to + over, at.y + writer.size + over}, &input};
    if (inside(ImGui::GetIO().MousePos, area.from, area.to)) {
      writer.list->AddRectFilled(area.from, area.to, ink.field, 0.3F * writer.size);
    }
    areas_.push_back(area);
  };
  if (line.action() == InputAction::ChooseTool || !sameAction(line)) {
    float x = 0;
    for (const Input* input : line.inputs) {
      const float wide = writer.extent(input->keyName).x;
      button(x, x + wide, *input);
      x += wide + writer.extent(" ").x;
    }
  } else {
    button(0, widths.all * writer.size, *line.inputs.front());
  }
  writer.write(at, on ? ink.accent : ink.text, line.keys());
  writer.write({at.x + widths.keys * writer.size, at.y}, on ? ink.accent : ink.dim, line.help);
}

const Input* KeyList::at(ImVec2 place) const {
  const auto found = std::ranges::find_if(areas_, [&](const Area& area) { return inside(place, area.from, area.to); });
  return found == areas_.end() ? nullptr : found->input;
}

}  // namespace tyg
