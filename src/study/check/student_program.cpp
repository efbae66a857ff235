// The forces are the report's equations, spring by spring; the steps are in student_steps.cpp.
#include "study/check/student_program.h"

#include <algorithm>
#include <cmath>

#include "study/check/vectors.h"

namespace tyg {

bool StudentProgram::takes(const Scene& scene) {
  return scene.air.density == 0 && scene.winds.empty() && scene.bodies.empty() && scene.moves.empty() &&
         !losesSprings(scene);
}

StudentProgram::StudentProgram(const Scene& scene, const Habits& habits, const StudentMethod& method, double dt)
    : scene_(scene), habits_(habits), method_(&method), dt_(dt) {
  const Sheet sheet = makeSheet(scene);
  const auto count = std::size_t(sheet.count());
  pins_ = sheet.pins;
  springsAt_.resize(count);
  const double shear = habits.shearRestsAtSpacing ? scene.spacing : restLength(sheet, Family::Shear);
  const double bend = habits.bendRestsAtSpacing ? scene.spacing : restLength(sheet, Family::Bend);
  addFamily(Family::Structural, scene.structural, scene.spacing);
  addFamily(Family::Shear, scene.shear, shear);
  addFamily(Family::Bend, scene.bend, bend);
  for (int particle = 0; particle < sheet.count(); ++particle) x_.push_back(sheet.startPosition(particle));
  for (const Displacement& one : scene.displacements) x_[std::size_t(particleAt(sheet, one.particle))] += one.by;
  for (const Push& push : scene.pushes) pushed_.push_back(particleAt(sheet, push.particle));
  start_ = x_;
  held_.assign(count, 0);
  if (habits.pins == Habits::Pins::Held) {
    for (const int pin : pins_) held_[std::size_t(pin)] = 1;
  }
  for (std::vector<Vec3>* field : {&v_, &a_, &stageX_, &stageV_, &sumX_, &sumV_}) field->assign(count, Vec3{});
}

void StudentProgram::addFamily(Family family, const SpringFamily& springs, double rest) {
  if (!springs.present()) return;
  for (const SpringEnds& ends : springsOf(makeSheet(scene_), family)) {
    springsAt_[std::size_t(ends.first)].push_back(int(springs_.size()));
    springsAt_[std::size_t(ends.second)].push_back(int(springs_.size()));
    springs_.push_back({ends.first, ends.second, springs.ks, springs.kd, rest});
  }
}

void StudentProgram::forcesOf(const Spring& spring, const Vec3& x1, const Vec3& x2, const Vec3& v1, const Vec3& v2,
                              Vec3& onFirst, Vec3& onSecond) const {
  const Vec3 l = x1 - x2;
  const double length = std::sqrt(dot(l, l)), kd = habits_.dampingSign * spring.kd;
  const double inverse = length > 0 ? 1 / length : 0;
  const Vec3 elastic = (-spring.ks * (length - spring.rest) * inverse) * l;
  const bool axial = scene_.damping == Damping::Axial;
  const auto damper = [&](const Vec3& v) { return axial ? (kd * dot(v, l) * inverse * inverse) * l : kd * v; };
  if (habits_.absoluteDamping) {
    onFirst = elastic - damper(v1);
    onSecond = -1 * elastic - damper(v2);
  } else {
    onFirst = elastic - damper(v1 - v2);
    onSecond = -1 * onFirst;
  }
  if (habits_.ends == Habits::Ends::First) onSecond = {};
  if (habits_.ends == Habits::Ends::Second) onFirst = {};
}

Vec3 StudentProgram::outer(int particle, const Vec3& v) const {
  Vec3 force = scene_.particleMass * scene_.gravity - scene_.drag * v;
  if (pushed_.empty()) return force;
  const double middle = time_ + dt_ / 2;
  for (std::size_t k = 0; k < pushed_.size(); ++k) {
    const Push& push = scene_.pushes[k];
    if (pushed_[k] == particle && middle > push.at && middle < push.at + push.duration) force += push.force;
  }
  return force;
}

void StudentProgram::accelerations(const std::vector<Vec3>& x, const std::vector<Vec3>& v, std::vector<Vec3>& a) const {
  for (std::size_t i = 0; i < x.size(); ++i) a[i] = outer(int(i), v[i]);
  const bool plain =
      habits_.ends == Habits::Ends::Both && !habits_.absoluteDamping && scene_.damping == Damping::Relative;
  Vec3 onFirst, onSecond;
  for (const Spring& spring : springs_) {
    const auto i = std::size_t(spring.first), j = std::size_t(spring.second);
    if (plain) {  // most of the time is spent here
      const Vec3 l = x[i] - x[j];
      const double length = std::sqrt(dot(l, l)), kd = habits_.dampingSign * spring.kd;
      const double pull = length > 0 ? spring.ks * (spring.rest / length - 1) : 0;
      const Vec3 force = pull * l - kd * (v[i] - v[j]);
      a[i] += force;
      a[j] = a[j] - force;
      continue;
    }
    forcesOf(spring, x[i], x[j], v[i], v[j], onFirst, onSecond);
    a[i] += onFirst;
    a[j] += onSecond;
  }
  for (std::size_t i = 0; i < x.size(); ++i) a[i] = held_[i] ? Vec3{} : (1 / scene_.particleMass) * a[i];
}

Vec3 StudentProgram::accelerationOf(int particle, const Vec3& x, const Vec3& v) const {
  Vec3 force = outer(particle, v), onFirst, onSecond;
  for (const int k : springsAt_[std::size_t(particle)]) {
    const Spring& spring = springs_[std::size_t(k)];
    const auto i = std::size_t(spring.first), j = std::size_t(spring.second);
    const bool isFirst = spring.first == particle;
    isFirst ? forcesOf(spring, x, x_[j], v, v_[j], onFirst, onSecond)
            : forcesOf(spring, x_[i], x, v_[i], v, onFirst, onSecond);
    force += isFirst ? onFirst : onSecond;
  }
  return (1 / scene_.particleMass) * force;
}

void StudentProgram::step() {
  time_ = double(done_++) * dt_;
  if (habits_.inPlace) {
    for (std::size_t i = 0; i < x_.size(); ++i) {
      if (!held_[i]) method_->stepAlone(*this, int(i), dt_);
    }
    haveForce_ = true;
  } else {
    method_->step(*this, dt_);
  }
  for (const int pin : pins_) {
    const auto i = std::size_t(pin);
    if (habits_.pins == Habits::Pins::PutBack || habits_.pins == Habits::Pins::HeldAfterStep) x_[i] = start_[i];
    if (habits_.pins == Habits::Pins::StoppedAfterMove || habits_.pins == Habits::Pins::HeldAfterStep) v_[i] = {};
  }
}

}  // namespace tyg
