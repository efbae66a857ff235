// Fuzz target: the rows of a study, as CSV. What reads must write and read back to the same text.
// Must not know: how rows come about.
#include <cstdlib>

#include "fuzz.h"
#include "study/work/work_rows.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const std::string csv = tyg::workCsv(tyg::parseWorkCsv(textOf(data, size), "fuzz"));
    if (csv.find('"') != std::string::npos) return 0;  // a quoted field may hold a line break, which rows do not read
    if (tyg::workCsv(tyg::parseWorkCsv(csv, "fuzz")) != csv) std::abort();
  } catch (const tyg::InputError&) {
  }
  return 0;
}
