// Steps that are one pass over the rows: forces, kick and drift at once, several steps after each other.
#include <algorithm>
#include <array>

#include "core/forces/forces_kernel.h"
#include "util/workers.h"

namespace tyg {

template <class T>
void Forces<T>::kickAndDrift(State<T>& state, double h, const StepTimes& times, int count) {
  RowTask<T> task = kernel_->task;
  task.finish = kernel_->finish(Update::KickAndDrift);
  task.velocity = state.velocity.x();
  task.kick = T(h * inverseMass_);
  advance(task, Update::KickAndDrift, state, h, count, [&](int step) { return times.at(step); });
}

template <class T>
void Forces<T>::leapfrog(State<T>& state, VectorField<T>& predicted, const StepTimes& times, int count) {
  const double h = times.h;
  RowTask<T> task = kernel_->task;
  task.finish = kernel_->finish(Update::Leapfrog);
  task.velocity = task.seen = predicted.x();
  task.kick = T(h / 2 * inverseMass_);
  advance(task, Update::Leapfrog, state, h, count, [&](int step) { return times.at(step) + h; });
}

/// Steps follow each other down the sheet: a step may finish a row once the step before has finished the two below it.
/// Steps in groups of kGroup stay within one thread's cache; groups are dealt out to the threads in turn.
template <class T>
template <class Task, class TimeOf>
void Forces<T>::advance(Task task, Update update, State<T>& state, double h, int count, TimeOf timeOf) {
  Kernel& k = *kernel_;
  task.position = task.moving = state.position.x();
  task.kicked = state.velocity.x();
  task.step = T(h);
  account_.evaluations += count;
  const int rows = layout_.rows, groups = (count + kGroup - 1) / kGroup;
  for (int group = 0; group < groups; ++group) k.finished[std::size_t(group)].rows.store(0, std::memory_order_relaxed);
  workers_.forBands(workers_.threads(), [&](int first, int, int thread) {
    for (int group = first; group < groups; group += workers_.threads()) {
      const int steps = std::min(kGroup, count - group * kGroup), lag = 2 * (steps - 1);
      std::array<RowTask<T>, kGroup> tasks;
      for (int step = 0; step < steps; ++step) {
        tasks[std::size_t(step)] = task;
        tasks[std::size_t(step)].scratch = k.cleanScratch(thread * kGroup + step);
        setMoment<T>(tasks[std::size_t(step)], k.moments[std::size_t(thread * kGroup + step)], k.scene, k.acting,
                     timeOf(group * kGroup + step));
      }
      for (int front = 0; front < rows + lag; ++front) {
        if (group > 0) k.finished[std::size_t(group - 1)].await(std::min(front + 3, rows));
        for (int step = 0; step < steps; ++step) {
          const int row = front - 2 * step;
          if (row >= 0 && row < rows) k.run(tasks[std::size_t(step)], update, row, true);
        }
        k.finished[std::size_t(group)].rows.store(front - lag + 1, std::memory_order_release);
      }
    }
  });
}

template void Forces<float>::kickAndDrift(State<float>&, double, const StepTimes&, int);
template void Forces<double>::kickAndDrift(State<double>&, double, const StepTimes&, int);
template void Forces<float>::leapfrog(State<float>&, VectorField<float>&, const StepTimes&, int);
template void Forces<double>::leapfrog(State<double>&, VectorField<double>&, const StepTimes&, int);

}  // namespace tyg
