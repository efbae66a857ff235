// Makes std::filesystem::path take texts for UTF-8, as they are everywhere in this program. GCC's library asks the C
// library for each character, which knows old code pages only; the linker sends the question here instead
// (CMakeLists.txt). Characters beyond 16 bits, which the question cannot be answered for, are refused.
#include <cstddef>
#include <cwchar>

namespace {

constexpr auto kWrong = static_cast<std::size_t>(-1), kGoesOn = static_cast<std::size_t>(-2);

/// How many bytes a character has that begins with this one; 0 where none does.
std::size_t lengthFrom(unsigned char first) {
  if (first < 0x80) return 1;
  if (first < 0xC2 || first >= 0xF0) return 0;
  return first < 0xE0 ? 2 : 3;
}

}  // namespace

/// As mbrtowc() of the C library.
extern "C" std::size_t __wrap_mbrtowc(wchar_t* to, const char* from, std::size_t count, std::mbstate_t* /*state*/);

std::size_t __wrap_mbrtowc(wchar_t* to, const char* from, std::size_t count, std::mbstate_t* /*state*/) {
  if (from == nullptr) return 0;
  if (count == 0) return kGoesOn;
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(from[k]); };
  const std::size_t length = lengthFrom(byte(0));
  if (length == 0) return kWrong;
  if (length > count) return kGoesOn;
  unsigned code = length == 1 ? byte(0) : byte(0) & (length == 2 ? 0x1FU : 0x0FU);
  for (std::size_t k = 1; k < length; ++k) {
    if ((byte(k) & 0xC0U) != 0x80) return kWrong;
    code = code << 6U | (byte(k) & 0x3FU);
  }
  if (to != nullptr) *to = static_cast<wchar_t>(code);
  return code == 0 ? 0 : length;
}
