// Which actions last while their key is held, which repeat, and how often.
#include "viewer/held_keys.h"

#include <algorithm>

namespace tyg {
namespace {

using enum InputAction;

/// A held key acts again after this long, and then this often, s.
constexpr double kRepeatAfter = 0.35, kRepeatEvery = 0.05;

bool repeatsItself(InputAction action) {
  return action == StepBack || action == Step || action == SmallerStep || action == LargerStep;
}
bool lasts(InputAction action) { return action == LookAround || (action >= MoveForward && action <= LookDown); }

}  // namespace

void HeldKeys::press(const Input& input, double now) {
  const auto action = static_cast<std::size_t>(input.action);
  if (lasts(input.action)) held_.at(action) = true;
  if (lasts(input.action)) due_.at(action) = kShortest;
  if (!repeatsItself(input.action)) return;
  repeated_ = input;
  repeatAt_ = now + kRepeatAfter;
}

void HeldKeys::release(KeyCode key) {
  const Input* input = findInput(key);
  if (input == nullptr) return repeated_.reset();  // one library tells of `{` where `[` is let go of under Shift
  held_.at(static_cast<std::size_t>(input->action)) = false;
  if (repeated_ && repeated_->key == key) repeated_.reset();
}

void HeldKeys::releaseAll() {
  held_.fill(false);
  due_.fill(0);
  repeated_.reset();
}

Motion HeldKeys::motion() const {
  const auto acts = [this](InputAction action) {
    return held(action) || due_.at(static_cast<std::size_t>(action)) > 0 ? 1.0F : 0.0F;
  };
  const auto along = [&](InputAction plus, InputAction minus) { return acts(plus) - acts(minus); };
  return {.right = along(MoveRight, MoveLeft),
          .up = along(MoveUp, MoveDown),
          .forward = along(MoveForward, MoveBack),
          .lookRight = along(LookRight, LookLeft),
          .lookUp = along(LookUp, LookDown)};
}

void HeldKeys::moved(double seconds) {
  for (double& due : due_) due = std::max(0.0, due - seconds);
}

bool HeldKeys::moves() const { return motion() != Motion{}; }

std::optional<InputAction> HeldKeys::due(double now) {
  if (!repeated_ || now < repeatAt_) return std::nullopt;
  repeatAt_ = now + kRepeatEvery;
  return repeated_->action;
}

}  // namespace tyg
