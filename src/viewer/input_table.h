// What each key and mouse button does: the one table from which inputs are dispatched and the help on screen is made.
// Must not know: windows, how an action is carried out.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "viewer/input_event.h"

namespace tyg {

/// Driving the cloth and the camera comes first, then (from ChooseMethod on) choices, which the help shows apart.
// clang-format off
enum class InputAction {
  StartOrPause, StepBack, Step, Slower, Faster, Again, Restart,
  UseTool, ChooseTool, LookAround, Approach,
  MoveForward, MoveLeft, MoveBack, MoveRight, MoveDown, MoveUp, LookLeft, LookRight, LookUp, LookDown, FrameCloth,
  SmallerStep, LargerStep, SafeStep, HoldingMethod, RunOn,
  OpenControl, OpenGallery, OpenChart, OpenGhost, OpenStretch, OpenEnergy, OpenTraces,
  KeepPicture, Film, Undo, Redo, Copy,
  ShowHelp, ShowAllKeys, Leave,
  ChooseMethod,
  ChangeShow, ShowStructural, ShowShear, ShowBend, ShowParticles, ShowPins, ShowGround, ChangeBackground,
  FullScreen,
};
// clang-format on
inline constexpr std::size_t kInputActions = static_cast<std::size_t>(InputAction::FullScreen) + 1;
inline constexpr bool isChoice(InputAction action) { return action >= InputAction::ChooseMethod; }

/// A key or button, what it does, and both as the help says them.
struct Input {
  KeyCode key;
  InputAction action;
  std::string_view keyName;
  std::string_view help;  ///< empty: the window offers it where it is of use
  bool first = false;     ///< in the short list of keys, which is all that newcomers need
};
/// Every input, in the order of the help. Those that share a help text are neighbours and share its line.
std::span<const Input> inputTable();
/// Null for a key that does nothing.
const Input* findInput(KeyCode key);
/// The method that a number key chooses, as its slot in methods(): 1 the first, 0 the tenth, - the eleventh.
std::size_t methodSlot(KeyCode key);

/// The tool that a function key chooses, as its slot in toolTable(): F2 the first, F3 the second.
std::size_t toolSlot(KeyCode key);
/// `F2` and so on: the key that chooses the tool in a slot; empty where there is none.
std::string_view toolKeyName(std::size_t slot);

/// A line of the help on screen: the keys that share its words.
struct HelpLine {
  std::vector<const Input*> inputs;  ///< one at least
  std::string help;
  std::size_t method = 0;  ///< with ChooseMethod: its slot in `methods`

  [[nodiscard]] InputAction action() const { return inputs.front()->action; }
  [[nodiscard]] std::string keys() const;  ///< their names, with spaces between them; one that repeats comes once
};
/// The help, with one line for each of these methods that has a number key.
std::vector<HelpLine> helpLines(std::span<const std::string_view> methods);
/// Of the short list the first `room` lines. Where not all fit, the one that shows all keys is the last to go.
std::vector<const HelpLine*> firstLines(std::span<const HelpLine> lines, std::size_t room);

}  // namespace tyg
