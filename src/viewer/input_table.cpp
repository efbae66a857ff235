// The help follows the order of the table; neighbours with the same words share a line.
#include "viewer/input_table.h"

#include <algorithm>
#include <array>

namespace tyg {
namespace {

using enum InputAction;

constexpr std::array kInputs{
    Input{' ', StartOrPause, "space", "start, pause"},
    Input{',', StepBack, ",", "one step back, on"},
    Input{'.', Step, ".", "one step back, on"},
    Input{';', Slower, ";", "slower, faster"},
    Input{'\'', Faster, "'", "slower, faster"},
    Input{'J', Again, "J", "again, slowly"},
    Input{'R', Restart, "R", "restart"},
    Input{kLeftButton, UseTool, "left button", "the chosen tool"},
    Input{kFirstFunctionKey, ChooseTool, "F1", "hand, pin, cut"},
    Input{kFirstFunctionKey + 1, ChooseTool, "F2", "hand, pin, cut"},
    Input{kFirstFunctionKey + 2, ChooseTool, "F3", "hand, pin, cut"},
    Input{kRightButton, LookAround, "right drag", "look around"},
    Input{kWheel, Approach, "wheel", "nearer, farther"},
    Input{kControlDrag, LookAround, "Ctrl", "drag: look, nearer"},  // without a right button, without a wheel
    Input{kShiftDrag, Approach, "Shift", "drag: look, nearer"},
    Input{'W', MoveForward, "W", "move"},
    Input{'A', MoveLeft, "A", "move"},
    Input{'S', MoveBack, "S", "move"},
    Input{'D', MoveRight, "D", "move"},
    Input{'Q', MoveDown, "Q", "down, up"},
    Input{'E', MoveUp, "E", "down, up"},
    Input{'F', FrameCloth, "F", "find the cloth"},
    Input{'[', SmallerStep, "[", "smaller, larger step"},
    Input{']', LargerStep, "]", "smaller, larger step"},
    Input{'V', SafeStep, "V", "a safe step"},
    Input{'M', HoldingMethod, "M", ""},
    Input{kEnterKey, RunOn, "Enter", ""},
    Input{'K', OpenControl, "K", "control panel"},
    Input{'O', OpenGallery, "O", "scenes, in pictures"},
    Input{'C', OpenChart, "C", "chart: speed, accuracy"},
    Input{'G', OpenGhost, "G", "ghost: the true motion"},
    Input{'T', OpenStretch, "T", "stretch of the springs"},
    Input{'=', OpenEnergy, "=", "energy and power"},
    Input{'/', OpenTraces, "/", "traces of particles"},
    Input{kTabKey, OpenTraces, "Tab", "traces of particles"},  // where / is another key under Shift
    Input{'Y', KeepPicture, "Y", "picture, movie to files"},
    Input{'Z', Film, "Z", "picture, movie to files"},
    Input{'H', ShowHelp, "H", "these keys"},
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

}  // namespace

std::span<const Input> inputTable() { return kInputs; }

const Input* findInput(KeyCode key) {
  const auto* found = std::ranges::find(kInputs, key, &Input::key);
  return found == kInputs.end() ? nullptr : found;
}

std::size_t methodSlot(KeyCode key) {
  constexpr std::string_view kRow = "1234567890-";  // as on the keyboard
  return kRow.find(key);
}

std::size_t toolSlot(KeyCode key) { return static_cast<std::size_t>(key - kFirstFunctionKey); }

std::string_view toolKeyName(std::size_t slot) {
  if (slot >= static_cast<std::size_t>(kFunctionKeys)) return {};
  const Input* input = findInput(static_cast<KeyCode>(kFirstFunctionKey + static_cast<int>(slot)));
  return input == nullptr ? std::string_view() : input->keyName;
}

std::vector<HelpLine> helpLines(std::span<const std::string_view> methods) {
  std::vector<HelpLine> lines;
  for (const Input& input : inputTable()) {
    if (input.help.empty()) continue;
    if (input.action == ChooseMethod) {
      const std::size_t slot = methodSlot(input.key);
      if (slot >= methods.size()) continue;
      lines.push_back({std::string(input.keyName), std::string(methods[slot]), input.action, slot});
    } else if (!lines.empty() && lines.back().help == input.help) {
      lines.back().keys.append(" ").append(input.keyName);
    } else {
      lines.push_back({std::string(input.keyName), std::string(input.help), input.action});
    }
  }
  return lines;
}

std::vector<const HelpLine*> linesThatFit(std::span<const HelpLine> lines, bool choices, std::size_t room) {
  std::vector<const HelpLine*> fitting;
  for (const HelpLine& line : lines) {
    if (isChoice(line.action) != choices) continue;
    if (fitting.size() < room) {
      fitting.push_back(&line);
    } else if (line.action == ShowHelp && room > 0) {
      fitting.back() = &line;
    }
  }
  return fitting;
}

}  // namespace tyg
