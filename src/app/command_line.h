// The program's front door: which command was asked for, help, and how every failure becomes a message and an exit
// code. Must not know: what the commands do.
#pragma once

namespace tyg {

/// Runs what the command line asks for and returns the exit code. Nothing escapes: each failure is one message on
/// stderr.
int runCommandLine(int argc, char** argv);

}  // namespace tyg
