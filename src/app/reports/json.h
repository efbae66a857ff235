// JSON as the commands print it.
// Must not know: what is reported.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace tyg {

/// The keys of an object keep the order in which they were set. Numbers that are not finite are written as null.
using Json = nlohmann::ordered_json;

/// The text of a value, one key a line. Bytes that are not UTF-8 become U+FFFD.
std::string jsonText(const Json& json);

}  // namespace tyg
