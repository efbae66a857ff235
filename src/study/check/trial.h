// One try at a motion that was handed in: a model, a method and a step, run to the motion's times, and how far apart
// the two are. Must not know: which tries are worth while.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "study/check/mistakes.h"
#include "study/check/motion_rows.h"
#include "tyg/method.h"

namespace tyg {

/// A method of Tyg or of the student's kind; one of the two.
struct Way {
  const Method* method = nullptr;
  const StudentMethod* student = nullptr;

  [[nodiscard]] std::string_view name() const { return method != nullptr ? method->name : student->name; }
  [[nodiscard]] bool adaptive() const { return method != nullptr && method->adaptive; }
  [[nodiscard]] int order() const { return method != nullptr ? method->order : student->order; }
  /// Whether it is one of Tyg's, whoever runs it.
  [[nodiscard]] bool known() const { return method != nullptr || student->known; }
};

struct Trial {
  const Model* model = nullptr;
  Way way;
  double dt = 0;  ///< s; of adaptive methods 0: they choose their steps within the scene's tolerance
};

/// The distances (m, RMS over particles) of a try from the motion, sample by sample, as far as it was followed.
struct Fit {
  std::vector<double> distances;
  /// How many times as far apart two runs that started beside each other are by then; empty where no twin was run.
  std::vector<double> amplification;
  std::vector<Vec3> last;  ///< m, where the try's particles were at the last sample
  bool stopped = false;    ///< by the observer

  /// Largest so far; infinite where the try ended before.
  [[nodiscard]] double upTo(std::size_t samples) const;
};

struct FitOptions {
  std::size_t samples = 0;                                  ///< of the motion, so many are compared
  double enough = std::numeric_limits<double>::infinity();  ///< m: past this distance the rest is not run
  bool twin = false;                                        ///< find out the amplification too, at twice the cost
  std::function<bool()> goesOn{};                           ///< asked now and then; false: stop
};
/// Throws nothing where the method does not take the model: the fit is then empty.
Fit fitOf(const Trial& trial, const GivenMotion& motion, const FitOptions& options);

/// How many of a motion's samples a try is run to at first: until the sheet has moved, and not more than a third of
/// all.
std::size_t firstSamples(const GivenMotion& motion, const Scene& scene);

/// About how much the try costs to the motion's sample `samples`, in evaluations of one spring.
double costOf(const Trial& trial, const GivenMotion& motion, std::size_t samples);

/// Whether all methods are meant, or those that students write alone.
enum class Breadth { Students, All };
/// The ways in which a model can be run: by Tyg's methods, or where that is faster by the student's program, which also
/// has methods that Tyg has not; where the model has habits, by the methods for which these make a difference.
std::vector<Way> waysOf(const Model& model, Breadth breadth);

}  // namespace tyg
