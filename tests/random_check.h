// A random small cloth, run by the program of own_program.h with random mistakes, method, step and printing, and what
// the check says of it. For tests and statistics.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "own_program.h"
#include "random_cloth.h"
#include "study/check/motion_check.h"
#include "study/limits/stability.h"
#include "tyg/methods.h"

namespace tyg::test {

struct RandomCheck {
  std::string what, said;
  bool named = false;    ///< the mistakes, or that there are none
  bool accused = false;  ///< of a mistake, where there is none
};

inline MotionCheck checkedText(const Scene& scene, const std::string& text) {
  return checkMotion(scene, readMotion(text, "motion.csv", scene), {.dt = {}, .threads = 1, .observer = {}});
}

/// A cloth of 3 to 6 particles a side that swings from two corners, without and with a push.
inline Scene smallCloth(Numbers& numbers) {
  Scene scene = emptyWorld(int(numbers.between(3, 7)), int(numbers.between(3, 7)));
  scene.name = "small cloth";
  scene.spacing = logBetween(numbers, 0.05, 0.2);
  scene.particleMass = logBetween(numbers, 5e-3, 0.05);
  scene.start = Start::Flat;
  scene.gravity = {0, -9.81, 0};
  const double ks = logBetween(numbers, 30, 300) * scene.particleMass * 9.81 * 6 / scene.spacing;
  const double kd = std::sqrt(8 * ks * scene.particleMass) / 8 * logBetween(numbers, 0.03, 0.3);
  scene.structural = {ks, kd};
  scene.shear = {ks * numbers.between(0.3, 1), kd};
  scene.bend = {ks * numbers.between(0.1, 0.4), kd * numbers.between(0.3, 1)};
  scene.damping = numbers.coin() ? Damping::Relative : Damping::Axial;
  if (numbers.coin()) scene.drag = scene.particleMass * numbers.between(0.05, 0.5);
  scene.pins = {{"top-left"}, {"top-right"}};
  return scene;
}

/// The mistakes that make a difference to this scene with this method.
inline std::vector<const Mistake*> possibleMistakes(const Scene& scene, const std::string& method) {
  std::vector<const Mistake*> possible;
  const bool stages = method != "explicit-euler" && method != "symplectic-euler" && method != "position-first Euler";
  for (const Mistake& mistake : mistakes()) {
    const std::string name(mistake.name);
    const bool needsStages = name == "forces kept stale across stages" || name == "pins held only after the step";
    if (needsStages && !stages) continue;
    // These move pins with the velocity that the step before has taken from them.
    if (name == "pinned after the position was moved" && (method == "explicit-euler" || method.starts_with("position")))
      continue;
    if (!withMistake({.scene = scene, .habits = {}, .made = {}}, mistake).made.empty()) possible.push_back(&mistake);
  }
  return possible;
}

inline RandomCheck randomCheck(unsigned seed, int count) {
  Numbers numbers(seed);
  for (int k = 0; k < 20; ++k) numbers.coin();
  Scene scene = smallCloth(numbers);
  const std::vector<std::string> methods = {"explicit-euler", "symplectic-euler",     "leapfrog", "rk4",
                                            "heun",           "position-first Euler", "midpoint"};
  const std::string method = methods[std::size_t(numbers.between(0, double(methods.size())))];
  const char* format = numbers.coin() ? "%.17g" : numbers.coin() ? "%.9f" : "%.6g";

  std::vector<const Mistake*> possible = possibleMistakes(scene, method), made;
  while (int(made.size()) < count) {
    const Mistake* one = possible[std::size_t(numbers.between(0, double(possible.size())))];
    if (std::ranges::none_of(made, [&](const Mistake* other) { return other->kind == one->kind; })) made.push_back(one);
  }
  std::ranges::sort(made);
  Model model{.scene = scene, .habits = {}, .made = {}};
  for (const Mistake* one : made) model = withMistake(model, *one);
  const Method& euler = findMethod("symplectic-euler");
  double h = 0.5 * std::min(unboundedLimit(scene, euler), unboundedLimit(model.scene, euler)) *
             (method == "explicit-euler" ? 0.2 : 1);
  for (const double usual : {5e-3, 4e-3, 2.5e-3, 2e-3, 1e-3, 5e-4, 4e-4, 2.5e-4, 2e-4, 1e-4, 5e-5, 2e-5, 1e-5}) {
    if (usual < h) {
      h = usual;
      break;
    }
  }
  const int steps = 240, every = numbers.coin() ? 1 : numbers.coin() ? 4 : 20;
  scene.duration = steps * h, scene.dt = 1e-3;
  if (numbers.coin()) scene.pushes = {{{"middle"}, numbers.inCube(0.5), 40 * h, 80 * h}};
  std::vector<std::string> names;
  RandomCheck result;
  std::string expected;
  for (const Mistake* one : made) {
    names.emplace_back(one->name);
    expected += (expected.empty() ? "" : " and ") + names.back();
  }
  char settings[100];
  std::snprintf(settings, sizeof settings, " by %s at %g, every %d, %s, %dx%d", method.c_str(), h, every, format,
                scene.columns, scene.rows);
  result.what = (expected.empty() ? "right" : expected) + settings;
  try {
    const MotionCheck check = checkedText(scene, ownRows(OwnProgram(scene, names, method, h), h, steps, every, format));
    result.said = mistakeName(check) + " | " + verdictWords(check);
    result.named = mistakeName(check) == expected && (count > 0 || check.verdict == MotionCheck::Verdict::Right ||
                                                      check.verdict == MotionCheck::Verdict::OtherMethod);
    result.accused = count == 0 && !mistakeName(check).empty();
  } catch (const InputError& error) {
    result.said = error.what();
  }
  return result;
}

}  // namespace tyg::test
