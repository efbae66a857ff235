// What the table of unfinished things (sudden_end.cpp) and the system need of each other. Handlers of signals call all
// of it but catchSuddenEnds(), so that none of it may allocate or lock.
#pragma once

#include <filesystem>

#include "util/sudden_end.h"

namespace tyg {

/// Ends the programs and removes the files that are unfinished.
void clearUnfinished();

/// From now on clearUnfinished() is called where a signal or a fault ends the process.
void catchSuddenEnds();

void removeFile(const std::filesystem::path::value_type* path);
void endPrograms(ProcessGroup group);

}  // namespace tyg
