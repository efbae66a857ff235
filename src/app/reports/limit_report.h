// What `tyg limit` says about step limits: a table with sentences for people, a JSON object for scripts.
// Must not know: options.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/limits/holding_changes.h"
#include "study/limits/stability.h"

namespace tyg {

/// The limits of one method on a sheet.
struct LimitOfMethod {
  const Method* method = nullptr;
  StepLimit limit;
  std::vector<std::string> springs;       ///< the families that set it
  bool holds = true;                      ///< the step asked about, if any
  std::optional<HoldingChanges> changes;  ///< where it does not
};

struct LimitReport {
  Scene scene;
  std::optional<double> dt;  ///< s, the step asked about
  std::vector<LimitOfMethod> methods;

  [[nodiscard]] bool holds() const;
};
/// Works the limit of a method out, and asks it about a step (s), if any.
LimitOfMethod limitOf(const Scene& scene, const Method& method, std::optional<double> dt);

std::string limitTable(const LimitReport& report);
/// One JSON object; its keys and their order are what scripts rely on.
std::string limitJson(const LimitReport& report);

}  // namespace tyg
