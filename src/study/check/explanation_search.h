// The search for what a motion is: many tries at its first times, few of them to its end.
// Must not know: references, words, clocks.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "study/check/motion_check.h"

namespace tyg {

class ExplanationSearch {
 public:
  /// `step` (s): the only one to try, if any. `goesOn` is asked now and then with the fraction of the effort spent.
  ExplanationSearch(const Scene& scene, const GivenMotion& motion, std::optional<double> step,
                    std::function<bool(double)> goesOn);

  /// What right methods come to at the steps that are likely: the nearest one, exact or not. Nothing where the times
  /// fit no step.
  std::optional<Explanation> right();
  /// The right method at any other step that the motion fits exactly: where no mistake explains it either.
  std::optional<Explanation> rightAtAnyStep();
  /// The mistake, or the pair of mistakes, with which the motion fits exactly, else the nearest one that was tried to
  /// the end. `fromTruth`: m, how far the motion is from the truth at its first and at all times.
  std::optional<Explanation> mistaken(double fromTruth);
  /// The same method and step as an explanation's without its mistakes, m.
  double withoutMistake(const Explanation& of);

  [[nodiscard]] bool stopped() const { return stopped_; }
  /// The first times, which most tries are run to.
  [[nodiscard]] std::size_t first() const { return first_; }

 private:
  struct Tried {
    const Model* model = nullptr;
    Trial trial;
    double distance = 0;  // m, at the first times
  };
  /// A model and a method, and the step at which they would be nearest.
  struct Aim {
    const Model* model = nullptr;
    Way way;
    double dt = 0;      // s
    double missed = 0;  // what would be left of the distance there, as a fraction
  };
  using Steps = std::vector<double>;

  bool spend(double cost);
  double distanceOf(const Trial& trial, std::size_t samples, double enough);
  [[nodiscard]] double near() const;
  [[nodiscard]] double unamplified(std::size_t sample) const;
  [[nodiscard]] std::optional<Trial> accurate(const Model& model) const;
  void tryAll(const Model& model, Breadth breadth, const Steps& steps, double enough, std::vector<Tried>& tried);
  Explanation oneOfTwo(const Explanation& found);
  Explanation nearestStep(const Explanation& found);
  std::optional<Explanation> nearestOf(std::vector<Tried>& tried);
  std::optional<Explanation> exactOf(std::vector<Tried>& tried);
  Explanation judged(const Trial& trial);
  std::vector<Model> ranked(std::vector<Model> models, double atMost);
  [[nodiscard]] std::vector<Model> pairs() const;
  std::optional<Aim> aimed(const Model& model, const Way& way);
  void tryAround(const Aim& aim, double enough, std::vector<Tried>& tried);
  std::optional<Explanation> searchByAim(std::span<const Model> models);
  std::optional<Explanation> search(const std::vector<Model>& models, const Steps& steps);

  const GivenMotion& motion_;
  Model plain_;
  Steps all_, likely_, others_;  // s
  std::function<bool(double)> goesOn_;
  std::size_t first_ = 1;
  double size_, spent_ = 0, most_ = 0;
  bool stopped_ = false;
  std::vector<Model> singles_, pairs_;
};

}  // namespace tyg
