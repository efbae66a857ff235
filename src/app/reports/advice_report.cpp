// Words and numbers of advice.
#include "app/reports/advice_report.h"

#include <cmath>

#include "app/reports/json.h"
#include "tyg/methods.h"
#include "tyg/sheet.h"
#include "util/amounts.h"
#include "util/text.h"

namespace tyg {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

std::string requestText(const Request& request) {
  return request.error > 0 ? "an error of at most " + lengthText(request.error)
                           : "at most " + timeText(request.budget) + " of computing a frame";
}

std::string settingText(const Scene& scene) {
  const bool adaptive = findMethod(scene.integrator).adaptive;
  return scene.integrator +
         (adaptive ? ", tolerance " + lengthText(scene.tolerance) : ", steps of " + timeText(scene.dt)) + ", " +
         nameOf(scene.precision);
}

std::string optionsText(const Scene& scene, int threads) {
  const bool adaptive = findMethod(scene.integrator).adaptive;
  return "--integrator " + scene.integrator +
         (adaptive ? formatted(" --tolerance %.4g", scene.tolerance) : formatted(" --dt %.4g", scene.dt)) +
         " --precision " + nameOf(scene.precision) + formatted(" --threads %d", threads);
}

std::string perFrame(double seconds, double duration) { return timeText(frameSeconds(seconds, duration)); }

std::string marginText(const Advice& advice) {
  const Scene& scene = advice.promise->scene;
  if (findMethod(scene.integrator).adaptive) return "the method chooses its own steps";
  if (std::isnan(advice.limit)) return "this method has no limit here";
  if (advice.limit == 0) return "no step is stable; it only survives the run";
  return formatted("the step is at %.0f %% of its limit at rest, ", 100 * scene.dt / advice.limit) +
         timeText(advice.limit);
}

std::string achievedText(const Advice& advice) {
  return advice.beyondReference() ? "< " + lengthText(advice.achieved + advice.uncertainty)
                                  : lengthText(advice.achieved);
}

std::string proofText(const Scene& scene, const Advice& advice) {
  if (!advice.proven) return "proof         none: two exact methods do not agree on this scene's motion\n";
  const bool byError = advice.request.error > 0;
  std::string text = formatted("%-13s %12s  %12s\n", "", "promised", "achieved");
  text +=
      formatted("%-13s %12s  %12s   against the reference\n", "error",
                (byError && advice.met ? lengthText(advice.request.error) : lengthText(advice.promise->error)).c_str(),
                achievedText(advice).c_str());
  text += formatted("%-13s %12s  %12s   by the clock, a frame of 1/60 s\n", "cost",
                    perFrame(advice.promise->seconds, scene.duration).c_str(),
                    perFrame(advice.measured, scene.duration).c_str());
  if (advice.secondTry)
    text += "The first choice missed by the proof, with " + lengthText(advice.missed) + "; this is the second.\n";
  const bool dearer = !byError && frameSeconds(advice.measured, scene.duration) > advice.request.budget;
  if (advice.met && advice.held && dearer) {
    text +=
        "By the prices of steps the promise holds; by the clock it did not just now,\n"
        "as on a machine that has more to do than when they were measured.\n";
  } else if (advice.met) {
    text += advice.held ? "The promise holds.\n" : "The promise does NOT hold.\n";
  }
  if (advice.beyondReference()) {
    text += "Nobody can tell more: the two exact methods are " + lengthText(advice.uncertainty) + " apart.\n";
  } else if (advice.floor > advice.achieved / 10) {
    text += "Beware: as this cloth amplifies them, rounding errors could become " + lengthText(advice.floor) + ".\n";
  }
  return text;
}

std::string timesAsMuch(double seconds, const Advice& advice) {
  return formatted("%.2g times as much", seconds / advice.promise->seconds);
}

std::string tenTimesText(const Scene& scene, const Advice& advice) {
  if (const std::optional<Trial>& better = advice.tenTimesBetter) {
    if (better->scene == advice.promise->scene) return "this choice already is";
    return perFrame(better->seconds, scene.duration) + " a frame, " + timesAsMuch(better->seconds, advice) +
           ", by\n              " + settingText(better->scene);
  }
  if (!advice.met) return "not searched for, since this much cannot be met";
  if (advice.tenTimesUpTo == 0)
    return "not searched for: the exact motion is known only to " + lengthText(advice.knowable);
  const std::string upTo =
      perFrame(advice.tenTimesUpTo, scene.duration) + " a frame, " + timesAsMuch(advice.tenTimesUpTo, advice);
  return "not found up to " + upTo +
         (advice.tenTimesGaveUp ? ";\n              the search took too long"
                                : ";\n              not searched further");
}

}  // namespace

