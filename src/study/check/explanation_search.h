// The search for what a motion is: many tries at its first times, few of them to its end. It comes to the same result
// whatever the number of threads: tries are run ahead on all of them, and judged one after the other.
// Must not know: references, words, clocks.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "study/check/motion_check.h"
#include "study/check/step_aim.h"
#include "study/check/trial_threads.h"

namespace tyg {

class ExplanationSearch {
 public:
  /// `step` (s): the only one to try, if any. `goesOn` is asked now and then with the fraction of the effort spent.
  ExplanationSearch(const Scene& scene, const GivenMotion& motion, std::optional<double> step, int threads,
                    std::function<bool(double)> goesOn);

  /// What right methods come to at the steps that are likely: the nearest one, exact or not. Nothing where the times
  /// fit no step.
  std::optional<Explanation> right();
  /// The right method at any other step that the motion fits exactly: where no mistake explains it either.
  std::optional<Explanation> rightAtAnyStep();
  /// The mistake, or the pair of mistakes, with which the motion fits exactly, else the nearest one that was tried to
  /// the end. `fromTruth`: m, how far the motion is from the truth at its first and at all times.
  std::optional<Explanation> mistaken(double fromTruth);
  /// m, by the motion's times, as far as it can be run: how far the motion is from an explanation.
  std::vector<double> distances(const Explanation& of) { return distances(of.model, of); }
  /// The same method and step as an explanation's without its mistakes, m.
  double withoutMistake(const Explanation& of);

  [[nodiscard]] bool stopped() const { return threads_.stopped(); }
  /// The first times, which most tries are run to.
  [[nodiscard]] std::size_t first() const { return first_; }

 private:
  struct Tried {
    Trial trial;
    double distance = 0;  // m, at the first times
  };
  /// What came out of a try at the first times, or nothing where it would have been beyond the effort anyway.
  struct Run {
    double distance;      // m; infinite where it ended before, or was far enough
    std::size_t sampled;  // times
  };
  struct Judgement {
    Explanation of;
    double cost = 0;
  };
  using Steps = std::vector<double>;

  bool spend(double cost);
  [[nodiscard]] bool isOver() const { return threads_.stopped() || spent_ > most_; }
  [[nodiscard]] double near() const;
  [[nodiscard]] double unamplified(std::size_t sample) const;
  [[nodiscard]] std::optional<Trial> accurate(const Model& model) const;
  [[nodiscard]] std::vector<Trial> trialsOf(const Model& model, Breadth breadth, const Steps& steps) const;
  std::vector<Run> runAll(std::span<const Trial> trials, double enough);
  double accounted(const Trial& trial, const Run& run);
  void tryAll(std::span<const Trial> trials, double enough, std::vector<Tried>& tried);
  std::vector<double> distances(const Model& model, const Explanation& of);
  Explanation simplest(const Explanation& found);
  Explanation nearestStep(const Explanation& found);
  std::optional<Explanation> nearestOf(std::vector<Tried>& tried);
  std::optional<Explanation> exactOf(std::vector<Tried>& tried);
  Judgement judged(const Trial& trial);
  std::vector<Explanation> judgedFirst(std::span<const Tried> tried, std::size_t count);
  std::vector<Model> ranked(std::vector<Model> models, double atMost);
  [[nodiscard]] std::vector<Model> pairs() const;
  std::vector<StepAim> aims(std::span<const Model> models);
  [[nodiscard]] std::vector<Trial> trialsAround(std::span<const StepAim> aims) const;
  std::optional<Explanation> searchByAim(std::span<const Model> models);
  std::optional<Explanation> search(const std::vector<Model>& models, const Steps& steps);

  const GivenMotion& motion_;
  Model plain_;
  Steps all_, likely_, others_;  // s
  TrialThreads threads_;
  std::size_t first_ = 1;
  double size_, spent_ = 0, most_ = 0;
  std::vector<Model> singles_, pairs_;
};

}  // namespace tyg
