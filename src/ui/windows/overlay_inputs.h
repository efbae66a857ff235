// What the person did, as ImGui is told of it: ImGui looks at keys and buttons once a frame, so that a key that goes
// down and up between two frames would never have been down. Inputs wait here, and each frame is given as many as it
// can tell apart. ImGui 1.87 and later keep such a queue themselves: for those this one is not needed. Must not know:
// window libraries, what an input does.
#pragma once

#include <deque>
#include <vector>

struct ImGuiIO;

namespace tyg {

class OverlayInputs {
 public:
  /// True where ImGui has no queue of its own.
  static bool needed();

  struct Modifiers {
    bool control = false, shift = false, alt = false;
  };
  /// `code`: of io.KeysDown. `edits`: it does not write a character but moves, deletes or ends what is typed.
  void key(int code, bool down, bool edits, Modifiers modifiers);
  void text(unsigned character);
  void button(int which, bool down);  ///< of io.MouseDown
  void move(float x, float y);        ///< ImGui's units
  void wheel(float notches);

  /// Once a frame, before ImGui::NewFrame() and after whatever else sets the mouse.
  void give(ImGuiIO& io);
  /// Some of them are for later frames.
  [[nodiscard]] bool waiting() const { return !waiting_.empty(); }

 private:
  enum class Kind { Key, Text, Button, Move, Wheel };
  struct Input {
    Kind kind;
    int code = 0;
    bool down = false, edits = false;
    Modifiers modifiers{};
    float x = 0, y = 0;
  };
  struct Given;
  void add(const Input& input);
  static bool fits(const Input& input, const Given& given);
  void apply(const Input& input, ImGuiIO& io);

  std::deque<Input> waiting_;
  std::vector<int> down_;  // keys that ImGui was told of, or will be
  static constexpr int kButtons = 5;
  bool buttons_[kButtons]{};  // as ImGui was last told
  float x_ = 0, y_ = 0;
  bool moved_ = false;  // ever
};

}  // namespace tyg
