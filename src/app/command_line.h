// The program's front door: which command was asked for, help, and how every failure becomes a message and an exit
// code. Must not know: what the commands do.
#pragma once

#include <string>
#include <vector>

namespace tyg {

/// Runs what the command line asks for and returns the exit code. Nothing escapes: each failure is one message on
/// stderr.
int runCommandLine(int argc, char** argv);

/// The same without running the command: the exit code of what is wrong with these words, 0 where nothing is.
int readCommandLine(const std::vector<std::string>& words);

}  // namespace tyg
