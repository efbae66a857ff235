// What the tests measure the program against, written from the model's definition alone: a plain list of springs in
// double (the oracle), small systems with known answers, and a method stepped by hand. Must not know: how the program
// computes forces.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "core/forces/forces.h"
#include "core/simulation/integrator.h"
#include "tyg/input_error.h"
#include "tyg/method.h"
#include "tyg/scene.h"
#include "tyg/sheet.h"
#include "util/workers.h"

namespace tyg::test {

/// What is said where `act` is refused; empty where it is not.
template <class Act>
std::string messageOf(const Act& act) {
  try {
    act();
  } catch (const InputError& refusal) {
    return refusal.what();
  }
  return "";
}

inline Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3 operator*(double s, const Vec3& a) { return {s * a.x, s * a.y, s * a.z}; }
inline double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(const Vec3& a) { return std::sqrt(dot(a, a)); }

/// Positions (m) and velocities (m/s), one vector per particle.
struct Points {
  std::vector<Vec3> x, v;
};

/// Root of the mean over particles of |a - b|^2, m.
inline double distance(const Points& a, const Points& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.x.size(); ++i) sum += dot(a.x[i] - b.x[i], a.x[i] - b.x[i]);
  return std::sqrt(sum / double(a.x.size()));
}

/// The model as a list of springs. Slow, short, and sharing nothing with the program's forces.
class Oracle {
 public:
  explicit Oracle(const Scene& scene) : scene_(scene), pinned_(std::size_t(scene.columns * scene.rows)) {
    const double a = scene.spacing;
    for (int r = 0; r < scene.rows; ++r) {
      for (int c = 0; c < scene.columns; ++c) {
        join(c, r, c + 1, r, scene.structural, a);
        join(c, r, c, r + 1, scene.structural, a);
        join(c, r, c + 1, r + 1, scene.shear, a * std::sqrt(2.0));
        join(c, r, c - 1, r + 1, scene.shear, a * std::sqrt(2.0));
        join(c, r, c + 2, r, scene.bend, 2 * a);
        join(c, r, c, r + 2, scene.bend, 2 * a);
      }
    }
    const Sheet sheet = makeSheet(scene);
    for (const int pin : sheet.pins) pinned_[std::size_t(pin)] = true;
  }

  /// Leaves out what a cut takes, by the words of docs/model.md.
  void cut(const CutLine& line) {
    double nx = line.toRow - line.fromRow, ny = line.fromColumn - line.toColumn;
    if (nx < 0 || (nx == 0 && ny < 0)) nx = -nx, ny = -ny;
    const auto isBeyond = [&](double c, double r) { return nx * (c - line.fromColumn) + ny * (r - line.fromRow) >= 0; };
    std::erase_if(springs_, [&](const Spring& spring) {
      const auto columns = std::size_t(scene_.columns);
      const double ac = double(spring.first % columns), ar = double(spring.first / columns);
      const double bc = double(spring.second % columns), br = double(spring.second / columns);
      const auto beside = [&](double c, double r) { return (bc - ac) * (r - ar) - (br - ar) * (c - ac); };
      const double from = beside(line.fromColumn, line.fromRow), to = beside(line.toColumn, line.toRow);
      return isBeyond(ac, ar) != isBeyond(bc, br) && !(from > 0 && to > 0) && !(from < 0 && to < 0);
    });
  }

  [[nodiscard]] bool pinned(std::size_t particle) const { return pinned_[particle]; }

  /// Newtons on every particle.
  [[nodiscard]] std::vector<Vec3> force(const Points& at) const {
    std::vector<Vec3> sum(at.x.size());
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = scene_.particleMass * scene_.gravity - scene_.drag * at.v[i];
    for (const Spring& spring : springs_) {
      const Vec3 one = springForce(spring, at);
      sum[spring.first] = sum[spring.first] + one;
      sum[spring.second] = sum[spring.second] - one;
    }
    for (std::size_t i = 0; i < sum.size(); ++i) {
      if (pinned_[i]) sum[i] = {};
    }
    return sum;
  }

  /// The size of what is added up on each particle, N: rounding errors are fractions of it.
  [[nodiscard]] std::vector<double> magnitude(const Points& at) const {
    std::vector<double> sum(at.x.size());
    for (std::size_t i = 0; i < sum.size(); ++i) {
      sum[i] = scene_.particleMass * length(scene_.gravity) + scene_.drag * length(at.v[i]);
    }
    for (const Spring& spring : springs_) {
      const double terms = spring.ks * (length(at.x[spring.first] - at.x[spring.second]) + spring.rest) +
                           spring.kd * (length(at.v[spring.first]) + length(at.v[spring.second]));
      sum[spring.first] += terms;
      sum[spring.second] += terms;
    }
    return sum;
  }

