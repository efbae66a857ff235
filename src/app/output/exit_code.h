// What the program's exit codes mean.
// Must not know: commands.
#pragma once

namespace tyg {

/// Exit codes that scripts may rely on.
enum ExitCode : int {
  kDone = 0,
  kSimulationFailed = 1,
  kWrongInput = 2,     ///< also an output that cannot be written
  kInterrupted = 130,  ///< Ctrl-C, as shells report it; single files are written whole or not at all
};

}  // namespace tyg
