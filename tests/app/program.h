// Runs the built program as a shell would, for tests of what people and scripts see.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "files.h"

namespace tyg {

struct Outcome {
  int code = -1;
  std::string out, err;
};

/// `arguments` as one would type them; `before` goes in front of the program, such as VARIABLE=value.
Outcome tyg(const std::string& arguments, const std::string& before = "");

/// The value at a path of keys and indices ("status", "alone/0/dt") in JSON, as JSON; "missing" where there is none.
/// Throws where the text is no JSON.
std::string jsonValue(const std::string& json, const std::string& path);
/// Every key in JSON, in order. Throws where the text is no JSON.
std::vector<std::string> jsonKeys(const std::string& json);
/// Is the text one JSON object of numbers, strings, truths and nulls?
bool isFlatJson(const std::string& text);

}  // namespace tyg
