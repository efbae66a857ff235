// A frame ends before an input that it could not tell from those before it, or would take in another order.
#include "ui/windows/overlay_inputs.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <vector>

namespace tyg {

/// What a frame has been given so far.
struct OverlayInputs::Given {
  std::array<bool, kButtons> buttons{};
  std::vector<int> keys;
  bool text = false, editing = false, button = false, move = false, wheel = false;
};

bool OverlayInputs::needed() { return IMGUI_VERSION_NUM < 18700; }

void OverlayInputs::add(const Input& input) {
  if (needed()) waiting_.push_back(input);
}
/// What writes a character is told by text(), unless it is a command.
void OverlayInputs::key(int code, bool down, bool edits, Modifiers modifiers) {
  const bool writes = !edits && !modifiers.control && !modifiers.alt;
  if (down ? writes : std::erase(down_, code) == 0) return;
  if (down) down_.push_back(code);
  add({.kind = Kind::Key, .code = code, .down = down, .edits = edits, .modifiers = modifiers});
}
void OverlayInputs::text(unsigned character) { add({.kind = Kind::Text, .code = static_cast<int>(character)}); }
void OverlayInputs::button(int which, bool down) {
  if (which >= 0 && which < kButtons) add({.kind = Kind::Button, .code = which, .down = down});
}
void OverlayInputs::move(float x, float y) {
  if (!waiting_.empty() && waiting_.back().kind == Kind::Move) waiting_.pop_back();
  add({.kind = Kind::Move, .x = x, .y = y});
}
void OverlayInputs::wheel(float notches) { add({.kind = Kind::Wheel, .y = notches}); }

bool OverlayInputs::fits(const Input& input, const Given& given) {
  switch (input.kind) {
    case Kind::Key:
      return std::ranges::find(given.keys, input.code) == given.keys.end() && !(given.text && input.edits);
    case Kind::Text:
      return !given.editing;
    case Kind::Button:
      // A drag's last movement comes before the button goes up.
      return !given.buttons.at(static_cast<std::size_t>(input.code)) && !given.wheel && (input.down || !given.move);
    case Kind::Move:
    case Kind::Wheel:
      return !given.button && (input.kind == Kind::Wheel || !given.wheel);
  }
  return true;
}

void OverlayInputs::apply([[maybe_unused]] const Input& input, [[maybe_unused]] ImGuiIO& io) {
#if IMGUI_VERSION_NUM < 18700
  switch (input.kind) {
    case Kind::Key:
      if (input.code >= 0 && input.code < IM_ARRAYSIZE(io.KeysDown)) io.KeysDown[input.code] = input.down;
      io.KeyCtrl = input.modifiers.control, io.KeyShift = input.modifiers.shift, io.KeyAlt = input.modifiers.alt;
      return;
    case Kind::Text:
      return io.AddInputCharacter(static_cast<unsigned>(input.code));
    case Kind::Button:
      buttons_[input.code] = input.down;
      return;
    case Kind::Move:
      x_ = input.x, y_ = input.y, moved_ = true;
      return;
    case Kind::Wheel:
      io.MouseWheel += input.y;
      return;
  }
#endif
}

void OverlayInputs::give(ImGuiIO& io) {
  if (!needed()) return;
  Given given;
  while (!waiting_.empty() && fits(waiting_.front(), given)) {
    const Input& input = waiting_.front();
    apply(input, io);
    if (input.kind == Kind::Key) given.keys.push_back(input.code);
    if (input.kind == Kind::Key && input.down) given.editing = given.editing || input.edits;
    if (input.kind == Kind::Button) given.buttons.at(static_cast<std::size_t>(input.code)) = given.button = true;
    given.move = given.move || input.kind == Kind::Move;
    given.text = given.text || input.kind == Kind::Text;
    given.wheel = given.wheel || input.kind == Kind::Wheel;
    waiting_.pop_front();
  }
  // A click takes two frames: where those are slow, so is a double click.
  constexpr float kDoubleClick = 0.3F;  // s
  io.MouseDoubleClickTime = kDoubleClick + 3 * io.DeltaTime;
  std::ranges::copy(buttons_, io.MouseDown);
  if (moved_) io.MousePos = {x_, y_};
}

}  // namespace tyg
