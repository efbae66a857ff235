// Numbers have the fewest digits that read back as the same number: that is how the library writes them.
#include "app/reports/json.h"

namespace tyg {

std::string jsonText(const Json& json) {
  constexpr int kIndent = 2;
  constexpr bool kEscapesAllButAscii = false;
  return json.dump(kIndent, ' ', kEscapesAllButAscii, Json::error_handler_t::replace);
}

}  // namespace tyg
