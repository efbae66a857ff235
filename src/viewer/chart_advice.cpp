// Numbers keep three digits; an error between two measured ones is said to be about so much.
#include "viewer/chart_advice.h"

#include <fmt/core.h>

#include "tyg/methods.h"

namespace tyg {
namespace {

/// `1.4 times`, `23 times`, `over 10000 times`.
std::string timesText(double ratio) {
  constexpr double kMost = 1e4;
  return ratio > kMost ? fmt::format("over {:.0f} times", kMost)
                       : fmt::format("{:.{}f} times", ratio, ratio < 10 ? 1 : 0);
}

std::string named(const Setting& setting) { return std::string(setting.method->name) + ", " + textOf(setting); }

std::string presentSentence(const SettingEstimate& estimate, const Setting& setting, const ChartScale& scale,
                            bool finished) {
  switch (estimate.kind) {
    case SettingEstimate::Kind::Unknown:
      return named(setting) + (finished ? ": takes too long to be measured here." : ": not measured yet.");
    case SettingEstimate::Kind::Fails:
      return named(setting) + ": unstable in this scene.";
    default:
      break;
  }
  const bool measured = estimate.kind == SettingEstimate::Kind::Measured;
  return named(setting) + (measured ? ": error " : ": error about ") + errorText(estimate.error, scale) + " for " +
         costText(estimate.seconds, scale) + ".";
}

}  // namespace

std::string textOf(const Setting& setting) {
  return setting.method->adaptive ? fmt::format("tolerance {:.3g} mm", 1e3 * setting.tolerance)
                                  : fmt::format("step {:.3g} ms", 1e3 * setting.dt);
}

Setting settingOf(const WorkRow& row) { return {&findMethod(row.integrator), row.dt, row.tolerance, WorkRow::kNone}; }

std::string errorText(double error, const ChartScale& scale) {
  return fmt::format("{:.3g} mm ({:.1e} of the size)", 1e3 * error, error / scale.size);
}

std::string costText(double seconds, const ChartScale& scale) {
  return fmt::format("{:.3g} ms per simulated second", scale.cost(seconds));
}

ChartAdvice adviceOn(const std::vector<WorkRow>& rows, const Setting& present, const ChartScale& scale, bool finished) {
  const SettingEstimate estimate = estimateOf(rows, present);
  ChartAdvice advice{.present = presentSentence(estimate, present, scale, finished), .better = {}};
  const BetterRows better = betterThan(rows, estimate);
  if (better.cheaper != nullptr) {
    advice.better +=
        "Faster and at least as accurate: " + named(settingOf(*better.cheaper)) +
        fmt::format(", at {:.3g} ms of computing per simulated second, ", scale.cost(better.cheaper->seconds)) +
        timesText(estimate.seconds / better.cheaper->seconds) + " faster. ";
  }
  if (better.closer != nullptr) {
    advice.better += "More accurate at no greater cost: " + named(settingOf(*better.closer)) +
                     fmt::format(", error {:.3g} mm, ", 1e3 * better.closer->rmsError) +
                     timesText(estimate.error / better.closer->rmsError) + " smaller.";
  }
  return advice;
}

}  // namespace tyg
