// Signals tell of every early end of a process here; those that the program was started to ignore stay ignored.
#include "util/sudden_end_system.h"

#include <unistd.h>

#include <array>
#include <csignal>

namespace tyg {
namespace {

/// Signals that end a process which does not handle them, and those of them that tell of a fault.
constexpr std::array kDeadly{SIGHUP,  SIGINT,  SIGTERM, SIGQUIT, SIGPIPE, SIGALRM,
                             SIGUSR1, SIGUSR2, SIGXCPU, SIGABRT, SIGSYS,  SIGVTALRM};
constexpr std::array kFaults{SIGSEGV, SIGBUS, SIGFPE, SIGILL};

/// A fault happens again where it happened once this has returned, so that the system's log and a core dump name its
/// place. A signal that a program has sent has no such place.
extern "C" void endByFault(int signal, siginfo_t* cause, void* /*context*/) {
  if (cause->si_code <= 0) return endBySignal(signal);
  clearUnfinished();
  (void)std::signal(signal, SIG_DFL);
}

bool hasNoHandler(int signal) {
  struct sigaction now {};
  return sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_DFL;
}

}  // namespace

void catchSuddenEnds() {
  for (const int signal : kDeadly) {
    if (hasNoHandler(signal)) (void)std::signal(signal, endBySignal);
  }
  struct sigaction onFault {};
  onFault.sa_sigaction = endByFault;
  onFault.sa_flags = SA_SIGINFO;
  for (const int signal : kFaults) {
    if (hasNoHandler(signal)) sigaction(signal, &onFault, nullptr);
  }
  (void)std::signal(SIGXFSZ, SIG_IGN);
}

void removeFile(const char* path) { ::unlink(path); }

void endPrograms(ProcessGroup group) { ::kill(-group.number, SIGKILL); }

void ignoreClosedPipes() { (void)std::signal(SIGPIPE, SIG_IGN); }

}  // namespace tyg
