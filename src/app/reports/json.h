// JSON as the commands print it. The JSON library makes the text, but its header takes seconds to compile in each file
// that builds values with it, so only json.cpp includes it. Must not know: what is reported.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

namespace tyg {

/// A value of JSON. Copies share what they hold. The keys of an object keep the order in which they were set. Numbers
/// that are not finite are written as null.
class Json {
 public:
  struct Member;

  Json();  ///< null
  Json(bool value);
  Json(int value);
  Json(std::int64_t value);
  Json(std::uint64_t value);
  Json(double value);
  Json(const char* text);
  Json(std::string_view text);
  Json(const std::string& text);
  /// An object.
  Json(std::initializer_list<Member> members);
  static Json array();

  /// Appends to an array.
  void append(const Json& item);
  /// Sets keys of an object.
  void update(std::initializer_list<Member> members);

 private:
  friend std::string jsonText(const Json& json);

  std::shared_ptr<nlohmann::ordered_json> value_;
};

struct Json::Member {
  std::string_view key;
  Json value;
};

/// The text of a value, one key a line. Bytes that are not UTF-8 become U+FFFD.
std::string jsonText(const Json& json);

}  // namespace tyg
