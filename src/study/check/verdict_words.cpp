// The sentence: what the motion is, how near, and what to do about it.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "study/check/motion_check.h"
#include "util/amounts.h"

namespace tyg {
namespace {

using Verdict = MotionCheck::Verdict;

constexpr std::string_view kReportsName = "the report's Runge-Kutta";
constexpr std::string_view kReportsCure =
    "Move positions and velocities together to each of the four stages, and work the forces out there.";

bool isReports(const Explanation& of) { return of.way.name() == "report-rk4" && of.model.made.empty(); }

constexpr double kExploded = 10;  // sheet sizes of error: no cloth that holds together is so far away

/// A small distance, which lengthText() would round away.
std::string metres(double distance) {
  if (std::isinf(distance)) return "infinitely far";
  return distance >= 1 ? lengthText(distance) : fmt::format("{:.2g} m", distance);
}

std::string methodWords(const Explanation& of) {
  std::string name(of.way.student != nullptr ? of.way.student->label : of.way.method->label);
  for (const StudentMethod& method : studentMethods()) {
    if (method.name == of.way.name()) name = method.label;
  }
  return of.dt > 0 ? fmt::format("{} at {}", name, timeText(of.dt)) : name + " with steps of its own choice";
}

std::string withWords(const Model& model) {
  std::string text;
  for (const Mistake* mistake : model.made) text += (text.empty() ? " " : " and ") + std::string(mistake->with);
  return text;
}

std::string agreement(const Explanation& of, const MotionCheck& check) {
  std::string text = "they agree to " + metres(of.distance);
  if (of.judgedUpTo < check.scene.duration * (1 - 1e-9)) {
    text += fmt::format(" up to {}, after which rounding errors have grown too large to tell", timeText(of.judgedUpTo));
  }
  return text;
}

/// Where the step is too long, that is what has to be changed.
std::string stepWords(const MotionCheck& check, std::string_view subject) {
  if (!check.stepIsTooLong()) return "";
  return fmt::format(" {} step is longer than {}, the largest stable one: take a shorter step.", subject,
                     timeText(check.limit));
}

std::string mistakenWords(const MotionCheck& check) {
  const Explanation& of = *check.mistaken;
  std::string text =
      fmt::format("Your positions are those of {}{}: {}.", methodWords(of), withWords(of.model), agreement(of, check));
  if (isReports(of)) return text.append(" ").append(kReportsCure);
  for (const Mistake* mistake : of.model.made) text.append(" ").append(mistake->cure);
  return text + stepWords(check, "The");
}

std::string rightWords(const MotionCheck& check) {
  const Explanation& of = *check.right;
  const std::string own = of.way.known() ? "" : ", a right method that is not one of ours";
  const std::string positions =
      fmt::format("our positions are those of {}{}: {}.", methodWords(of), own, agreement(of, check));
  if (check.truthIsAsNear()) {
    return fmt::format(
        "Right: your positions are {} from the truth. That is as near as they are to any method of ours, so "
        "that the file does not tell which method made them.",
        metres(check.error));
  }
  if (check.stepIsTooLong()) return "Y" + positions + stepWords(check, "The program is right, but its");
  return fmt::format("Right: y{} They are {} from the truth.", positions, metres(check.error));
}

}  // namespace

std::string mistakeName(const MotionCheck& check) {
  if (!check.mistaken) return "";
  return isReports(*check.mistaken) ? std::string(kReportsName) : check.mistaken->model.names();
}

std::string verdictWords(const MotionCheck& check) {
  switch (check.verdict) {
    case Verdict::Mistaken:
      return mistakenWords(check);
    case Verdict::Right:
      return rightWords(check);
    case Verdict::OtherMethod:
      return fmt::format(
          "Your positions are within {} of the truth, {:.2g} % of the sheet's size, which is good enough; but no "
          "method of "
          "ours and no common mistake gives them. A method that is not one of ours does that, and so does a small "
          "mistake.",
          metres(check.error), 100 * check.error / check.size);
    case Verdict::Unexplained:
      break;
  }
  if (!(check.error < kExploded * check.size)) {
    return "Your cloth has exploded: its positions are " + metres(check.error) +
           " from the truth. Try half the step. If the cloth then stays whole, the step was too long; if not, "
           "something "
           "in the model is wrong. A file with a row for every step until then is enough to tell which.";
  }
  return fmt::format(
      "Your positions are {} from the truth, and neither a method of ours nor a common mistake gives "
      "them. Halve your step: if the error falls to half or less, the program is right and its step too "
      "long; if it stays, something in the model is wrong.",
      metres(check.error));
}

}  // namespace tyg
