// Text is passed on character by character; only a character that came in parts is held back.
#include "app/output/standard_streams.h"

#include <algorithm>

#include "util/visible_text.h"

namespace tyg {
namespace {

/// How many bytes at the end of the text may be the beginning of a character of UTF-8.
std::size_t begunCharacter(std::string_view text) {
  for (std::size_t count = 1; count <= std::min<std::size_t>(3, text.size()); ++count) {
    const auto byte = static_cast<unsigned char>(text[text.size() - count]);
    if (byte < 0x80) return 0;
    if (byte < 0xC0) continue;  // it goes on with a character
    const std::size_t length = byte >= 0xF0 ? 4 : byte >= 0xE0 ? 3 : 2;
    return length > count ? count : 0;
  }
  return 0;
}

}  // namespace

HarmlessOutput::~HarmlessOutput() {
  sync();
  stream_.rdbuf(below_);
}

HarmlessOutput::int_type HarmlessOutput::overflow(int_type character) {
  if (traits_type::eq_int_type(character, traits_type::eof())) return traits_type::not_eof(character);
  const char byte = traits_type::to_char_type(character);
  return xsputn(&byte, 1) == 1 ? character : traits_type::eof();
}

std::streamsize HarmlessOutput::xsputn(const char* text, std::streamsize count) {
  held_.append(text, static_cast<std::size_t>(count));
  return pass(held_.size() - begunCharacter(held_)) ? count : 0;
}

int HarmlessOutput::sync() { return pass(held_.size()) && below_->pubsync() == 0 ? 0 : -1; }

/// Passes on so many bytes of what is held.
bool HarmlessOutput::pass(std::size_t count) {
  const std::string text = withoutActive(std::string_view(held_).substr(0, count));
  held_.erase(0, count);
  const auto size = static_cast<std::streamsize>(text.size());
  return below_->sputn(text.data(), size) == size;
}

}  // namespace tyg
