// Windows names things in UTF-16, this program in UTF-8.
// Must not know: what is named.
#pragma once

#include <string>
#include <string_view>

namespace tyg {

std::wstring wide(std::string_view utf8);
std::string narrow(std::wstring_view utf16);

}  // namespace tyg
