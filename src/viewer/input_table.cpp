// The help follows the order of the table; neighbours with the same words share a line.
#include "viewer/input_table.h"

#include <algorithm>
#include <array>

#include "util/text.h"
#include "viewer/tool.h"

namespace tyg {
namespace {

using enum InputAction;

/// All but the keys that choose tools, which are made from the table of tools.
constexpr std::array kInputs{
    Input{' ', StartOrPause, "space", "start, pause", true},
    Input{',', StepBack, ",", "step back, step forward"},
    Input{'.', Step, ".", "step back, step forward"},
    Input{';', Slower, ";", "slower, faster"},
    Input{'\'', Faster, "'", "slower, faster"},
    Input{'J', Again, "J", "again, slowly"},
    Input{'R', Restart, "R", "restart", true},
    Input{kLeftButton, UseTool, "left drag", "the tool; beside the cloth: orbit"},
    Input{kWheel, Approach, "wheel", "nearer, farther"},
    Input{kControlDrag, LookAround, "Ctrl", "drag: look, nearer"},  // without a right button, without a wheel
    Input{kShiftDrag, Approach, "Shift", "drag: look, nearer"},
    Input{'W', MoveForward, "W", "move"},
    Input{'A', MoveLeft, "A", "move"},
    Input{'S', MoveBack, "S", "move"},
    Input{'D', MoveRight, "D", "move"},
    Input{'Q', MoveDown, "Q", "down, up"},
    Input{'E', MoveUp, "E", "down, up"},
    Input{kRightButton, LookAround, "right drag", "look around"},
    Input{kLeftKey, LookLeft, "arrows", "look left, right, up, down"},
    Input{kRightKey, LookRight, "arrows", "look left, right, up, down"},
    Input{kUpKey, LookUp, "arrows", "look left, right, up, down"},
    Input{kDownKey, LookDown, "arrows", "look left, right, up, down"},
    Input{'F', FrameCloth, "F", "fit the cloth in view", true},
    Input{'[', SmallerStep, "[", "smaller, larger step", true},
    Input{']', LargerStep, "]", "smaller, larger step", true},
    Input{'V', SafeStep, "V", "a safe step"},
    Input{'M', HoldingMethod, "M", "a method that holds"},
    Input{kEnterKey, RunOn, "Enter", "let it break"},
    Input{'K', OpenControl, "K", "control panel", true},
    Input{'O', OpenGallery, "O", "scenes, in pictures", true},
    Input{'C', OpenChart, "C", "chart: speed, accuracy", true},
    Input{'G', OpenGhost, "G", "ghost: the true motion", true},
    Input{'T', OpenStretch, "T", "stretch of the springs"},
    Input{'=', OpenEnergy, "=", "energy and power"},
    Input{'/', OpenTraces, "/", "traces of particles"},
    Input{kTabKey, OpenTraces, "Tab", "traces of particles"},  // where / is another key under Shift
    Input{'Y', KeepPicture, "Y", "picture, movie to files"},
    Input{'Z', Film, "Z", "picture, movie to files"},
    Input{kUndoKeys, Undo, "Ctrl+Z", "undo"},
    Input{kRedoKeys, Redo, "Ctrl+Y", "redo, like Ctrl+Shift+Z"},
    Input{kCopyKeys, Copy, "Ctrl+C", "copy all numbers"},
    Input{'H', ShowHelp, "H", "hide these keys", true},
    Input{functionKey(1), ShowAllKeys, "F1", "all keys", true},
    Input{'?', ShowAllKeys, "?", "all keys", true},
    Input{kEscapeKey, Leave, "Esc", "leave"},
    Input{'1', ChooseMethod, "1", "method"},
    Input{'2', ChooseMethod, "2", "method"},
    Input{'3', ChooseMethod, "3", "method"},
    Input{'4', ChooseMethod, "4", "method"},
    Input{'5', ChooseMethod, "5", "method"},
    Input{'6', ChooseMethod, "6", "method"},
    Input{'7', ChooseMethod, "7", "method"},
    Input{'8', ChooseMethod, "8", "method"},
    Input{'9', ChooseMethod, "9", "method"},
    Input{'0', ChooseMethod, "0", "method"},
    Input{'-', ChooseMethod, "-", "method"},
    Input{functionKey(6), ChangeShow, "F6", "lines, surface, both"},
    Input{'L', ShowStructural, "L", "structural lines"},
    Input{'X', ShowShear, "X", "shear lines"},
    Input{'N', ShowBend, "N", "bend lines"},
    Input{'P', ShowParticles, "P", "particles"},
    Input{'I', ShowPins, "I", "pins"},
    Input{'U', ShowGround, "U", "ground"},
    Input{'B', ChangeBackground, "B", "light, dark"},
    Input{functionKey(11), FullScreen, "F11", "full screen"},
};

constexpr int kFirstTool = 2;  // F1 is help, as everywhere
constexpr std::array<std::string_view, kFunctionKeys> kFunctionKeyNames{"F1", "F2", "F3", "F4",  "F5",  "F6",
                                                                        "F7", "F8", "F9", "F10", "F11", "F12"};

std::vector<Input> withTools() {
  static const std::string names = joined(toolTable(), &ToolKind::name);
  std::vector<Input> all(kInputs.begin(), kInputs.end());
  const auto left = std::ranges::find(all, UseTool, &Input::action);
  std::vector<Input> tools;
  for (std::size_t slot = 0; slot < toolTable().size(); ++slot) {
    const int number = kFirstTool + static_cast<int>(slot);
    tools.push_back({functionKey(number), ChooseTool, toolKeyName(slot), names});
  }
  all.insert(left + 1, tools.begin(), tools.end());
  return all;
}

}  // namespace

std::span<const Input> inputTable() {
  static const std::vector<Input> all = withTools();
  return all;
}

const Input* findInput(KeyCode key) {
  const auto found = std::ranges::find(inputTable(), key, &Input::key);
  return found == inputTable().end() ? nullptr : &*found;
}

std::size_t methodSlot(KeyCode key) {
  constexpr std::string_view kRow = "1234567890-";  // as on the keyboard
  return kRow.find(key);
}

std::size_t toolSlot(KeyCode key) { return static_cast<std::size_t>(key - functionKey(kFirstTool)); }

std::string_view toolKeyName(std::size_t slot) {
  const std::size_t key = slot + kFirstTool - 1;
  return key < kFunctionKeyNames.size() ? kFunctionKeyNames.at(key) : std::string_view();
}

std::string HelpLine::keys() const {
  std::string names;
  for (const Input* input : inputs) {
    if (!names.ends_with(input->keyName)) names.append(names.empty() ? "" : " ").append(input->keyName);
  }
  return names;
}

std::vector<HelpLine> helpLines(std::span<const std::string_view> methods) {
  std::vector<HelpLine> lines;
  for (const Input& input : inputTable()) {
    if (input.help.empty()) continue;
    if (input.action == ChooseMethod) {
      const std::size_t slot = methodSlot(input.key);
      if (slot < methods.size()) lines.push_back({{&input}, std::string(methods[slot]), slot});
    } else if (!lines.empty() && lines.back().help == input.help) {
      lines.back().inputs.push_back(&input);
    } else {
      lines.push_back({{&input}, std::string(input.help)});
    }
  }
  return lines;
}

std::vector<const HelpLine*> firstLines(std::span<const HelpLine> lines, std::size_t room) {
  std::vector<const HelpLine*> fitting;
  for (const HelpLine& line : lines) {
    if (!line.inputs.front()->first) continue;
    if (fitting.size() < room) {
      fitting.push_back(&line);
    } else if (line.action() == ShowAllKeys && room > 0) {
      fitting.back() = &line;
    }
  }
  return fitting;
}

}  // namespace tyg
