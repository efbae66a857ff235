// Windows tells of Ctrl-C and of a closed console in a thread of its own, and of faults by a filter.
#include "util/sudden_end_system.h"

#include <windows.h>

#include <csignal>

namespace tyg {
namespace {

LONG WINAPI onFault(EXCEPTION_POINTERS* /*what*/) {
  clearUnfinished();
  return EXCEPTION_CONTINUE_SEARCH;
}

BOOL WINAPI onConsole(DWORD /*event*/) {
  clearUnfinished();
  return FALSE;  // the system ends the process
}

}  // namespace

void catchSuddenEnds() {
  SetUnhandledExceptionFilter(onFault);
  for (const int signal : {SIGABRT, SIGTERM}) (void)std::signal(signal, endBySignal);
  SetConsoleCtrlHandler(onConsole, TRUE);
}

void removeFile(const wchar_t* path) { DeleteFileW(path); }

void endPrograms(ProcessGroup /*group*/) {}  // they end with this one in any case (child_process.cpp here)

void ignoreClosedPipes() {}  // writing to one fails here, and is no signal

}  // namespace tyg
