// See margin.h.
#include "viewer/margin.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/simulation/live_parameters.h"
#include "study/limits/stability.h"
#include "tyg/methods.h"

namespace tyg {
namespace {

constexpr double kMostShare = 0.05;  // of the time, for the live limit
constexpr double kStretched = 0.99;  // of the limit at rest: below that the cloth's stretch is told
constexpr double kSmoothing = 0.1;   // of the cost, from look to look

}  // namespace

MarginBand Margin::band() const {
  if (adaptive || !std::isfinite(limit)) return MarginBand::None;
  if (share() < kClose) return MarginBand::Fine;
  return share() < 1 ? MarginBand::Close : MarginBand::Past;
}

void describe(const Margin& margin, MarginText& text) {
  const auto say = [&text](const char* format, auto... values) {
    std::snprintf(text.data(), text.size(), format, values...);
  };
  if (margin.adaptive && !std::isfinite(margin.limit)) return say("%s", "chooses its own steps");
  // Measured: 0.5 to 1.8 % above the limit of fixed steps, wherever the tolerance holds.
  if (margin.adaptive) return say("chooses its own steps: on average about %.3g ms at most", 1e3 * margin.limit);
  if (!std::isfinite(margin.limit)) return say("%s", "no step is too large for it");
  if (margin.limit == 0) return say("%s", "no step holds: it needs damping");
  const bool stretched = margin.limit < kStretched * margin.rest;
  std::array<char, 32> rest{};
  if (stretched) std::snprintf(rest.data(), rest.size(), " (%.3g ms at rest)", 1e3 * margin.rest);
  constexpr std::array kWarnings{"", "", ": close, a little more breaks it", ": PAST IT, the cloth will break"};
  say("%.2f of the limit of %.3g ms%s%s", margin.share(), 1e3 * margin.limit, rest.data(),
      kWarnings.at(static_cast<std::size_t>(margin.band())));
}

void MarginWatch::follow(const Scene& scene, const Method& method, double step) {
  if (method_ != &method || !sameLiveParameters(scene_, scene)) {
    method_ = &method;
    scene_ = scene;
    lookedAt_ = -1;
    live_ = std::numeric_limits<double>::quiet_NaN();
    margin_ = {.rest = restLatticeLimit(scene, method)};
  }
  margin_.step = step;
  margin_.adaptive = method.adaptive && scene.tolerance > 0;
  margin_.limit = std::fmin(margin_.rest, live_);  // of a number and NaN, the number
}

void MarginWatch::lookAhead(const Scene& chosen) { follow(chosen, findMethod(chosen.integrator), chosen.dt); }

void MarginWatch::look(Simulation& simulation, const Clock& clock) {
  follow(simulation.scene(), simulation.method(), simulation.dt());
  const bool moves = simulation.status() == Status::Ok && simulation.ticks() != lookedAt_;
  if (!margin_.adaptive && moves) lookLive(simulation, clock);
  margin_.limit = std::fmin(margin_.rest, live_);
}

void MarginWatch::lookLive(Simulation& simulation, const Clock& clock) {
  const double began = clock();
  if (lookedAt_ >= 0 && began < nextLook_) return;
  live_ = simulation.liveStableStep();
  const double took = clock() - began;
  nextLook_ = began + took / kMostShare;
  if (lookedAt_ >= 0 && began > lastLook_) {
    margin_.cost += kSmoothing * (std::min(1.0, took / (began - lastLook_)) - margin_.cost);
  }
  lookedAt_ = simulation.ticks();
  lastLook_ = began;
}

}  // namespace tyg
