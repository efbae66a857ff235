// One pass over the text. A value is what stands up to the end of its line, or up to its closing bracket.
#include "app/usd_reader.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <stdexcept>

namespace tyg {
namespace {

std::vector<double> numbersIn(const std::string& text) {
  std::vector<double> numbers;
  const std::string between = "[]() ,\n";
  for (const char* at = text.c_str(); *at != '\0';) {
    if (between.find(*at) != std::string::npos) {
      ++at;
      continue;
    }
    char* end = nullptr;
    numbers.push_back(std::strtod(at, &end));
    if (end == at) throw std::runtime_error("not a number: " + std::string(at).substr(0, 20));
    at = end;
  }
  return numbers;
}

class Reader {
 public:
  explicit Reader(const std::string& text) : text_(text) {}

  UsdPrim layer() {
    UsdPrim layer;
    expect("#usda 1.0");
    expect("(");
    while (!accept(")")) readValue(layer);
    while (!atEnd()) layer.prims.push_back(prim());
    return layer;
  }

 private:
  void skipBlanks() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
  }
  bool atEnd() {
    skipBlanks();
    return at_ == text_.size();
  }
  bool accept(const std::string& wanted) {
    skipBlanks();
    if (text_.compare(at_, wanted.size(), wanted) != 0) return false;
    at_ += wanted.size();
    return true;
  }
  void expect(const std::string& wanted) {
    if (!accept(wanted)) throw std::runtime_error("expected " + wanted + " at: " + text_.substr(at_, 30));
  }
  std::string word() {
    skipBlanks();
    const std::size_t from = at_;
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) == 0) ++at_;
    return text_.substr(from, at_ - from);
  }
  std::string quoted() {
    expect("\"");
    const std::size_t from = at_;
    while (text_.at(at_) != '"') at_ += text_.at(at_) == '\\' ? 2 : 1;
    return text_.substr(from, at_++ - from);
  }
  /// A quoted text, a list or a tuple with all that is in it, or a single word.
  std::string value() {
    skipBlanks();
    if (text_.at(at_) == '"') return quoted();
    if (text_.at(at_) != '[' && text_.at(at_) != '(') {
      const std::size_t from = at_;
      at_ = text_.find_first_of(" ,\n", at_);
      return text_.substr(from, at_ - from);
    }
    const std::size_t from = at_;
    int depth = 0;
    do {
      const char c = text_.at(at_++);
      depth += c == '[' || c == '(' ? 1 : c == ']' || c == ')' ? -1 : 0;
    } while (depth > 0);
    return text_.substr(from, at_ - from);
  }
  /// `[uniform] [TYPE] NAME = VALUE [(METADATA)]`, or `TYPE NAME.timeSamples = { CODE: VALUE, ... }`.
  void readValue(UsdPrim& to) {
    std::string name;
    while (!accept("=")) name = word();
    const std::string ending = ".timeSamples";
    if (!name.ends_with(ending)) {
      to.values[name] = value();
      if (accept("(")) at_ = text_.find(')', at_) + 1;
      return;
    }
    auto& samples = to.samples[name.substr(0, name.size() - ending.size())];
    expect("{");
    while (!accept("}")) {
      const std::string code = word();
      if (!code.ends_with(":")) throw std::runtime_error("no time code: " + code);
      samples[std::strtod(code.c_str(), nullptr)] = numbersIn(value());
      expect(",");
    }
  }
  UsdPrim prim() {
    UsdPrim prim;
    expect("def ");
    prim.type = word();
    prim.name = quoted();
    expect("{");
    while (!accept("}")) {
      if (text_.compare(at_, 4, "def ") == 0) {
        prim.prims.push_back(this->prim());
      } else {
        readValue(prim);
      }
    }
    return prim;
  }

  const std::string& text_;
  std::size_t at_ = 0;
};

}  // namespace

const UsdPrim& UsdPrim::prim(const std::string& wanted) const {
  const auto found = std::ranges::find(prims, wanted, &UsdPrim::name);
  if (found == prims.end()) throw std::runtime_error("no prim " + wanted);
  return *found;
}

std::vector<double> UsdPrim::numbers(const std::string& attribute) const { return numbersIn(values.at(attribute)); }

UsdPrim readUsd(const std::string& text) { return Reader(text).layer(); }

}  // namespace tyg
