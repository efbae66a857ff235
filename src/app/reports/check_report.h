// What `tyg check` says about a motion: a table with a sentence for people, a JSON object for scripts, rows for a
// chart. Must not know: options, files.
#pragma once

#include <optional>
#include <string>

#include "study/check/motion_check.h"

namespace tyg {

struct CheckReport {
  MotionCheck check;
  GivenMotion motion;
  std::optional<double> within;  ///< m, the largest error allowed, where one was asked for

  [[nodiscard]] bool passes() const { return !within || check.error <= *within; }
};

std::string checkTable(const CheckReport& report);
/// One JSON object; its keys and their order are what scripts rely on.
std::string checkJson(const CheckReport& report);
/// t,error_m,explained_m,floor_m: the error, how far the explanation is, and the sheet's floor, at each time.
std::string checkCsv(const CheckReport& report);

}  // namespace tyg
