// Ctrl-C comes in a thread of its own, which waits there for somebody to look at the flag.
#include "util/interrupt.h"

#include <windows.h>

#include <atomic>
#include <csignal>

#include "util/sudden_end.h"

namespace tyg {
namespace {

std::atomic<bool> watching = false, raised = false, heard = false;
std::atomic<double> patience = 0;  // s

/// TRUE: it has been seen to, and the process goes on.
BOOL WINAPI onConsole(DWORD event) {
  if (!watching || event == CTRL_LOGOFF_EVENT) return FALSE;
  if (raised.exchange(true)) return FALSE;
  const bool isClosing = event == CTRL_CLOSE_EVENT || event == CTRL_SHUTDOWN_EVENT;
  Sleep(DWORD(1000 * patience));
  if (!heard) return FALSE;
  if (isClosing) Sleep(INFINITE);  // the process is ended when this returns; the work ends it before
  return TRUE;
}

void onSignal(int signal) {
  if (raised.exchange(true)) endBySignal(signal);
  (void)std::signal(signal, onSignal);
}

}  // namespace

InterruptWatch::InterruptWatch(double seconds) {
  prepareForSuddenEnd();
  patience = seconds;
  raised = heard = false;
  watching = true;
  [[maybe_unused]] static const bool added = SetConsoleCtrlHandler(onConsole, TRUE) != 0;  // asked before sudden_end's
  (void)std::signal(SIGTERM, onSignal);
}

InterruptWatch::~InterruptWatch() {
  watching = false;
  (void)std::signal(SIGTERM, endBySignal);
}

bool interrupted() {
  if (!raised) return false;
  heard = true;
  return true;
}

}  // namespace tyg
