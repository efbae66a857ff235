// Linux gives each thread its own nice value, and takes a thread's number where other systems take a process's.
#include "util/thread_priority.h"

#include <sys/resource.h>
#include <unistd.h>

namespace tyg {

int lowerThreadPriority() {
  constexpr int kLowestPriority = 19;
  const auto thread = static_cast<id_t>(gettid());
  setpriority(PRIO_PROCESS, thread, kLowestPriority);
  return getpriority(PRIO_PROCESS, thread);
}

}  // namespace tyg
