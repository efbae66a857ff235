// See margin.h.
#include "app/margin.h"

#include <cmath>
#include <cstdio>

#include "study/stability.h"

namespace tyg {
MarginBand Margin::band() const {
  if (adaptive || !std::isfinite(limit)) return MarginBand::None;
  if (share() < kClose) return MarginBand::Fine;
  return share() < 1 ? MarginBand::Close : MarginBand::Past;
}

void describe(const Margin& margin, MarginText& text) {
  const auto say = [&text](const char* format, auto... values) {
    std::snprintf(text.data(), text.size(), format, values...);
  };
  if (margin.adaptive) return say("%s", "chooses its own steps");
  if (!std::isfinite(margin.limit)) return say("%s", "no step is too large for it");
  if (margin.limit == 0) return say("%s", "no step holds: it needs damping");
  const double share = margin.share(), limit = 1e3 * margin.limit;
  switch (margin.band()) {
    case MarginBand::Past:
      return say("%.2f of the limit of %.3g ms: PAST IT, the cloth will break", share, limit);
    case MarginBand::Close:
      return say("%.2f of the limit of %.3g ms: close, a little more breaks it", share, limit);
    default:
      return say("%.2f of the limit of %.3g ms", share, limit);
  }
}

void MarginWatch::look(Simulation& simulation, const Clock& /*clock*/) {
  const Method& method = simulation.method();
  if (method_ != &method) {
    method_ = &method;
    rest_ = restLatticeLimit(simulation.scene(), method);
    margin_ = {};
  }
  margin_.step = simulation.dt();
  margin_.adaptive = method.adaptive && simulation.scene().tolerance > 0;
  margin_.limit = rest_;
}

double MarginWatch::certainLimit() const { return rest_; }

}  // namespace tyg
