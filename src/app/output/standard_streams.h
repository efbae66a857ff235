// The standard streams of the program: what is printed cannot steer the terminal, whichever title, file name or message
// of another program is in it. Must not know: what is printed.
#pragma once

#include <ios>
#include <streambuf>
#include <string>

namespace tyg {

/// While it lives, what a stream prints goes through withoutActive() (util/visible_text.h).
class HarmlessOutput final : public std::streambuf {
 public:
  explicit HarmlessOutput(std::ios& stream) : stream_(stream), below_(stream.rdbuf(this)) {}
  ~HarmlessOutput() override;
  HarmlessOutput(const HarmlessOutput&) = delete;
  HarmlessOutput& operator=(const HarmlessOutput&) = delete;

 protected:
  int_type overflow(int_type character) override;
  std::streamsize xsputn(const char* text, std::streamsize count) override;
  int sync() override;

 private:
  bool pass(std::size_t count);

  std::ios& stream_;
  std::streambuf* below_;
  std::string held_;  // the beginning of a character whose end is still to come
};

}  // namespace tyg
