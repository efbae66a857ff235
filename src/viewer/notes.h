// One sentence for the person, shown until the next input, or for a while: what was done, or what is not as it was
// wanted.
// Must not know: who says it, where it is shown.
#pragma once

#include <limits>
#include <string>
#include <utility>

namespace tyg {

class Notes {
 public:
  static constexpr double kFiles = 10;  ///< s: long enough to read where a file is
  /// `until`: it stays so long at least, s of the clock that clear() is told of.
  void say(std::string text, double until = kNotAtAll) { text_ = std::move(text), warns_ = false, until_ = until; }
  void warn(std::string text) { text_ = std::move(text), warns_ = true, until_ = kNotAtAll; }
  void clear() { text_.clear(); }
  /// An input came at this time.
  void clear(double now) {
    if (now >= until_) clear();
  }

  [[nodiscard]] const std::string& text() const { return text_; }  ///< empty: there is nothing to say
  [[nodiscard]] bool warns() const { return warns_; }

 private:
  std::string text_;
  bool warns_ = false;
  static constexpr double kNotAtAll = -std::numeric_limits<double>::infinity();
  double until_ = kNotAtAll;
};

}  // namespace tyg
