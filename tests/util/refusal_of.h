// What a place for a file is refused with, for tests of whole files.
#pragma once

#include <filesystem>
#include <string>

#include "tyg/input_error.h"
#include "util/whole_file.h"

namespace tyg::test {

inline std::string refusalOf(const std::filesystem::path& path) {
  try {
    checkWritable(path);
  } catch (const InputError& mistake) {
    return mistake.what();
  }
  return "nothing was refused";
}

}  // namespace tyg::test
