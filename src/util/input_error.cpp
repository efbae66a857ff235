// A message is read as a C string, which ends at the first NUL: those that a file had are written as people write them.
#include "tyg/input_error.h"

namespace tyg {
namespace {

std::string withVisibleNuls(const std::string& message) {
  std::string visible;
  for (const char c : message) c == '\0' ? visible += "\\0" : visible += c;
  return visible;
}

}  // namespace

InputError::InputError(const std::string& message) : std::runtime_error(withVisibleNuls(message)) {}

}  // namespace tyg
