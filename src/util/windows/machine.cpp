// The processor's name, as the registry tells it.
#include "util/machine.h"

#include <windows.h>

#include <array>
#include <thread>

#include <fmt/core.h>

#include "util/windows/wide.h"

namespace tyg {

std::string machineName() {
  std::array<wchar_t, 256> text{};
  DWORD size = sizeof text;
  const LSTATUS found = RegGetValueW(HKEY_LOCAL_MACHINE, L"HARDWARE\\DESCRIPTION\\System\\CentralProcessor\\0",
                                     L"ProcessorNameString", RRF_RT_REG_SZ, nullptr, text.data(), &size);
  const std::string name = found == ERROR_SUCCESS ? narrow(text.data()) : "unknown processor";
  const unsigned cores = std::thread::hardware_concurrency();
  return cores == 0 ? name : fmt::format("{} ({} core{})", name, cores, cores == 1 ? "" : "s");
}

}  // namespace tyg
