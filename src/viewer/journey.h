// The way to a past moment, which may take some frames, and what is to be done there.
// Must not know: where the moment is, how it is reached.
#pragma once

#include <functional>
#include <utility>

namespace tyg {

class Journey {
 public:
  /// Sets out; `then`, which may be empty, is for the end.
  void begin(std::function<void()> then) {
    underWay_ = true;
    then_ = std::move(then);
  }
  /// Gives it up, and what was to be done.
  void giveUp() {
    underWay_ = false;
    then_ = {};
  }
  /// It has ended: returns what is to be done now.
  [[nodiscard]] std::function<void()> arrive() {
    underWay_ = false;
    return std::exchange(then_, {});
  }
  [[nodiscard]] bool underWay() const { return underWay_; }

 private:
  bool underWay_ = false;
  std::function<void()> then_;
};

}  // namespace tyg
