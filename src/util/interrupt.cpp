// The first Ctrl-C only sets a flag, which long work looks at; the second one ends the program at once. So does an
// alarm a second after the first, where nothing has looked at the flag until then.
#include "util/interrupt.h"

#include <csignal>

#include <sys/time.h>

#include <cmath>

namespace tyg {
namespace {

itimerval patience{};
volatile std::sig_atomic_t raised = 0, heard = 0;

// Work that cannot look at the flag, such as a library's factorisation, is ended as by a second signal.
extern "C" void endUnheard(int /*alarm*/) {
  if (heard != 0) return;
  std::signal(raised, SIG_DFL);
  std::raise(raised);
}

// A second signal finds the default action, so that a stuck program can still be ended.
extern "C" void raiseFlag(int signal) {
  raised = signal;
  std::signal(signal, SIG_DFL);
  std::signal(SIGALRM, endUnheard);
  setitimer(ITIMER_REAL, &patience, nullptr);
}

void watch(int signal) {
  if (std::signal(signal, raiseFlag) == SIG_IGN) std::signal(signal, SIG_IGN);
}

void unwatch(int signal) {
  if (std::signal(signal, SIG_DFL) == SIG_IGN) std::signal(signal, SIG_IGN);
}

}  // namespace

InterruptWatch::InterruptWatch(double seconds) {
  const double whole = std::floor(seconds);
  patience.it_value = {.tv_sec = time_t(whole), .tv_usec = suseconds_t(1e6 * (seconds - whole))};
  raised = 0;
  heard = 0;
  watch(SIGINT);
  watch(SIGTERM);
}

InterruptWatch::~InterruptWatch() {
  unwatch(SIGINT);
  unwatch(SIGTERM);
}

bool interrupted() {
  if (raised == 0) return false;
  heard = 1;
  return true;
}

}  // namespace tyg
