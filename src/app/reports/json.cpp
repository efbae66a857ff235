// Numbers have the fewest digits that read back as the same number: that is how the library writes them.
#include "app/reports/json.h"

#include <nlohmann/json.hpp>

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

std::string jsonText(const Json& json) {
  constexpr int kIndent = 2;
  constexpr bool kEscapesAllButAscii = false;
  return json.value_->dump(kIndent, ' ', kEscapesAllButAscii, Value::error_handler_t::replace);
}

}  // namespace tyg
