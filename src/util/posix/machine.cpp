// The processor's name, as Linux tells it.
#include "util/machine.h"

#include <fstream>
#include <thread>

#include <fmt/core.h>

namespace tyg {

std::string machineName() {
  std::string name = "unknown processor";
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) {
      name = line.substr(colon + 2);
      break;
    }
  }
  const unsigned cores = std::thread::hardware_concurrency();
  return cores == 0 ? name : fmt::format("{} ({} core{})", name, cores, cores == 1 ? "" : "s");
}

}  // namespace tyg
