// The first Ctrl-C only sets a flag, which long work looks at; the second one ends the program at once.
#include "util/interrupt.h"

#include <csignal>

#include "util/sudden_end.h"

namespace tyg {
namespace {

volatile std::sig_atomic_t raised = 0, asked = 0;

extern "C" void raiseFlag(int signal) {
  raised = 1;
  if (signal == SIGHUP) return;  // the kernel and the shell may both send it when a terminal closes
  if (asked != 0) endBySignal(signal);
  asked = 1;
}

void handle(int signal, void (*handler)(int)) {
  if (std::signal(signal, handler) == SIG_IGN) std::signal(signal, SIG_IGN);
}

}  // namespace

InterruptWatch::InterruptWatch() {
  prepareForSuddenEnd();
  raised = 0;
  asked = 0;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) handle(signal, raiseFlag);
}

InterruptWatch::~InterruptWatch() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) handle(signal, endBySignal);
}

bool interrupted() { return raised != 0; }

}  // namespace tyg
