// Windows sleeps on any address, and may wake a thread for no reason.
#include "util/sleeping.h"

#include <windows.h>

namespace tyg {

static_assert(sizeof(std::atomic<unsigned>) == sizeof(unsigned) && std::atomic<unsigned>::is_always_lock_free);

void sleepWhile(const std::atomic<unsigned>& number, unsigned old) {
  auto* address = const_cast<std::atomic<unsigned>*>(&number);
  while (number.load(std::memory_order_acquire) == old) WaitOnAddress(address, &old, sizeof old, INFINITE);
}

void wakeSleepers(std::atomic<unsigned>& number) { WakeByAddressAll(&number); }

}  // namespace tyg