  /// Elastic energy, J.
  [[nodiscard]] double elastic(const Points& at) const {
    double sum = 0;
    for (const Spring& spring : springs_) {
      const double elongation = length(at.x[spring.first] - at.x[spring.second]) - spring.rest;
      sum += spring.ks * elongation * elongation / 2;
    }
    return sum;
  }

  /// The classical Runge-Kutta method over `seconds` in `steps` steps, with `push` newtons on one particle.
  void advance(Points& at, double seconds, int steps, std::size_t pushed = 0, const Vec3& push = {}) const {
    const double h = seconds / steps;
    const auto rate = [&](const Points& p) {
      Points dp{p.v, force(p)};
      if (!pinned_[pushed]) dp.v[pushed] = dp.v[pushed] + push;
      for (Vec3& a : dp.v) a = (1 / scene_.particleMass) * a;
      return dp;
    };
    for (int n = 0; n < steps; ++n) {
      const Points k1 = rate(at);
      const Points k2 = rate(moved(at, h / 2, k1));
      const Points k3 = rate(moved(at, h / 2, k2));
      const Points k4 = rate(moved(at, h, k3));
      at = moved(moved(moved(moved(at, h / 6, k1), h / 3, k2), h / 3, k3), h / 6, k4);
    }
  }

 private:
  struct Spring {
    std::size_t first, second;
    double rest, ks, kd;
  };

  void join(int c, int r, int c2, int r2, const SpringFamily& family, double rest) {
    if (c2 < 0 || c2 >= scene_.columns || r2 >= scene_.rows) return;
    const auto index = [&](int column, int row) { return std::size_t(row * scene_.columns + column); };
    springs_.push_back({index(c, r), index(c2, r2), rest, family.ks, family.kd});
  }

  [[nodiscard]] Vec3 springForce(const Spring& spring, const Points& at) const {
    const Vec3 apart = at.x[spring.first] - at.x[spring.second];
    const Vec3 parting = at.v[spring.first] - at.v[spring.second];
    const double long_ = length(apart);
    const Vec3 n = long_ > 0 ? (1 / long_) * apart : Vec3{};
    const Vec3 damped = scene_.damping == Damping::Relative ? parting : dot(parting, n) * n;
    return -spring.ks * (long_ - spring.rest) * n - spring.kd * damped;
  }

  static Points moved(Points at, double h, const Points& rate) {
    for (std::size_t i = 0; i < at.x.size(); ++i) {
      at.x[i] = at.x[i] + h * rate.x[i];
      at.v[i] = at.v[i] + h * rate.v[i];
    }
    return at;
  }

  Scene scene_;
  std::vector<Spring> springs_;
  std::vector<bool> pinned_;
};

/// A scene's forces and state, stepped by hand.
template <class T>
struct Bench {
  explicit Bench(const Scene& wanted, int threads = 1)
      : scene(wanted),
        sheet(makeSheet(scene)),
        workers(threads),
        forces(scene, sheet, workers),
        state(startState<T>(sheet)) {}

  [[nodiscard]] Points points() const {
    Points all;
    for (int i = 0; i < sheet.count(); ++i) {
      all.x.push_back(state.position.get(i));
      all.v.push_back(state.velocity.get(i));
    }
    return all;
  }
  void set(const Points& points) {
    for (int i = 0; i < sheet.count(); ++i) {
      state.position.set(i, points.x[std::size_t(i)]);
      state.velocity.set(i, points.v[std::size_t(i)]);
    }
  }
  std::vector<Vec3> force() {
    VectorField<T> field(forces.layout());
    forces.evaluate(0, state.position, state.velocity, field);
    std::vector<Vec3> all;
    for (int i = 0; i < sheet.count(); ++i) all.push_back(field.get(i));
    return all;
  }
  void advance(const Method& method, double seconds, int steps) {
    const auto integrator = method.make<T>(scene, sheet);
    for (int n = 0; n < steps; ++n) integrator->step(forces, state, n * seconds / steps, seconds / steps);
  }

  Scene scene;
  Sheet sheet;
  Workers workers;
  Forces<T> forces;
  State<T> state;
};

/// Particles of 1 kg one metre apart, and nothing that acts on them.
inline Scene emptyWorld(int columns, int rows) {
  Scene scene;
  scene.name = "test";
  scene.columns = columns;
  scene.rows = rows;
  scene.gravity = {};
  scene.integrator = "rk4";
  return scene;
}

