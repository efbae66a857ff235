// A cloth as students program it: plain arrays, a list of springs, one loop; and with the habits that go wrong, which
// no scene can express. Must not know: Tyg's forces and methods, motions that were handed in.
#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "tyg/sheet.h"

namespace tyg {

/// What such a program may do wrong. As it stands here it does nothing wrong.
struct Habits {
  enum class Ends { Both, First, Second };  ///< which ends of a spring get its force
  enum class Pins {
    Held,              ///< in every stage, as they should be
    StoppedAfterMove,  ///< their velocity is set to 0 once the step has moved them
    PutBack,           ///< they are put back after the step, and keep their velocity
    HeldAfterStep      ///< both, but only after the step
  };
  Ends ends = Ends::Both;
  Pins pins = Pins::Held;
  double dampingSign = 1;        ///< -1: dampers push
  bool absoluteDamping = false;  ///< each end is damped against the air, not against the other end
  bool shearRestsAtSpacing = false, bendRestsAtSpacing = false;
  bool inPlace = false;  ///< each particle is moved before the next one's force is worked out
  bool stale = false;    ///< the force of the step's beginning serves all of its stages
  bool operator==(const Habits&) const = default;
};

/// A method as such a program has it.
struct StudentMethod {
  std::string_view name;   ///< of Tyg's method where there is one, else its usual name
  std::string_view label;  ///< for sentences
  int order = 1;           ///< of convergence
  int evaluations = 1;     ///< of the force in a step
  bool known = true;       ///< is it one of Tyg's?
  void (*step)(class StudentProgram& program, double h) = nullptr;
  void (*stepAlone)(class StudentProgram& program, int particle, double h) = nullptr;  ///< of one particle, in place
};
std::span<const StudentMethod> studentMethods();

class StudentProgram {
 public:
  /// Whether a scene has nothing but springs, gravity, drag, pins, pushes and displacements.
  static bool takes(const Scene& scene);
  /// `scene` must be one that takes() is true of.
  StudentProgram(const Scene& scene, const Habits& habits, const StudentMethod& method, double dt);

  void step();
  [[nodiscard]] const std::vector<Vec3>& positions() const { return x_; }
  [[nodiscard]] std::size_t springs() const { return springs_.size(); }

 private:
  friend struct StudentSteps;

  struct Spring {
    int first, second;
    double ks, kd, rest;
  };
  void addFamily(Family family, const SpringFamily& springs, double rest);
  /// The force of a spring on its first end and on its second one, if that is where the program applies it.
  void forcesOf(const Spring& spring, const Vec3& x1, const Vec3& x2, const Vec3& v1, const Vec3& v2, Vec3& onFirst,
                Vec3& onSecond) const;
  void accelerations(const std::vector<Vec3>& x, const std::vector<Vec3>& v, std::vector<Vec3>& a) const;
  [[nodiscard]] Vec3 accelerationOf(int particle, const Vec3& x, const Vec3& v) const;
  [[nodiscard]] Vec3 outer(int particle, const Vec3& v) const;  ///< force of gravity, drag and pushes

  Scene scene_;
  Habits habits_;
  const StudentMethod* method_;
  double dt_, time_ = 0;
  std::int64_t done_ = 0;
  std::vector<Spring> springs_;
  std::vector<std::vector<int>> springsAt_;
  std::vector<int> pins_, pushed_;
  std::vector<char> held_;  // in every stage
  std::vector<Vec3> start_, x_, v_, a_, stageX_, stageV_, sumX_, sumV_;
  bool haveForce_ = false;
};

}  // namespace tyg
