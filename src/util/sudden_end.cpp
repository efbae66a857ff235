// A handler of signals may neither allocate nor lock: what is unfinished is kept in a table of fixed size.
#include "util/sudden_end.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "util/sudden_end_system.h"

namespace tyg {
namespace {

struct Slot {
  enum State : int { Free, BeingFilled, Filled };
  std::atomic<int> state = Free;
  ProcessGroup group;  ///< number 0: a file
  std::array<std::filesystem::path::value_type, 4096> path{};
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

std::function<void()> atExit;  // one at a time

extern "C" void onExit() {
  if (!atExit) return clearUnfinished();
  std::exchange(atExit, nullptr)();
  clearUnfinished();
  (void)std::fflush(nullptr);
  std::_Exit(EXIT_FAILURE);
}

bool prepare() {
  catchSuddenEnds();
  return std::atexit(onExit) == 0;
}

}  // namespace

/// Programs first: one that still runs could make its file again.
void clearUnfinished() {
  for (const bool programs : {true, false}) {
    for (const Slot& slot : slots) {
      if (slot.state != Slot::Filled || (slot.group.number != 0) != programs) continue;
      programs ? endPrograms(slot.group) : removeFile(slot.path.data());
    }
  }
}

void prepareForSuddenEnd() { [[maybe_unused]] static const bool prepared = prepare(); }

void endBySignal(int signal) {
  clearUnfinished();
  (void)std::signal(signal, SIG_DFL);
  (void)std::raise(signal);  // it acts when the handler returns
}

Unfinished::Unfinished(const std::filesystem::path& file)
    : slot_(takeSlot([&](Slot& slot) {
        slot.group = {};
        const std::size_t length =
            std::min(file.native().size(), slot.path.size() - 1);  // a longer one could not be opened
        *std::copy_n(file.c_str(), length, slot.path.begin()) = 0;
      })) {}

Unfinished::Unfinished(ProcessGroup group) : slot_(takeSlot([&](Slot& slot) { slot.group = group; })) {}

Unfinished::~Unfinished() {
  if (slot_ >= 0) slots.at(static_cast<std::size_t>(slot_)).state = Slot::Free;
}

AtExit::AtExit(std::function<void()> work) {
  prepareForSuddenEnd();
  atExit = std::move(work);
}

AtExit::~AtExit() { atExit = nullptr; }

}  // namespace tyg
