// The first Ctrl-C only sets a flag, which long work looks at; the second one ends the program at once. So does an
// alarm a second after the first, where nothing has looked at the flag until then.
#include "util/interrupt.h"

#include <csignal>

#include <sys/time.h>

#include <cmath>

#include "util/sudden_end.h"

namespace tyg {
namespace {

itimerval patience{};
volatile std::sig_atomic_t raised = 0, asked = 0, heard = 0;

// Work that cannot look at the flag, such as a library's factorisation, is ended as by a second signal.
extern "C" void endUnheard(int /*alarm*/) {
  if (heard == 0) endBySignal(raised);
}

extern "C" void raiseFlag(int signal) {
  if (asked != 0 && signal != SIGHUP) endBySignal(signal);
  raised = signal;
  if (signal != SIGHUP) asked = 1;  // the kernel and the shell may both send that one when a terminal closes
  std::signal(SIGALRM, endUnheard);
  setitimer(ITIMER_REAL, &patience, nullptr);
}

void handle(int signal, void (*handler)(int)) {
  if (std::signal(signal, handler) == SIG_IGN) std::signal(signal, SIG_IGN);
}

}  // namespace

InterruptWatch::InterruptWatch(double seconds) {
  prepareForSuddenEnd();
  const double whole = std::floor(seconds);
  patience.it_value = {.tv_sec = time_t(whole), .tv_usec = suseconds_t(1e6 * (seconds - whole))};
  raised = 0;
  asked = 0;
  heard = 0;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) handle(signal, raiseFlag);
}

InterruptWatch::~InterruptWatch() {
  const itimerval none{};
  setitimer(ITIMER_REAL, &none, nullptr);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) handle(signal, endBySignal);
}

bool interrupted() {
  if (raised == 0) return false;
  heard = 1;
  return true;
}

}  // namespace tyg
