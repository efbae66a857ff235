// Lines for people are put together from parts, each of which says one thing of the advice.
#include "app/reports/advice_report.h"

#include <cmath>
#include <limits>

#include <fmt/core.h>

#include "app/reports/json.h"
#include "tyg/methods.h"
#include "tyg/sheet.h"
#include "util/amounts.h"
#include "util/visible_text.h"
#include "util/wrapped.h"

namespace tyg {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

std::string requestText(const Request& request) {
  return request.error > 0 ? "an error of at most " + lengthText(request.error)
                           : "at most " + timeText(request.budget) + " of computing a frame";
}

std::string settingText(const Scene& scene) {
  const bool adaptive = findMethod(scene.integrator).adaptive;
  return fmt::format("{}, {}, {}", scene.integrator,
                     adaptive ? "tolerance " + lengthText(scene.tolerance) : "steps of " + timeText(scene.dt),
                     nameOf(scene.precision));
}

std::string optionsText(const Trial& choice, int threads) {
  const Scene& scene = choice.scene;
  const bool adaptive = findMethod(scene.integrator).adaptive;
  return fmt::format("--integrator {} {} {:.4g} --precision {} --threads {}{}", scene.integrator,
                     adaptive ? "--tolerance" : "--dt", adaptive ? scene.tolerance : scene.dt, nameOf(scene.precision),
                     threads, choice.device ? " --device gpu" : "");
}

std::string placeText(const Trial& choice, int threads) {
  return choice.device ? "the graphics card" : fmt::format("{} thread{}", threads, threads == 1 ? "" : "s");
}

/// Which of the two is faster, where there are two.
std::string deviceText(const Trial& choice, const DeviceReport& card) {
  if (card.device == "cpu") return "";
  const std::string name = "graphics card " + oneLine(card.name);
  const std::string times = fmt::format("{:.2g} times as long", choice.elsewhere / choice.seconds);
  const std::string said = choice.device                     ? name + ": the processor takes " + times
                           : std::isfinite(choice.elsewhere) ? "processor: the " + name + " takes " + times
                                                             : "processor: the " + name + " does not take this setting";
  constexpr int kColumns = 66;
  return "device        " + paragraph(said, std::string(14, ' '), kColumns);
}

std::string perFrame(double seconds, double duration) { return timeText(frameSeconds(seconds, duration)); }

std::string marginText(const Advice& advice) {
  const Scene& scene = advice.promise->scene;
  if (findMethod(scene.integrator).adaptive) return "the method chooses its own steps";
  if (std::isnan(advice.limit)) return "this method has no limit here";
  if (advice.limit == 0) return "no step is stable; the run ends before that shows";
  return fmt::format("the step is at {:.0f} % of its limit at rest, {}", 100 * scene.dt / advice.limit,
                     timeText(advice.limit));
}

std::string achievedText(const Advice& advice) {
  return advice.beyondReference() ? "< " + lengthText(advice.achieved + advice.uncertainty)
                                  : lengthText(advice.achieved);
}

/// Whether the promise holds, and how far that can be known.
std::string verdictText(const Scene& scene, const Advice& advice) {
  std::string text;
  if (advice.secondTry) {
    text += "The first choice missed: its error was " + lengthText(advice.missed) + ". This is the second choice.\n";
  }
  const bool overBudget =
      advice.request.error <= 0 && frameSeconds(advice.measured, scene.duration) > advice.request.budget;
  if (advice.met && advice.held && overBudget) {
    text +=
        "By the measured price of a step the promise holds; by the clock it did not:\n"
        "the machine was probably busier now than when that price was measured.\n";
  } else if (advice.met) {
    text += advice.held ? "The promise holds.\n" : "The promise does NOT hold.\n";
  }
  constexpr double kMuchMore = 1.5;
  if (advice.request.error > 0 && advice.measured > kMuchMore * advice.promise->seconds) {
    text +=
        "It is one of the error alone. The cost came out higher: the machine was\n"
        "probably busier now than when the price of a step was measured.\n";
  }
  if (advice.beyondReference()) {
    text +=
        "The error cannot be known better: the two exact methods differ by " + lengthText(advice.uncertainty) + ".\n";
  } else if (advice.floor > advice.achieved / 10) {
    text += "The error is known only to within " + lengthText(advice.floor) +
            ": rounding errors may be as large as that.\n";
  }
  return text;
}

std::string proofText(const Scene& scene, const Advice& advice) {
  if (!advice.proven) return "proof         none: two exact methods do not agree on this scene's motion\n";
  const bool byError = advice.request.error > 0;
  const auto line = [](const char* what, const std::string& promised, const std::string& achieved, const char* how) {
    return fmt::format("{:<13} {:>12}  {:>12}{}\n", what, promised, achieved, how);
  };
  return line("", "promised", "achieved", "") +
         line("error", lengthText(byError && advice.met ? advice.request.error : advice.promise->error),
              achievedText(advice), "   against the reference") +
         line("cost", perFrame(advice.promise->seconds, scene.duration), perFrame(advice.measured, scene.duration),
              "   by the clock, a frame of 1/60 s") +
         verdictText(scene, advice);
}

std::string timesAsMuch(double seconds, const Advice& advice) {
  return fmt::format("{:.2g} times as much", seconds / advice.promise->seconds);
}

std::string tenTimesText(const Scene& scene, const Advice& advice) {
  if (const std::optional<Trial>& better = advice.tenTimesBetter) {
    if (better->scene == advice.promise->scene) return "this choice is already that good";
    return fmt::format("{} a frame, {}, by\n              {}", perFrame(better->seconds, scene.duration),
                       timesAsMuch(better->seconds, advice), settingText(better->scene));
  }
  if (!advice.met) return "not searched for, because this request cannot be met";
  if (advice.tenTimesUpTo == 0)
    return "not searched for: the exact motion is known only to " + lengthText(advice.knowable);
  return fmt::format("not found up to {} a frame, {};\n              {}", perFrame(advice.tenTimesUpTo, scene.duration),
                     timesAsMuch(advice.tenTimesUpTo, advice),
                     advice.tenTimesGaveUp ? "the search took too long" : "the search ended there");
}

}  // namespace

