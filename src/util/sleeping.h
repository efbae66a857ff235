// Threads that sleep until another one changes a number. std::atomic::wait() does it on Linux; without the system's own
// means, GCC's library may let a thread sleep for ever, which is woken between its last look and its sleep.
#pragma once

#include <atomic>

namespace tyg {

/// Returns once `number` differs from `old`; whoever changes it has to call wakeSleepers().
void sleepWhile(const std::atomic<unsigned>& number, unsigned old);

void wakeSleepers(std::atomic<unsigned>& number);

}  // namespace tyg
