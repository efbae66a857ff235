// What a person did with keys and mouse, and how large the window is: what every window library's news become.
// Must not know: windows, what a key means.
#pragma once

#include <string>

namespace tyg {

/// A key or a mouse button: printable keys by the upper-case letter, digit or sign that is printed on them.
using KeyCode = char;
inline constexpr KeyCode kEscapeKey = 27, kEnterKey = 13, kTabKey = 9;
inline constexpr KeyCode kLeftButton = 1, kRightButton = 2, kMiddleButton = 3;
inline constexpr KeyCode kWheel = 4;  ///< never pressed: names the wheel in the table of inputs
/// F1 to F12 and the arrow keys, which are the same on every keyboard; no character that is typed has these codes.
inline constexpr KeyCode kFirstFunctionKey = static_cast<KeyCode>(0x80);
inline constexpr int kFunctionKeys = 12;
inline constexpr KeyCode functionKey(int number) { return static_cast<KeyCode>(kFirstFunctionKey + number - 1); }
inline constexpr KeyCode kLeftKey = static_cast<KeyCode>(0x90), kRightKey = static_cast<KeyCode>(0x91),
                         kUpKey = static_cast<KeyCode>(0x92), kDownKey = static_cast<KeyCode>(0x93);
/// Keys together with Ctrl, for the table of inputs and for who clicks on their names: pressed, they come as the letter
/// with `control`.
inline constexpr KeyCode kUndoKeys = static_cast<KeyCode>(0x94), kRedoKeys = static_cast<KeyCode>(0x95),
                         kCopyKeys = static_cast<KeyCode>(0x96);
/// A left drag with one of those keys down; never pressed: they name it in the table of inputs.
inline constexpr KeyCode kControlDrag = 14, kShiftDrag = 15;
inline constexpr bool isMouse(KeyCode key) { return key >= kLeftButton && key <= kWheel; }

/// One thing that happened. Positions are in pixels of the framebuffer from its top left corner.
struct WindowEvent {
  /// Exposed: what was shown is gone. Drop: a file was dropped onto the window.
  enum class Kind { Press, Release, Move, Scroll, FocusLost, Exposed, Drop };
  Kind kind = Kind::Press;
  KeyCode key = 0;                      ///< Press, Release
  double x = 0, y = 0;                  ///< Move, and Press and Release of a mouse button
  double notches = 0;                   ///< Scroll: wheel steps, positive away from the person
  bool control = false, shift = false;  ///< Press, of keys and buttons: those keys are down as well
  std::string path{};                   ///< Drop
};

/// Pixels; 0 x 0 while nothing of the window can be seen.
struct Extent {
  int width = 0, height = 0;
  bool operator==(const Extent&) const = default;
};

}  // namespace tyg
