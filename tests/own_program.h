// A cloth as somebody else would program it, with every mistake that the check knows: each particle gathers the forces
// of its neighbours, and the state is one row of numbers. Shares no code with Tyg's forces, methods or check.
#pragma once

#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "tyg/sheet.h"

namespace tyg::test {

class OwnProgram {
 public:
  /// `mistakes`: names of the check's table; `method`: a name of Tyg's, or heun, midpoint, position-first Euler.
  OwnProgram(const Scene& scene, std::vector<std::string> mistakes, std::string method, double h)
      : s_(scene), mistakes_(std::move(mistakes)), method_(std::move(method)), h_(h) {
    const Sheet sheet = makeSheet(scene);
    n_ = std::size_t(sheet.count());
    y_.assign(6 * n_, 0.0);
    pinned_.assign(n_, false);
    if (!has("pins left out")) {
      for (const int pin : sheet.pins) pinned_[std::size_t(pin)] = true;
    }
    for (std::size_t i = 0; i < n_; ++i) {
      const Vec3 at = sheet.startPosition(int(i));
      y_[3 * i] = at.x, y_[3 * i + 1] = at.y, y_[3 * i + 2] = at.z;
    }
    for (const Displacement& one : scene.displacements) {
      const auto i = std::size_t(particleAt(sheet, one.particle));
      y_[3 * i] += one.by.x, y_[3 * i + 1] += one.by.y, y_[3 * i + 2] += one.by.z;
    }
    for (const Push& push : scene.pushes) pushed_.push_back(std::size_t(particleAt(sheet, push.particle)));
    start_ = y_;
    mass_ = s_.particleMass;
    if (has("mass per sheet instead of per particle")) mass_ *= double(n_);
    if (has("mass of a particle shared by the sheet")) mass_ /= double(n_);
    if (has("mass in grams instead of kilograms")) mass_ *= 1000;
  }

  [[nodiscard]] bool has(std::string_view name) const {
    for (const std::string& mistake : mistakes_) {
      if (mistake == name) return true;
    }
    return false;
  }
  [[nodiscard]] Vec3 at(std::size_t i) const { return {y_[3 * i], y_[3 * i + 1], y_[3 * i + 2]}; }
  [[nodiscard]] std::size_t count() const { return n_; }

  void step() {
    t_ = double(steps_++) * h_;
    inPlace_ = has("particles updated in place");
    if (inPlace_) {
      for (std::size_t i = 0; i < n_; ++i) {
        if (!isHeld(i)) advance({i});
      }
      started_ = true;
    } else {
      std::vector<std::size_t> all(n_);
      for (std::size_t i = 0; i < n_; ++i) all[i] = i;
      advance(all);
      started_ = true;
    }
    for (std::size_t i = 0; i < n_; ++i) {
      if (!pinned_[i]) continue;
      const bool after = has("pins held only after the step");
      for (std::size_t k = 3 * i; k < 3 * i + 3; ++k) {
        if (after || has("pins put back with their velocity")) y_[k] = start_[k];
        if (after || has("pinned after the position was moved")) y_[3 * n_ + k] = 0;
      }
    }
  }

 private:
  using Row = std::vector<double>;

  [[nodiscard]] bool isHeld(std::size_t i) const {
    return pinned_[i] && !has("pinned after the position was moved") && !has("pins put back with their velocity") &&
           !has("pins held only after the step");
  }

