// What is not valid becomes U+FFFD.
#include "util/windows/wide.h"

#include <windows.h>

namespace tyg {

std::wstring wide(std::string_view utf8) {
  const int length = MultiByteToWideChar(CP_UTF8, 0, utf8.data(), int(utf8.size()), nullptr, 0);
  std::wstring text(std::size_t(length), L'\0');
  MultiByteToWideChar(CP_UTF8, 0, utf8.data(), int(utf8.size()), text.data(), length);
  return text;
}

std::string narrow(std::wstring_view utf16) {
  const int length = WideCharToMultiByte(CP_UTF8, 0, utf16.data(), int(utf16.size()), nullptr, 0, nullptr, nullptr);
  std::string text(std::size_t(length), '\0');
  WideCharToMultiByte(CP_UTF8, 0, utf16.data(), int(utf16.size()), text.data(), length, nullptr, nullptr);
  return text;
}

}  // namespace tyg
