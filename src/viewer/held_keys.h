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
  /// A key that moves the camera does so for kShortest at least, however soon it is released.
  void press(const Input& input, double now);
  void release(KeyCode key);
  void releaseAll();

  [[nodiscard]] bool held(InputAction action) const { return held_.at(static_cast<std::size_t>(action)); }
  /// Where the held keys move the camera.
  [[nodiscard]] Motion motion() const;
  /// It has moved so for this long, s.
  void moved(double seconds);
  [[nodiscard]] bool moves() const;  ///< motion() is not nothing
  /// A key is held whose action is done again and again.
  [[nodiscard]] bool repeats() const { return repeated_.has_value(); }
  /// The action that is to be done again now; nothing until then.
  [[nodiscard]] std::optional<InputAction> due(double now);

 private:
  static constexpr double kShortest = 1.0 / 60;  // s
  std::array<bool, kInputActions> held_{};
  std::array<double, kInputActions> due_{};  ///< s for which a key that was pressed has still to move the camera
  std::optional<Input> repeated_;            ///< its key is held down and acts again ...
  double repeatAt_ = 0;                      ///< ... at this time, s
};

}  // namespace tyg
