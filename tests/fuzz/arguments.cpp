// Fuzz target: the command line, a word a line. It is read, and nothing is run.
// Must not know: what the commands do.
#include <string>
#include <vector>

#include "app/command_line.h"
#include "fuzz.h"
#include "tyg/input_error.h"
#include "util/amounts.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<std::string> words(1);
  for (const char c : textOf(data, size)) {
    if (c == '\n') {
      words.emplace_back();
    } else if (c != '\0') {  // no word of a real command line has one
      words.back() += c;
    }
  }
  (void)tyg::readCommandLine(words);
  for (const std::string& word : words) {
    try {
      (void)tyg::parseLength("--error", word, 1);
      (void)tyg::parseTime("--budget", word);
    } catch (const tyg::InputError&) {
    }
  }
  return 0;
}
