// The keys and buttons that are held down: they move the camera, or act again and again.
// Must not know: windows, what an action does.
#pragma once

#include <array>
#include <optional>

#include "view/camera.h"
#include "viewer/input_table.h"

namespace tyg {

class HeldKeys {
 public:
  /// `now`: s, of any clock, the same one as for due().
  void press(const Input& input, double now);
  void release(KeyCode key);
  void releaseAll();

  [[nodiscard]] bool held(InputAction action) const { return held_.at(static_cast<std::size_t>(action)); }
  /// Where the held keys move the camera.
  [[nodiscard]] Motion motion() const;
  [[nodiscard]] bool moves() const;  ///< motion() is not nothing
  /// A key is held whose action is done again and again.
  [[nodiscard]] bool repeats() const { return repeated_.has_value(); }
  /// The action that is to be done again now; nothing until then.
  [[nodiscard]] std::optional<InputAction> due(double now);

 private:
  std::array<bool, kInputActions> held_{};
  std::optional<Input> repeated_;  ///< its key is held down and acts again ...
  double repeatAt_ = 0;            ///< ... at this time, s
};

}  // namespace tyg
