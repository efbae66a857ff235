// A handler of signals may neither allocate nor lock: what is unfinished is kept in a table of fixed size.
#include "util/sudden_end.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <climits>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <utility>

namespace tyg {
namespace {

/// Signals that end a process which does not handle them.
constexpr std::array kDeadly{SIGHUP,  SIGINT,  SIGTERM, SIGQUIT, SIGPIPE, SIGALRM, SIGUSR1, SIGUSR2,
                             SIGXCPU, SIGABRT, SIGSEGV, SIGBUS,  SIGFPE,  SIGILL,  SIGSYS,  SIGVTALRM};

struct Slot {
  enum State : int { Free, BeingFilled, Filled };
  std::atomic<int> state = Free;
  pid_t group = 0;  ///< 0: a file
  std::array<char, PATH_MAX> path{};
};
std::array<Slot, 16> slots;  // more unfinished things at once than the program ever has; others go unnoticed

/// Takes a free slot and lets `fill` write into it; -1 where there is none.
template <class Fill>
int takeSlot(const Fill& fill) {
  prepareForSuddenEnd();
  for (std::size_t k = 0; k < slots.size(); ++k) {
    int expected = Slot::Free;
    if (!slots.at(k).state.compare_exchange_strong(expected, Slot::BeingFilled)) continue;
    fill(slots.at(k));
    slots.at(k).state = Slot::Filled;
    return static_cast<int>(k);
  }
  return -1;
}

/// Programs first: one that still runs could make its file again.
void clearUnfinished() {
  for (const bool programs : {true, false}) {
    for (Slot& slot : slots) {
      if (slot.state != Slot::Filled || (slot.group != 0) != programs) continue;
      programs ? ::kill(-slot.group, SIGKILL) : ::unlink(slot.path.data());
    }
  }
}

std::function<void()> atExit;  // one at a time

extern "C" void onExit() {
  if (!atExit) return clearUnfinished();
  std::exchange(atExit, nullptr)();
  clearUnfinished();
  (void)std::fflush(nullptr);
  _exit(EXIT_FAILURE);
}

bool prepare() {
  for (const int signal : kDeadly) {
    struct sigaction now {};
    if (sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_DFL) (void)std::signal(signal, endBySignal);
  }
  (void)std::signal(SIGXFSZ, SIG_IGN);
  return std::atexit(onExit) == 0;
}

}  // namespace

void prepareForSuddenEnd() { [[maybe_unused]] static const bool prepared = prepare(); }

void ignoreClosedPipes() { (void)std::signal(SIGPIPE, SIG_IGN); }

void endBySignal(int signal) {
  clearUnfinished();
  (void)std::signal(signal, SIG_DFL);
  (void)std::raise(signal);  // it acts when the handler returns
}

Unfinished::Unfinished(const std::filesystem::path& file)
    : slot_(takeSlot([&](Slot& slot) {
        slot.group = 0;
        std::strncpy(slot.path.data(), file.c_str(), slot.path.size() - 1);  // a longer one could not be opened
      })) {}

Unfinished::Unfinished(ProcessGroup group) : slot_(takeSlot([&](Slot& slot) { slot.group = group.number; })) {}

Unfinished::~Unfinished() {
  if (slot_ >= 0) slots.at(static_cast<std::size_t>(slot_)).state = Slot::Free;
}

AtExit::AtExit(std::function<void()> work) {
  prepareForSuddenEnd();
  atExit = std::move(work);
}

AtExit::~AtExit() { atExit = nullptr; }

}  // namespace tyg
