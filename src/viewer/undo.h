// The versions of one thing in their order, for undo and redo: one of them is the present one.
// Must not know: what the thing is, who changes it.
#pragma once

#include <cstddef>
#include <deque>
#include <utility>

namespace tyg {

/// T is a regular type: it is copied, and compared to tell a change from none.
template <class T>
class UndoStack {
 public:
  /// Older versions than this many are forgotten.
  static constexpr std::size_t kMost = 500;

  explicit UndoStack(T first) { versions_.push_back(std::move(first)); }

  [[nodiscard]] const T& present() const { return versions_[present_]; }
  /// A new present version; those that were undone are forgotten. Nothing happens where it equals the present one.
  void note(const T& version) {
    if (version == present()) return;
    versions_.resize(present_ + 1, version);
    versions_.push_back(version);
    if (versions_.size() > kMost) versions_.pop_front();
    present_ = versions_.size() - 1;
  }
  /// Changes every version with `change`, and drops those that it makes equal to the one before them.
  template <class Change>
  void rewrite(const Change& change) {
    std::deque<T> kept;
    for (std::size_t k = 0, before = present_; k < versions_.size(); ++k) {
      change(versions_[k]);
      if (kept.empty() || versions_[k] != kept.back()) kept.push_back(std::move(versions_[k]));
      if (k == before) present_ = kept.size() - 1;
    }
    versions_ = std::move(kept);
  }
  [[nodiscard]] bool canUndo() const { return present_ > 0; }
  [[nodiscard]] bool canRedo() const { return present_ + 1 < versions_.size(); }
  /// The version before the present one, which it becomes; the present one where there is none before.
  const T& undo() { return versions_[canUndo() ? --present_ : present_]; }
  const T& redo() { return versions_[canRedo() ? ++present_ : present_]; }

 private:
  std::deque<T> versions_;  ///< oldest first, never empty
  std::size_t present_ = 0;
};

}  // namespace tyg
