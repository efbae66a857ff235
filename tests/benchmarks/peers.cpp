// The peers' force lists every spring and adds it to both of its ends, as a plain program would write it.
#include "peers.h"

#include <algorithm>
#include <cmath>

#include "study/motion/error.h"

namespace tyg::peers {

Scene curtain(int count, Precision precision) {
  Scene scene = loadScene("curtain");
  scene.columns = scene.rows = count;
  scene.precision = precision;
  scene.dt = kStep;
  return scene;
}

void reportPerParticle(benchmark::State& state) {
  const double particleSteps = double(kCount) * kCount * kStepsPerRound * double(state.iterations());
  state.counters["per_particle_step"] =
      benchmark::Counter(particleSteps, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

SpringList::SpringList(const Scene& scene)
    : sheet_(makeSheet(scene)), gravity_(scene.gravity), isFree_(std::size_t(sheet_.count()), 1) {
  for (const int pin : sheet_.pins) isFree_[std::size_t(pin)] = 0;
  list(sheet_, scene.structural, Family::Structural);
  list(sheet_, scene.shear, Family::Shear);
  list(sheet_, scene.bend, Family::Bend);
}

void SpringList::list(const Sheet& sheet, const SpringFamily& law, Family family) {
  for (const SpringEnds& ends : springsOf(sheet, family)) {
    springs_.push_back(
        {6 * std::size_t(ends.first), 6 * std::size_t(ends.second), law.ks, law.kd, restLength(sheet, family)});
  }
}

std::vector<double> SpringList::start() const {
  std::vector<double> y(numbers());
  for (int particle = 0; particle < sheet_.count(); ++particle) {
    const Vec3 at = sheet_.startPosition(particle);
    double* const p = &y[6 * std::size_t(particle)];
    p[0] = at.x, p[1] = at.y, p[2] = at.z;
  }
  return y;
}

void SpringList::operator()(const double* y, double* dy) const {
  const double inverseMass = 1 / sheet_.particleMass;
  for (std::size_t p = 0; p < numbers(); p += 6) {
    for (std::size_t axis = 0; axis < 3; ++axis) dy[p + axis] = y[p + 3 + axis];
    dy[p + 3] = gravity_.x, dy[p + 4] = gravity_.y, dy[p + 5] = gravity_.z;
  }
  if (pushed_ >= 0) {
    double* const pushed = dy + 6 * pushed_ + 3;
    pushed[0] += inverseMass * pushForce_.x, pushed[1] += inverseMass * pushForce_.y;
    pushed[2] += inverseMass * pushForce_.z;
  }
  for (const Spring& s : springs_) {
    const double *a = y + s.a, *b = y + s.b;
    const double dx = b[0] - a[0], dY = b[1] - a[1], dz = b[2] - a[2];
    const double length = std::sqrt(dx * dx + dY * dY + dz * dz);
    const double pull = inverseMass * s.ks * (length - s.rest) / length, damp = inverseMass * s.kd;
    const double fx = pull * dx + damp * (b[3] - a[3]);
    const double fy = pull * dY + damp * (b[4] - a[4]);
    const double fz = pull * dz + damp * (b[5] - a[5]);
    double *onA = dy + s.a + 3, *onB = dy + s.b + 3;
    onA[0] += fx, onA[1] += fy, onA[2] += fz;
    onB[0] -= fx, onB[1] -= fy, onB[2] -= fz;
  }
  for (std::size_t particle = 0; particle < isFree_.size(); ++particle) {
    for (std::size_t axis = 3; axis < 6; ++axis) dy[6 * particle + axis] *= isFree_[particle];
  }
}

std::vector<Vec3> SpringList::positionsOf(const std::vector<double>& y) {
  std::vector<Vec3> positions;
  positions.reserve(y.size() / 6);
  for (std::size_t p = 0; p < y.size(); p += 6) positions.push_back({y[p], y[p + 1], y[p + 2]});
  return positions;
}

std::vector<Vec3> positionsOf(const Simulation& simulation) {
  std::vector<Vec3> positions;
  positions.reserve(std::size_t(simulation.sheet().count()));
  for (int particle = 0; particle < simulation.sheet().count(); ++particle) {
    positions.push_back(simulation.position(particle));
  }
  return positions;
}

double TwoSeconds::errorOf(const SampledMotion& motion) const {
  return motionError(motion, reference.motion).rms / reference.size;
}

const TwoSeconds& twoSeconds() {
  static const TwoSeconds kTwoSeconds = [] {
    const Scene scene = loadScene("poke");
    return TwoSeconds{scene, sampleTimes(scene), makeReference(scene, 1, [](double) { return true; })};
  }();
  return kTwoSeconds;
}

std::vector<Comparison>& comparisons() {
  static std::vector<Comparison> list;
  return list;
}

}  // namespace tyg::peers
