// What the system gives a program at its start: its words, and the three standard files.
// Must not know: what is printed.
#pragma once

#include <string>
#include <vector>

namespace tyg {

/// Opens those of the three standard files that the program was started without, so that no file of its own gets their
/// numbers and the messages with them; nothing can be read from them or written to them. From then on bytes go through
/// them as they are, and a terminal takes them as UTF-8. To be called first.
void prepareStandardFiles();

/// Whether messages, which go to standard error, are seen on a terminal.
bool messagesGoToTerminal();

/// What was typed behind the program's name, in UTF-8.
std::vector<std::string> programWords(int argc, char** argv);

}  // namespace tyg
