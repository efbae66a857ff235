// Edges lie at the begin and the end of everything that the scene gives a time.
#include "core/simulation/timetable.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/forces/terms/contact.h"

namespace tyg {

namespace {

template <class Timed>
void addEdges(const std::vector<Timed>& all, std::vector<double>& edges) {
  for (const Timed& each : all) {
    edges.push_back(each.at);
    if (std::isfinite(each.duration)) edges.push_back(each.at + each.duration);
  }
}

/// Of everything but pushes, which count in ticks where a person makes them.
std::vector<double> edgesBesidesPushes(const Scene& scene) {
  std::vector<double> edges;
  addEdges(scene.winds, edges);
  addEdges(scene.moves, edges);
  for (const Cut& cut : scene.cuts) edges.push_back(cut.at);
  return edges;
}

}  // namespace

Timetable::Timetable(const Scene& scene) : edges_(edgesBesidesPushes(scene)) { std::ranges::sort(edges_); }

std::vector<double> edgesWithin(const Scene& scene) {
  std::vector<double> edges = edgesBesidesPushes(scene);
  addEdges(scene.pushes, edges);
  std::erase_if(edges, [&](double edge) { return !(edge > 0 && edge < scene.duration); });
  std::ranges::sort(edges);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

double Timetable::nextEdge(const Instant& now, double end) const {
  const auto next = std::ranges::upper_bound(edges_, now.time + now.sameTime);
  return next == edges_.end() || *next >= end - now.sameTime ? end : *next;
}

bool Timetable::isEdge(const Instant& now) const {
  const auto next = std::ranges::lower_bound(edges_, now.time - now.sameTime);
  return next != edges_.end() && *next <= now.time + now.sameTime;
}

Acting actingAt(const Scene& scene, const Instant& now) {
  Acting acting;
  std::ranges::copy_if(scene.winds, std::back_inserter(acting.winds),
                       [&](const Wind& wind) { return now.isWithin(wind.at, wind.duration); });
  for (const Body& body : scene.bodies) acting.bodies.push_back(motionOf(scene, body, now.time, now.sameTime));
  return acting;
}

}  // namespace tyg
