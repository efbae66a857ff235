// Signals tell of every early end of a process here; those that the program was started to ignore stay ignored.
#include "util/sudden_end_system.h"

#include <unistd.h>

#include <array>
#include <csignal>

namespace tyg {
namespace {

/// Signals that end a process which does not handle them.
constexpr std::array kDeadly{SIGHUP,  SIGINT,  SIGTERM, SIGQUIT, SIGPIPE, SIGALRM, SIGUSR1, SIGUSR2,
                             SIGXCPU, SIGABRT, SIGSEGV, SIGBUS,  SIGFPE,  SIGILL,  SIGSYS,  SIGVTALRM};

}  // namespace

void catchSuddenEnds() {
  for (const int signal : kDeadly) {
    struct sigaction now {};
    if (sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_DFL) (void)std::signal(signal, endBySignal);
  }
  (void)std::signal(SIGXFSZ, SIG_IGN);
}

void removeFile(const char* path) { ::unlink(path); }

void endPrograms(ProcessGroup group) { ::kill(-group.number, SIGKILL); }

void ignoreClosedPipes() { (void)std::signal(SIGPIPE, SIG_IGN); }

}  // namespace tyg