  /// Acceleration of one particle of a state.
  void pull(const Row& y, std::size_t i, double* a) const {
    double f[3];
    const double* v = &y[3 * n_ + 3 * i];
    const double g[3] = {s_.gravity.x, s_.gravity.y, s_.gravity.z};
    double factor = has("gravity left out") ? 0 : has("gravity doubled") ? 2 : has("gravity reversed") ? -1 : 1;
    factor *= has("gravity not multiplied by the mass") ? mass_ / s_.particleMass : mass_;
    const double drag = s_.drag + (has("damping as drag on every particle") ? s_.structural.kd : 0);
    for (int k = 0; k < 3; ++k) f[k] = factor * g[k] - drag * v[k];
    for (std::size_t p = 0; p < pushed_.size() && !has("push left out"); ++p) {
      const Push& push = s_.pushes[p];
      const bool on = t_ > push.at - h_ / 2 && (has("push that never ends") || t_ < push.at + push.duration - h_ / 2);
      if (pushed_[p] != i || !on) continue;
      f[0] += push.force.x, f[1] += push.force.y, f[2] += push.force.z;
    }
    static constexpr int kTo[12][2] = {{1, 0},   {0, 1},  {-1, 0}, {0, -1}, {1, 1},  {-1, 1},
                                       {-1, -1}, {1, -1}, {2, 0},  {0, 2},  {-2, 0}, {0, -2}};
    const int c = int(i) % s_.columns, r = int(i) / s_.columns;
    for (int k = 0; k < 12; ++k) {
      const int oc = c + kTo[k][0], orow = r + kTo[k][1];
      if (oc < 0 || orow < 0 || oc >= s_.columns || orow >= s_.rows) continue;
      spring(y, i, std::size_t(orow * s_.columns + oc), k / 4, k % 4 < 2, f);
    }
    for (int k = 0; k < 3; ++k) a[k] = f[k] / mass_;
  }

  void spring(const Row& y, std::size_t i, std::size_t j, int family, bool isFirst, double* f) const {
    const SpringFamily& kind = family == 0 ? s_.structural : family == 1 ? s_.shear : s_.bend;
    if (family == 0 && has("structural springs left out")) return;
    if (family == 1 && has("shear springs left out")) return;
    if (family == 2 && has("bend springs left out")) return;
    if (has("each spring applied to one end only") && !isFirst) return;
    if (has("each spring applied to its second end only") && isFirst) return;
    double rest = family == 0 ? s_.spacing : family == 1 ? s_.spacing * std::sqrt(2.0) : 2 * s_.spacing;
    if (family == 1 && has("shear rest length equal to the spacing")) rest = s_.spacing;
    if (family == 2 && has("bend rest length equal to the spacing")) rest = s_.spacing;
    double d[3], w[3], length = 0;
    for (int k = 0; k < 3; ++k) {
      d[k] = y[3 * j + std::size_t(k)] - y[3 * i + std::size_t(k)];
      w[k] = y[3 * n_ + 3 * i + std::size_t(k)];
      if (!has("absolute for relative damping")) w[k] -= y[3 * n_ + 3 * j + std::size_t(k)];
      length += d[k] * d[k];
    }
    length = std::sqrt(length);
    const double twice = has("each spring applied twice") ? 2 : 1;
    double kd = has("damping left out") || has("damping as drag on every particle") ? 0 : kind.kd;
    if (has("damping reversed")) kd = -kd;
    bool axial = s_.damping == Damping::Axial;
    if (has("axial for relative damping") || has("relative for axial damping")) axial = !axial;
    const double along = length > 0 ? (w[0] * d[0] + w[1] * d[1] + w[2] * d[2]) / length : 0;
    for (int k = 0; k < 3; ++k) {
      const double n = length > 0 ? d[k] / length : 0;
      f[k] += twice * (kind.ks * (length - rest) * n - kd * (axial ? along * n : w[k]));
    }
  }

  [[nodiscard]] Row forces(const Row& y, const std::vector<std::size_t>& who) const {
    Row a(3 * n_, 0.0);
    for (const std::size_t i : who) {
      if (!isHeld(i)) pull(y, i, &a[3 * i]);
    }
    return a;
  }
  /// y with x += hx * velocities, v += hv * a, of some particles.
  [[nodiscard]] Row moved(Row y, double hx, const Row& velocities, double hv, const Row& a,
                          const std::vector<std::size_t>& who) const {
    for (const std::size_t i : who) {
      for (std::size_t k = 3 * i; k < 3 * i + 3; ++k) {
        y[k] += hx * velocities[3 * n_ + k];
        y[3 * n_ + k] += hv * a[k];
      }
    }
    return y;
  }

