// The one function of a fuzz target, called by libFuzzer or by replay.cpp.
// Must not know: which target it is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

/// Feeds one input to the code under test; what is wrong with it shows as a crash, a failed check or a run without end.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

inline std::string_view textOf(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}