std::string adviceText(const Scene& scene, const Advice& advice, const DeviceReport& card) {
  std::string text = fmt::format("{}: {} x {} particles, {:.4g} s\nasked for     {}\n\n", oneLine(scene.title),
                                 scene.columns, scene.rows, scene.duration, requestText(advice.request));
  if (!advice.promise) {
    return text + (advice.runs > 0 ? "Every run of the study failed, so nothing can be advised.\n"
                                   : "None of the allowed methods takes this scene and may be advised.\n");
  }
  if (!advice.met) text += "This request cannot be met. The nearest choice that was found:\n";
  text += fmt::format("use           {}, {}\n", settingText(advice.promise->scene),
                      placeText(*advice.promise, advice.threads));
  text += proofText(scene, advice);
  text += "\n" + deviceText(*advice.promise, card) + "stability     " + marginText(advice) + "\n";
  text += "ten times\nbetter        " + tenTimesText(scene, advice) + "\n";
  text += "\n" + optionsText(*advice.promise, advice.threads) + "\n";
  return text;
}

std::string adviceJson(const Scene& scene, const Advice& advice, const DeviceReport& card) {
  Json json{
      {"scene", scene.name},
      {"size_m", makeSheet(scene).size()},
      {"asked_error_m", advice.request.error > 0 ? advice.request.error : kUnknown},
      {"asked_frame_s", advice.request.budget > 0 ? advice.request.budget : kUnknown},
      {"met", advice.met},
      {"held", advice.held},
      {"proven", advice.proven},
      {"second_try", advice.secondTry},
      {"runs", advice.runs},
      {"threads", advice.threads},
      {"device", advice.promise && advice.promise->device ? "gpu" : "cpu"},
      {"device_name", card.name},
  };
  if (!advice.promise) return jsonText(json);
  const Trial& promise = *advice.promise;
  const bool adaptive = findMethod(promise.scene.integrator).adaptive;
  json.update({
      {"integrator", promise.scene.integrator},
      {"precision", nameOf(promise.scene.precision)},
      {"dt", adaptive ? kUnknown : promise.scene.dt},
      {"tolerance", adaptive ? promise.scene.tolerance : kUnknown},
      {"work", promise.work},
      {"promised_error_m", promise.error},
      {"achieved_error_m", advice.achieved},
      {"reference_uncertainty_m", advice.uncertainty},
      {"floor_m", advice.floor},
      {"promised_frame_s", frameSeconds(promise.seconds, scene.duration)},
      {"measured_frame_s", frameSeconds(advice.measured, scene.duration)},
      {"other_device_frame_s", frameSeconds(promise.elsewhere, scene.duration)},
      {"stable_dt", advice.limit},
      {"knowable_error_m", advice.knowable},
      {"ten_times_better_searched_up_to_frame_s", frameSeconds(advice.tenTimesUpTo, scene.duration)},
      {"ten_times_better_frame_s",
       advice.tenTimesBetter ? frameSeconds(advice.tenTimesBetter->seconds, scene.duration) : kUnknown},
  });
  return jsonText(json);
}

std::string adviceComment(const Scene& scene, const Advice& advice) {
  return fmt::format("Made by `tyg advise {}` for {}:\n{}{} achieved {}, {} a frame.", scene.name,
                     requestText(advice.request), settingText(advice.promise->scene),
                     advice.promise->device ? ", the graphics card" : "", lengthText(advice.achieved),
                     perFrame(advice.measured, scene.duration));
}

}  // namespace tyg
