// One sentence for the person, shown until the next input: what was done, or what is not as it was wanted.
// Must not know: who says it, where it is shown.
#pragma once

#include <string>
#include <utility>

namespace tyg {

class Notes {
 public:
  void say(std::string text) { text_ = std::move(text), warns_ = false; }
  void warn(std::string text) { text_ = std::move(text), warns_ = true; }
  void clear() { text_.clear(); }

  [[nodiscard]] const std::string& text() const { return text_; }  ///< empty: there is nothing to say
  [[nodiscard]] bool warns() const { return warns_; }

 private:
  std::string text_;
  bool warns_ = false;
};

}  // namespace tyg
