// The limit at rest is worked out where the method or the springs change, the live one measured now and then.
#include "viewer/margin.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/simulation/live_parameters.h"
#include "study/limits/stability.h"
#include "tyg/methods.h"

namespace tyg {
namespace {

constexpr double kMostShare = 0.05;  // of the time, for the live limit
constexpr double kOnDevice = 0.5;    // s at least from one to the next, where a device has to give the state for it
constexpr double kStretched = 0.99;  // of the limit at rest: below that the cloth's stretch is told

/// A scene whose limit at rest is that of a sheet which has lost springs, wherever that was.
Scene withCuts(Scene scene) {
  if (scene.cuts.empty()) scene.cuts.push_back({.line = {-1, 0.5, double(scene.columns), 0.5}, .at = 0});
  return scene;
}

}  // namespace

MarginBand Margin::band() const {
  if (adaptive || !std::isfinite(limit)) return MarginBand::None;
  if (share() < kClose) return MarginBand::Fine;
  return share() < 1 ? MarginBand::Close : MarginBand::Past;
}

void describe(const Margin& margin, MarginText& text) {
  const auto say = [&text]<class... Values>(fmt::format_string<Values...> format, Values&&... values) {
    *fmt::format_to_n(text.data(), text.size() - 1, format, std::forward<Values>(values)...).out = '\0';
  };
  if (margin.adaptive && !std::isfinite(margin.limit)) return say("chooses its own steps");
  // Measured: 0.5 to 1.8 % above the limit of fixed steps, wherever the tolerance holds.
  if (margin.adaptive) return say("chooses its own steps: on average about {:.3g} ms at most", 1e3 * margin.limit);
  if (!std::isfinite(margin.limit)) return say("stable at any step");
  if (margin.limit == 0) return say("stable at no step: it needs damping");
  std::array<char, 32> rest{};
  if (margin.limit < kStretched * margin.rest) {
    fmt::format_to_n(rest.data(), rest.size() - 1, ", at rest {:.3g} ms", 1e3 * margin.rest);
  }
  if (margin.band() == MarginBand::Past) {
    return say("{:.3g} times the largest stable step ({:.3g} ms{}): unstable", margin.share(), 1e3 * margin.limit,
               rest.data());
  }
  say("step is {:.0f} % of the largest stable one ({:.3g} ms{}){}", 100 * margin.share(), 1e3 * margin.limit,
      rest.data(), margin.band() == MarginBand::Close ? ": close to unstable" : "");
}

void MarginWatch::follow(const Scene& scene, const Method& method, double step, bool isCut) {
  if (method_ != &method || isCut != isCut_ || !sameLiveParameters(scene_, scene)) {
    method_ = &method;
    scene_ = scene;
    isCut_ = isCut;
    measuredAt_ = -1;
    live_ = std::numeric_limits<double>::quiet_NaN();
    margin_ = {.rest = restLatticeLimit(isCut ? withCuts(scene) : scene, method)};
  }
  margin_.step = step;
  margin_.adaptive = method.adaptive && scene.tolerance > 0;
  margin_.limit = std::fmin(margin_.rest, live_);  // of a number and NaN, the number
}

void MarginWatch::preview(const Scene& chosen) { follow(chosen, findMethod(chosen.integrator), chosen.dt, isCut_); }

void MarginWatch::keep(const Simulation& simulation) {
  follow(simulation.scene(), simulation.method(), simulation.dt(), !simulation.sheet().missing.none());
}

void MarginWatch::update(Simulation& simulation, const Clock& clock) {
  keep(simulation);
  const bool moves = simulation.status() == Status::Ok && simulation.ticks() != measuredAt_;
  if (moves) measureLive(simulation, clock);
}

void MarginWatch::measure(Simulation& simulation) {
  if (margin_.adaptive) return;
  live_ = simulation.liveStableStep();
  measuredAt_ = simulation.ticks();
  margin_.limit = std::fmin(margin_.rest, live_);
}

void MarginWatch::measureLive(Simulation& simulation, const Clock& clock) {
  const double began = clock();
  if (measuredAt_ >= 0 && began < nextMeasured_) return;
  measure(simulation);
  nextMeasured_ = began + std::max((clock() - began) / kMostShare, simulation.onDevice() ? kOnDevice : 0);
}

}  // namespace tyg