/// Bodies of every shape that a sheet of emptyWorld(5, 4) touches.
inline std::vector<Body> bodiesOfEveryShape() {
  return {{.shape = Shape::Plane, .at = {0, 0, 0.1}, .normal = {0, 0, 1}},
          {.shape = Shape::Ball, .at = {-1, -1, 0.2}, .radius = 1.3},
          {.shape = Shape::Capsule, .at = {1, -2, -1}, .axis = {0.5, 0.3, 2}, .radius = 1},
          {.shape = Shape::Box, .at = {1.5, -1, 0.1}, .half = {1.6, 1.1, 1.3}, .radius = 1},
          {.shape = Shape::Plane, .at = {0, -1, 0}, .normal = {0.6, 0.8, 0}},
          {.shape = Shape::Plane, .at = {0, -2, 0}, .normal = {0, 1, 0}}};
}

/// One particle that nothing holds.
inline Scene freeFall() {
  Scene scene = emptyWorld(1, 1);
  scene.gravity = {0, -9.81, 0};
  return scene;
}

/// Two particles along x, the left one pinned: x'' = -ks (x - rest) - kd x' for the right one, exactly linear.
inline Scene oscillator(double ks, double kd) {
  Scene scene = emptyWorld(2, 1);
  scene.pins = {{"top-left"}};
  scene.structural = {ks, kd};
  return scene;
}

/// `links` springs in a vertical row, the top particle pinned.
inline Scene hangingChain(int links, double linkLength, double mass, const SpringFamily& spring) {
  Scene scene = emptyWorld(1, links + 1);
  scene.spacing = linkLength;
  scene.particleMass = mass;
  scene.pins = {{"top-left"}};
  scene.structural = spring;
  scene.gravity = {0, -9.81, 0};
  return scene;
}

/// A small sheet with every kind of force, soft enough to be smooth at steps of a hundredth of a second.
inline Scene softSheet(Damping damping) {
  Scene scene = emptyWorld(3, 4);
  scene.start = Start::Flat;
  scene.pins = {{"top-left"}, {"top-right"}};
  scene.damping = damping;
  scene.structural = {30, 0.4};
  scene.shear = {20, 0.2};
  scene.bend = {10, 0.3};
  scene.gravity = {0.5, -3, 0.2};
  scene.drag = 0.1;
  return scene;
}

/// Numbers from a fixed seed, the same on every machine (the standard's distributions are not).
class Numbers {
 public:
  explicit Numbers(unsigned seed) : engine_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * double(engine_()) / double(std::mt19937::max());
  }
  bool coin() { return engine_() % 2 == 0; }
  Vec3 inCube(double half) {
    const double x = between(-half, half), y = between(-half, half);
    return {x, y, between(-half, half)};
  }

 private:
  std::mt19937 engine_;
};

/// A sheet with families, damping law, world and pins drawn at random.
inline Scene randomScene(int columns, int rows, Numbers& numbers) {
  Scene scene = emptyWorld(columns, rows);
  const auto family = [&] {
    SpringFamily springs;
    if (numbers.coin()) springs.ks = numbers.between(1, 1000);
    if (numbers.coin()) springs.kd = numbers.between(0.01, 5);
    return springs;
  };
  scene.spacing = numbers.between(0.05, 2);
  scene.particleMass = numbers.between(0.01, 2);
  scene.start = numbers.coin() ? Start::Flat : Start::Hanging;
  scene.damping = numbers.coin() ? Damping::Relative : Damping::Axial;
  scene.structural = family();
  scene.shear = family();
  scene.bend = family();
  if (numbers.coin()) scene.gravity = numbers.inCube(10);
  if (numbers.coin()) scene.drag = numbers.between(0.01, 1);
  if (numbers.coin()) scene.pins = {{"", int(numbers.between(0, columns - 1)), int(numbers.between(0, rows - 1))}};
  return scene;
}

/// Moves every particle by up to `share` of the spacing and gives it a velocity of up to as many metres per second.
template <class T>
void shake(Bench<T>& bench, double share, Numbers& numbers) {
  for (int i = 0; i < bench.sheet.count(); ++i) {
    bench.state.position.set(i, bench.state.position.get(i) + numbers.inCube(share * bench.sheet.spacing));
    bench.state.velocity.set(i, numbers.inCube(share * bench.sheet.spacing));
  }
}

}  // namespace tyg::test
