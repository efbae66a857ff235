// Bytes and UTF-8 are what these systems have anyway.
#include "util/standard_files.h"

#include <fcntl.h>
#include <unistd.h>

namespace tyg {

void prepareStandardFiles() {
  for (const int file : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    // open() takes the lowest free number, which is this one.
    if (fcntl(file, F_GETFD) < 0) (void)open("/dev/null", file == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
}

bool messagesGoToTerminal() { return isatty(STDERR_FILENO) == 1; }

std::vector<std::string> programWords(int argc, char** argv) { return {argv + 1, argv + argc}; }

}  // namespace tyg
