// Where chosen particles go in time, by one method or several, and the rows of it.
// Must not know: files, how the rows are drawn, options.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "tyg/simulation.h"

namespace tyg {

/// A particle by its index and by the name that the chart gives it.
struct ChartedParticle {
  int index = 0;
  std::string label;
};

/// The particles that a chart of this scene follows when nobody says which: those drawn out at the start, else those
/// pushed, else the bottom-left and the middle one as far as they are free. At most three.
std::vector<ChartedParticle> usualParticles(const Scene& scene);
/// One particle by its name, or as COLUMN:ROW. Throws InputError.
ChartedParticle chartedParticle(const Scene& scene, const std::string& name);

/// The path of every charted particle by one method.
struct Trajectory {
  const Method* method = nullptr;
  Status status = Status::Ok;
  double failedAt = std::numeric_limits<double>::quiet_NaN();  ///< s; NaN for a run that held
  std::vector<double> times;                                   ///< s
  std::vector<std::vector<Vec3>> paths;                        ///< m; per particle, one position a time
};

struct TrajectoryStudy {
  Scene scene;
  std::vector<ChartedParticle> particles;
  std::vector<Trajectory> runs;
  std::size_t finest =
      0;  ///< the run that the others are compared with: the fixed-step one of the highest order that held
};

/// Samples that are enough for a smooth curve.
inline constexpr int kTrajectorySamples = 1000;

/// Runs the scene by each method and samples at whole steps of dt, at most about kTrajectorySamples times: sampling
/// then changes no step, but where a push begins or ends at no multiple of dt and up to the next sample. `observer`
/// gets the run's number and its simulated time and may return false to stop everything.
TrajectoryStudy followParticles(const Scene& scene, std::vector<ChartedParticle> particles,
                                const std::vector<const Method*>& methods, int threads,
                                const std::function<bool(std::size_t run, double time)>& observer);

/// The rows as CSV: integrator,particle,t,x,y,z,distance,status with t in s and the rest in m; distance is the one from
/// the finest method's particle at that time.
std::string trajectoryCsv(const TrajectoryStudy& study);

/// How far a run's particle is from the finest run's at the same sample, m; NaN where the finest run ended before.
double distanceFromFinest(const TrajectoryStudy& study, std::size_t run, std::size_t particle, std::size_t time);

}  // namespace tyg
