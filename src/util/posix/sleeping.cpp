// The C++ library asks Linux itself.
#include "util/sleeping.h"

namespace tyg {

void sleepWhile(const std::atomic<unsigned>& number, unsigned old) { number.wait(old, std::memory_order_acquire); }

void wakeSleepers(std::atomic<unsigned>& number) { number.notify_all(); }

}  // namespace tyg
