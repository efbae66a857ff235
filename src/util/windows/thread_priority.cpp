// Windows counts otherwise; its lowest priority is told as the lowest nice value.
#include "util/thread_priority.h"

#include <windows.h>

namespace tyg {

int lowerThreadPriority() {
  constexpr int kLowestPriority = 19;
  return SetThreadPriority(GetCurrentThread(), THREAD_PRIORITY_LOWEST) != 0 ? kLowestPriority : 0;
}

}  // namespace tyg
