// One JSON object, key by key in the order in which they are added.
// Must not know: what is reported.
#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>

namespace tyg {

/// A JSON string literal with its quotes; bytes that are no UTF-8 become U+FFFD.
std::string jsonString(std::string_view text);
/// The shortest text that reads back as the same number; `null` where it is not finite.
std::string jsonNumber(double number);

class JsonObject {
 public:
  void add(std::string_view key, std::string_view text) { addRaw(key, jsonString(text)); }
  void add(std::string_view key, const char* text) { addRaw(key, jsonString(text)); }
  void add(std::string_view key, double number) { addRaw(key, jsonNumber(number)); }
  template <std::integral Integer>
  void add(std::string_view key, Integer number) {
    addRaw(key, std::to_string(number));
  }
  /// `json` is a value already written as JSON.
  void addRaw(std::string_view key, std::string_view json);
  /// The object so far, one key a line.
  [[nodiscard]] std::string text() const { return "{" + members_ + (members_.empty() ? "}" : "\n}"); }

 private:
  std::string members_;
};

}  // namespace tyg
