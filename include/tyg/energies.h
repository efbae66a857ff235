// Amounts of energy by name. Must not know: where they come from.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace tyg {

/// A short list of amounts of energy, each with the name of what stores it or does it. Never allocates.
class Energies {
 public:
  struct Entry {
    std::string_view name;  ///< of static storage
    double joules = 0;
  };
  static constexpr std::size_t kMost = 8;

  /// Adds an entry; there must be fewer than kMost.
  void add(std::string_view name, double joules) { entries_.at(count_++) = {name, joules}; }

  /// The entry of this name, J; 0 where there is none.
  [[nodiscard]] double operator[](std::string_view name) const {
    for (const Entry& entry : *this) {
      if (entry.name == name) return entry.joules;
    }
    return 0;
  }
  [[nodiscard]] bool has(std::string_view name) const {
    for (const Entry& entry : *this) {
      if (entry.name == name) return true;
    }
    return false;
  }
  [[nodiscard]] double sum() const {
    double sum = 0;
    for (const Entry& entry : *this) sum += entry.joules;
    return sum;
  }
  [[nodiscard]] std::size_t size() const { return count_; }
  [[nodiscard]] const Entry* begin() const { return entries_.data(); }
  [[nodiscard]] const Entry* end() const { return entries_.data() + count_; }

 private:
  std::array<Entry, kMost> entries_{};
  std::size_t count_ = 0;
};

}  // namespace tyg