  void advance(const std::vector<std::size_t>& who) {
    const bool stale = has("forces kept stale across stages");
    if (method_ == "explicit-euler") {
      y_ = moved(y_, h_, y_, h_, forces(y_, who), who);
    } else if (method_ == "symplectic-euler" || method_ == "report-rk4") {
      const double h = method_ == "report-rk4" ? h_ + h_ * h_ / 2 + h_ * h_ * h_ / 6 + h_ * h_ * h_ * h_ / 24 : h_;
      const Row kicked = moved(y_, 0, y_, h, forces(y_, who), who);
      y_ = moved(kicked, h, kicked, 0, kicked, who);
    } else if (method_ == "position-first Euler") {
      y_ = moved(y_, h_, y_, 0, y_, who);
      y_ = moved(y_, 0, y_, h_, forces(y_, who), who);
    } else if (method_ == "leapfrog") {
      leapfrog(who, stale);
    } else if (method_ == "heun") {
      const Row k1 = forces(y_, who), second = moved(y_, h_, y_, h_, k1, who);
      const Row k2 = stale ? k1 : forces(second, who);
      const Row half = moved(y_, h_ / 2, y_, h_ / 2, k1, who);
      y_ = moved(half, h_ / 2, second, h_ / 2, k2, who);
    } else if (method_ == "midpoint") {
      const Row k1 = forces(y_, who), middle = moved(y_, h_ / 2, y_, h_ / 2, k1, who);
      y_ = moved(y_, h_, middle, h_, stale ? k1 : forces(middle, who), who);
    } else {
      const Row k1 = forces(y_, who), y2 = moved(y_, h_ / 2, y_, h_ / 2, k1, who);
      const Row k2 = stale ? k1 : forces(y2, who), y3 = moved(y_, h_ / 2, y2, h_ / 2, k2, who);
      const Row k3 = stale ? k1 : forces(y3, who), y4 = moved(y_, h_, y3, h_, k3, who);
      const Row k4 = stale ? k1 : forces(y4, who);
      Row end = moved(y_, h_ / 6, y_, h_ / 6, k1, who);
      end = moved(end, h_ / 3, y2, h_ / 3, k2, who);
      end = moved(end, h_ / 3, y3, h_ / 3, k3, who);
      y_ = moved(end, h_ / 6, y4, h_ / 6, k4, who);
    }
  }
  void leapfrog(const std::vector<std::size_t>& who, bool stale) {
    if (kept_.empty()) kept_.assign(3 * n_, 0.0);
    if (!started_ || stale) keep(forces(y_, who), who);
    const Row kicked = moved(y_, 0, y_, h_ / 2, kept_, who), drifted = moved(kicked, h_, kicked, 0, kept_, who);
    if (!stale) keep(forces(moved(drifted, 0, drifted, h_ / 2, kept_, who), who), who);
    y_ = moved(drifted, 0, drifted, h_ / 2, kept_, who);
  }
  void keep(const Row& a, const std::vector<std::size_t>& who) {
    for (const std::size_t i : who) {
      for (std::size_t k = 3 * i; k < 3 * i + 3; ++k) kept_[k] = a[k];
    }
  }

  Scene s_;
  std::vector<std::string> mistakes_;
  std::string method_;
  double h_, t_ = 0, mass_ = 1;
  std::size_t n_ = 0;
  long steps_ = 0;
  bool inPlace_ = false, started_ = false;
  Row y_, start_, kept_;
  std::vector<bool> pinned_;
  std::vector<std::size_t> pushed_;
};

/// The motion as that program would write it: every `every` steps up to the scene's duration, in this format of printf.
inline std::string ownRows(OwnProgram program, double h, int steps, int every, const char* format = "%.17g") {
  std::string text = "t,particle,x,y,z\n";
  const auto number = [&](double value) {
    char digits[40];
    std::snprintf(digits, sizeof digits, format, value);
    return std::string(digits);
  };
  for (int k = 1; k <= steps; ++k) {
    program.step();
    if (k % every != 0) continue;
    for (std::size_t i = 0; i < program.count(); ++i) {
      const Vec3 at = program.at(i);
      text +=
          number(h * k) + ',' + std::to_string(i) + ',' + number(at.x) + ',' + number(at.y) + ',' + number(at.z) + '\n';
    }
  }
  return text;
}

}  // namespace tyg::test
