// Numbers have the fewest digits that read back as the same number: that is how the library writes them.
#include "app/reports/json.h"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "util/utf8.h"
#include "util/visible_text.h"

namespace tyg {

using Value = nlohmann::ordered_json;

Json::Json() : value_(std::make_shared<Value>()) {}
Json::Json(bool value) : value_(std::make_shared<Value>(value)) {}
Json::Json(int value) : Json(std::int64_t{value}) {}
Json::Json(std::int64_t value) : value_(std::make_shared<Value>(value)) {}
Json::Json(std::uint64_t value) : value_(std::make_shared<Value>(value)) {}
Json::Json(double value) : value_(std::make_shared<Value>(value)) {}
Json::Json(const char* text) : Json(std::string(text)) {}
Json::Json(std::string_view text) : Json(std::string(text)) {}
Json::Json(const std::string& text) : value_(std::make_shared<Value>(text)) {}

Json::Json(std::initializer_list<Member> members) : value_(std::make_shared<Value>(Value::object())) {
  update(members);
}

Json Json::array() {
  Json list;
  *list.value_ = Value::array();
  return list;
}

void Json::append(const Json& item) { value_->push_back(*item.value_); }

void Json::update(std::initializer_list<Member> members) {
  for (const Member& member : members) (*value_)[std::string(member.key)] = *member.value.value_;
}

namespace {

/// Writes characters that would do something where the text is shown as JSON's escapes of UTF-16; the library does so
/// for the first 32 codes alone.
std::string withEscapes(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const Utf8Character character = firstCharacter(text);
    if (character.code < 0x7F || !isActive(character.code)) {
      result += text.substr(0, character.length);
    } else if (character.code <= 0xFFFF) {
      result += fmt::format("\\u{:04x}", std::uint32_t{character.code});
    } else {
      const std::uint32_t above = character.code - 0x10000;
      result += fmt::format("\\u{:04x}\\u{:04x}", 0xD800 + (above >> 10U), 0xDC00 + (above & 0x3FFU));
    }
    text.remove_prefix(character.length);
  }
  return result;
}

}  // namespace

std::string jsonText(const Json& json) {
  constexpr int kIndent = 2;
  constexpr bool kEscapesAllButAscii = false;
  return withEscapes(json.value_->dump(kIndent, ' ', kEscapesAllButAscii, Value::error_handler_t::replace));
}

}  // namespace tyg
