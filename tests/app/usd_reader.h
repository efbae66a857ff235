// A small reader of USD's text format for tests: prims, their attributes, and time samples. It knows the grammar as far
// as exported scenes use it, and throws where a text does not follow that. Must not know: how the program writes.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace tyg {

struct UsdPrim {
  std::string type, name;
  std::map<std::string, std::string> values;                             ///< by attribute, as they are written
  std::map<std::string, std::map<double, std::vector<double>>> samples;  ///< by attribute and time code
  std::vector<UsdPrim> prims;

  [[nodiscard]] const UsdPrim& prim(const std::string& wanted) const;             ///< Throws where there is none
  [[nodiscard]] std::vector<double> numbers(const std::string& attribute) const;  ///< of a value; likewise
};

/// The whole layer; its metadata are the values of the result.
UsdPrim readUsd(const std::string& text);

}  // namespace tyg
