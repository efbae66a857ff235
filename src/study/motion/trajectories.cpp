// One run a method, stopped at the sample times; the rows then say how far each is from the finest of them.
#include "study/motion/trajectories.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <set>

#include <fmt/core.h>

#include "util/csv.h"
#include "util/suggestion.h"
#include "util/text.h"

namespace tyg {
namespace {

constexpr std::size_t kUsualAtMost = 3;

std::string labelOf(const Sheet& sheet, const Place& place) {
  if (!place.name.empty()) return place.name;
  const int index = particleAt(sheet, place);
  return std::to_string(index % sheet.columns) + ":" + std::to_string(index / sheet.columns);
}

bool isPinned(const Sheet& sheet, int particle) { return std::ranges::binary_search(sheet.pins, particle); }

/// The particles that are named, each once.
std::vector<ChartedParticle> eachOnce(const Sheet& sheet, const std::vector<Place>& places) {
  std::vector<ChartedParticle> particles;
  std::set<int> seen;
  for (const Place& place : places) {
    const int index = particleAt(sheet, place);
    if (particles.size() < kUsualAtMost && seen.insert(index).second) {
      particles.push_back({index, labelOf(sheet, place)});
    }
  }
  return particles;
}

std::vector<double> wholeStepTimes(const Scene& scene) {
  const auto steps = static_cast<std::int64_t>(std::ceil(scene.duration / scene.dt - 1e-9));
  const std::int64_t stride = std::max<std::int64_t>(1, (steps + kTrajectorySamples - 1) / kTrajectorySamples);
  std::vector<double> times;
  for (std::int64_t k = stride; k < steps; k += stride) times.push_back(static_cast<double>(k) * scene.dt);
  times.push_back(scene.duration);
  return times;
}

void sample(const Simulation& simulation, const std::vector<ChartedParticle>& particles, Trajectory& run) {
  run.times.push_back(simulation.time());
  for (std::size_t p = 0; p < particles.size(); ++p) run.paths[p].push_back(simulation.position(particles[p].index));
}

/// The held run of the highest order, fixed-step methods first: an adaptive one is as exact as its tolerance asks,
/// which says nothing about its order. The first run where none held.
std::size_t finestOf(const std::vector<Trajectory>& runs) {
  constexpr int kAboveEveryOrder = 100;
  std::size_t finest = 0;
  const auto rank = [&](std::size_t k) {
    if (runs[k].status != Status::Ok) return -1;
    return runs[k].method->order + (runs[k].method->adaptive ? 0 : kAboveEveryOrder);
  };
  for (std::size_t k = 1; k < runs.size(); ++k) {
    if (rank(k) > rank(finest)) finest = k;
  }
  return finest;
}

}  // namespace

double distanceFromFinest(const TrajectoryStudy& study, std::size_t run, std::size_t particle, std::size_t time) {
  const Trajectory& finest = study.runs[study.finest];
  if (time >= finest.times.size()) return std::numeric_limits<double>::quiet_NaN();
  const Vec3 a = study.runs[run].paths[particle][time], b = finest.paths[particle][time];
  return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

std::vector<ChartedParticle> usualParticles(const Scene& scene) {
  const Sheet sheet = makeSheet(scene);
  std::vector<Place> places;
  for (const Displacement& displacement : scene.displacements) places.push_back(displacement.particle);
  if (places.empty()) {
    for (const Push& push : scene.pushes) places.push_back(push.particle);
  }
  if (places.empty()) {
    for (const char* name : {"bottom-left", "middle"}) {
      const Place place{.name = name};
      if (!isPinned(sheet, particleAt(sheet, place))) places.push_back(place);
    }
  }
  if (places.empty()) places.push_back({.name = "top-left"});
  return eachOnce(sheet, places);
}

ChartedParticle chartedParticle(const Scene& scene, const std::string& name) {
  const Sheet sheet = makeSheet(scene);
  const std::span<const std::string_view> names = particleNames();
  const std::size_t colon = name.find(':');
  if (colon == std::string::npos && std::ranges::find(names, name) == names.end()) {
    throw InputError(fmt::format("--particles: found '{}', allowed are {}, and COLUMN:ROW such as 5:10{}", name,
                                 joined(names), didYouMean(name, names)));
  }
  Place place{.name = name};
  if (colon != std::string::npos) {
    const auto number = [&](const char* first, const char* last, int& value) {
      const auto [end, error] = std::from_chars(first, last, value);
      return error == std::errc() && end == last;
    };
    place.name.clear();
    const char* text = name.data();
    if (!number(text, text + colon, place.column) || !number(text + colon + 1, text + name.size(), place.row)) {
      throw InputError("--particles: found '" + name + "', allowed is COLUMN:ROW, such as 5:10");
    }
    if (place.column < 0 || place.column >= sheet.columns || place.row < 0 || place.row >= sheet.rows) {
      throw InputError(fmt::format("--particles: found '{}', allowed are columns 0 to {} and rows 0 to {}", name,
                                   sheet.columns - 1, sheet.rows - 1));
    }
  }
  const int index = particleAt(sheet, place);
  return {index, name};
}

TrajectoryStudy followParticles(const Scene& scene, std::vector<ChartedParticle> particles,
                                const std::vector<const Method*>& methods, int threads,
                                const std::function<bool(std::size_t run, double time)>& observer) {
  TrajectoryStudy study{.scene = scene, .particles = std::move(particles), .runs = {}};
  const std::vector<double> times = wholeStepTimes(scene);
  bool stopped = false;
  for (std::size_t k = 0; k < methods.size() && !stopped; ++k) {
    Trajectory run{.method = methods[k], .times = {}, .paths = {}};
    run.paths.resize(study.particles.size());
    Simulation simulation(scene, *methods[k], {.threads = threads});
    sample(simulation, study.particles, run);
    for (const double time : times) {
      simulation.advanceTo(time);
      stopped = !observer(k, simulation.time());
      if (stopped || simulation.status() != Status::Ok) break;
      sample(simulation, study.particles, run);
    }
    run.status = simulation.check();
    run.failedAt = simulation.alarmTime();
    study.runs.push_back(std::move(run));
  }
  study.finest = finestOf(study.runs);
  return study;
}

std::string trajectoryCsv(const TrajectoryStudy& study) {
  std::string csv = csvLine("integrator", "particle", "t", "x", "y", "z", "distance", "status");
  for (std::size_t k = 0; k < study.runs.size(); ++k) {
    const Trajectory& run = study.runs[k];
    for (std::size_t p = 0; p < study.particles.size(); ++p) {
      for (std::size_t i = 0; i < run.times.size(); ++i) {
        const Vec3 at = run.paths[p][i];
        csv += csvLine(run.method->name, study.particles[p].label, run.times[i], at.x, at.y, at.z,
                       distanceFromFinest(study, k, p, i), nameOf(run.status));
      }
    }
  }
  return csv;
}

}  // namespace tyg