std::string adviceText(const Scene& scene, const Advice& advice) {
  std::string text = scene.title +
                     formatted(": %d x %d particles, %.4g s\n", scene.columns, scene.rows, scene.duration) +
                     "asked for     " + requestText(advice.request) + "\n\n";
  if (!advice.promise) {
    return text + (advice.runs > 0 ? "Every run of the study failed: nothing can be advised.\n"
                                   : "None of the methods allowed takes this scene and may be advised.\n");
  }
  if (!advice.met) text += "This cannot be met. The nearest that was found:\n";
  text += "use           " + settingText(advice.promise->scene) +
          formatted(", %d thread%s\n", advice.threads, advice.threads == 1 ? "" : "s");
  text += proofText(scene, advice);
  text += "\nstability     " + marginText(advice) + "\n";
  text += "ten times\nbetter        " + tenTimesText(scene, advice) + "\n";
  text += "\n" + optionsText(advice.promise->scene, advice.threads) + "\n";
  return text;
}

std::string adviceJson(const Scene& scene, const Advice& advice) {
  const auto flag = [](bool value) { return value ? "true" : "false"; };
  JsonObject json;
  json.add("scene", scene.name);
  json.add("size_m", makeSheet(scene).size());
  json.add("asked_error_m", advice.request.error > 0 ? advice.request.error : kUnknown);
  json.add("asked_frame_s", advice.request.budget > 0 ? advice.request.budget : kUnknown);
  json.addRaw("met", flag(advice.met));
  json.addRaw("held", flag(advice.held));
  json.addRaw("proven", flag(advice.proven));
  json.addRaw("second_try", flag(advice.secondTry));
  json.add("runs", advice.runs);
  json.add("threads", advice.threads);
  if (!advice.promise) return json.text();
  const Trial& promise = *advice.promise;
  const bool adaptive = findMethod(promise.scene.integrator).adaptive;
  json.add("integrator", promise.scene.integrator);
  json.add("precision", nameOf(promise.scene.precision));
  json.add("dt", adaptive ? kUnknown : promise.scene.dt);
  json.add("tolerance", adaptive ? promise.scene.tolerance : kUnknown);
  json.add("work", promise.work);
  json.add("promised_error_m", promise.error);
  json.add("achieved_error_m", advice.achieved);
  json.add("reference_uncertainty_m", advice.uncertainty);
  json.add("floor_m", advice.floor);
  json.add("promised_frame_s", frameSeconds(promise.seconds, scene.duration));
  json.add("measured_frame_s", frameSeconds(advice.measured, scene.duration));
  json.add("stable_dt", advice.limit);
  json.add("knowable_error_m", advice.knowable);
  json.add("ten_times_better_searched_up_to_frame_s", frameSeconds(advice.tenTimesUpTo, scene.duration));
  json.add("ten_times_better_frame_s",
           advice.tenTimesBetter ? frameSeconds(advice.tenTimesBetter->seconds, scene.duration) : kUnknown);
  return json.text();
}

std::string adviceComment(const Scene& scene, const Advice& advice) {
  return "Made by `tyg advise " + scene.name + "` for " + requestText(advice.request) + ":\n" +
         settingText(advice.promise->scene) + " achieved " + lengthText(advice.achieved) + ", " +
         perFrame(advice.measured, scene.duration) + " a frame.";
}

}  // namespace tyg
