// The first Ctrl-C only sets a flag, which long work looks at; the second one ends the program at once.
#include "util/interrupt.h"

#include <csignal>

namespace tyg {
namespace {

volatile std::sig_atomic_t raised = 0;

// A second signal finds the default action, so that a stuck program can still be ended.
extern "C" void raiseFlag(int signal) {
  raised = 1;
  std::signal(signal, SIG_DFL);
}

void watch(int signal) {
  if (std::signal(signal, raiseFlag) == SIG_IGN) std::signal(signal, SIG_IGN);
}

void unwatch(int signal) {
  if (std::signal(signal, SIG_DFL) == SIG_IGN) std::signal(signal, SIG_IGN);
}

}  // namespace

InterruptWatch::InterruptWatch() {
  raised = 0;
  watch(SIGINT);
  watch(SIGTERM);
}

InterruptWatch::~InterruptWatch() {
  unwatch(SIGINT);
  unwatch(SIGTERM);
}

bool interrupted() { return raised != 0; }

}  // namespace tyg
