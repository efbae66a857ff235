// The program's front door: which command was asked for, help, and how every failure becomes a message and an exit
// code. Must not know: what the commands do.
#pragma once

namespace tyg {

/// Exit codes that scripts may rely on.
enum ExitCode : int {
  kDone = 0,
  kSimulationFailed = 1,
  kWrongInput = 2,     ///< also an output that cannot be written
  kInterrupted = 130,  ///< Ctrl-C, as shells report it; single files are written whole or not at all
};

/// Runs what the command line asks for and returns the exit code. Nothing escapes: each failure is one message on
/// stderr.
int runCommandLine(int argc, char** argv);

}  // namespace tyg
