// Windows tells of Ctrl-C and of a closed console in a thread of its own, and of faults by a filter. Programs that this
// one has started end with it in any case (child_process.cpp here).
#include "util/sudden_end.h"

#include <windows.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cwchar>
#include <utility>

namespace tyg {
namespace {

struct Slot {
  enum State : int { Free, BeingFilled, Filled };
  std::atomic<int> state = Free;
  std::array<wchar_t, MAX_PATH + 1> path{};
};
std::array<Slot, 16> slots;  // more unfinished things at once than the program ever has; others go unnoticed

void clearUnfinished() {
  for (Slot& slot : slots) {
    if (slot.state == Slot::Filled) DeleteFileW(slot.path.data());
  }
}

std::function<void()> atExit;  // one at a time

extern "C" void onExit() {
  if (!atExit) return clearUnfinished();
  std::exchange(atExit, nullptr)();
  clearUnfinished();
  (void)std::fflush(nullptr);
  std::_Exit(EXIT_FAILURE);
}

LONG WINAPI onFault(EXCEPTION_POINTERS* /*what*/) {
  clearUnfinished();
  return EXCEPTION_CONTINUE_SEARCH;
}

BOOL WINAPI onConsole(DWORD /*event*/) {
  clearUnfinished();
  return FALSE;  // the system ends the process
}

bool prepare() {
  SetUnhandledExceptionFilter(onFault);
  for (const int signal : {SIGABRT, SIGTERM}) (void)std::signal(signal, endBySignal);
  return SetConsoleCtrlHandler(onConsole, TRUE) != 0 && std::atexit(onExit) == 0;
}

}  // namespace

void prepareForSuddenEnd() { [[maybe_unused]] static const bool prepared = prepare(); }

void ignoreClosedPipes() {}  // writing to one fails here, and is no signal

void endBySignal(int signal) {
  clearUnfinished();
  (void)std::signal(signal, SIG_DFL);
  (void)std::raise(signal);
}

Unfinished::Unfinished(const std::filesystem::path& file) {
  prepareForSuddenEnd();
  for (std::size_t k = 0; k < slots.size(); ++k) {
    int expected = Slot::Free;
    if (!slots[k].state.compare_exchange_strong(expected, Slot::BeingFilled)) continue;
    std::wcsncpy(slots[k].path.data(), std::filesystem::absolute(file).c_str(), MAX_PATH);
    slots[k].state = Slot::Filled;
    slot_ = static_cast<int>(k);
    return;
  }
}

Unfinished::~Unfinished() {
  if (slot_ >= 0) slots.at(static_cast<std::size_t>(slot_)).state = Slot::Free;
}

AtExit::AtExit(std::function<void()> work) {
  prepareForSuddenEnd();
  atExit = std::move(work);
}

AtExit::~AtExit() { atExit = nullptr; }

}  // namespace tyg
