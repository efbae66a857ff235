// What a motion that another program made is: how wrong, which method's with which step, and which mistake it holds.
// Must not know: files, how reports look, clocks.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "study/check/trial.h"
#include "study/motion/reference.h"

namespace tyg {

/// A model, a method and a step, and how near the motion is to them.
struct Explanation {
  Model model;
  Way way;
  double dt = 0;          ///< s; 0: an adaptive method within the scene's tolerance
  double distance = 0;    ///< m, RMS over particles, the largest over the times that could be judged
  double judgedUpTo = 0;  ///< s: past it rounding errors may have grown too large to tell
  bool exact = false;     ///< as near as rounding lets two programs be that do the same
};

struct MotionCheck {
  enum class Verdict { Right, OtherMethod, Mistaken, Unexplained };

  Scene scene;  ///< up to the motion's last time
  Reference reference;
  std::vector<double> errors;     ///< m, RMS over particles, by the motion's times
  std::vector<double> explained;  ///< m: how far the explanation is, as far as it could be run
  double error = 0;               ///< E: the largest of them, m
  double size = 0;                ///< of the sheet, m
  Verdict verdict = Verdict::Unexplained;
  std::optional<Explanation> right;     ///< the nearest without a mistake
  std::optional<Explanation> mistaken;  ///< what explains the motion; only with that verdict
  double withoutMistake = 0;            ///< m: how far the same method and step are without it
  double limit = 0;                     ///< s: the largest stable step of the method found; 0 where none is known
  std::string tears;                    ///< why the last times were not judged; mostly empty
  bool stopped = false;                 ///< by the observer

  /// What explains the motion: the mistake, else the nearest method.
  [[nodiscard]] const Explanation* explanation() const;
  /// Whether the truth is as near as that: nothing then tells the method.
  [[nodiscard]] bool truthIsAsNear() const;
  /// Whether that takes steps past the method's limit.
  [[nodiscard]] bool stepIsTooLong() const;
};

struct CheckOptions {
  std::optional<double> dt;  ///< s: the step is known
  double fine = 0.01;        ///< an error up to this fraction of the size is no mistake of its own
  int threads = 0;
  std::function<bool(double fraction)> observer;  ///< gets the fraction done; false: stop. May be empty
};
/// Throws InputError where there is no exact motion to compare with, or no time of the motion is on steps of `dt`.
MotionCheck checkMotion(const Scene& scene, const GivenMotion& motion, const CheckOptions& options);

/// One sentence or two for the student.
std::string verdictWords(const MotionCheck& check);
/// What a script reads as the mistake; empty where there is none.
std::string mistakeName(const MotionCheck& check);

}  // namespace tyg
