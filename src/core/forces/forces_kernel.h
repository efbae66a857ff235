// The inside of Forces: its numbers, its memory, and the loops that it has chosen. Included by its own files alone.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <thread>
#include <utility>
#include <vector>

#include "core/forces/forces.h"
#include "core/forces/masks.h"
#include "core/forces/row_kernel.h"

namespace tyg {

/// The numbers of the terms at a moment.
template <class T>
void setMoment(AllTerms::Numbers<T>& numbers, AllTerms::Moment<T>& moments, const Scene& scene, const Acting& acting,
               double time) {
  AllTerms::forEach([&]<class Term>() {
    if constexpr (requires { typename Term::template Moment<T>; }) {
      Term::template setMoment<T>(scene, acting, time, static_cast<MomentOf<Term, T>&>(moments).moment, numbers);
    }
  });
}

/// How far a group of steps has come, alone on its cache line.
struct alignas(64) Progress {
  std::atomic<int> rows{0};

  /// Another thread works on it right now: spinning is short, and gives way where threads share cores.
  void await(int wanted) const {
    for (int spin = 0; rows.load(std::memory_order_acquire) < wanted; ++spin) {
      if (spin > 1000) std::this_thread::yield();
    }
  }
};

inline constexpr int kGroup = 4;

template <class T>
struct Forces<T>::Kernel {
  explicit Kernel(Sheet ofSheet) : sheet(std::move(ofSheet)) {}

  const RowKernels<T>& kernels = rowKernels<T>();
  Sheet sheet;
  Scene scene;  // its parameters are those in use
  Acting acting;
  RowTask<T> task;  // all that does not change from call to call; its loops store the forces
  EnergyRow<T> energyRow;
  AlignedVector<T> hasRight, hasRight2, isFree;
  RowMasks<T> masks;
  AlignedVector<T> isFreeOrMoves;            // where pins move, else empty
  VectorField<T> forceOnPins;                // where pins move: scratch memory
  std::vector<AlignedVector<T>> scratch;     // per thread and step of a group
  std::vector<StoredEnergy> rowEnergies;     // per row
  std::vector<Power> rowPowers;              // W, per row
  std::vector<AllTerms::Moment<T>> moments;  // per thread and step of a group
  AllTerms::Moment<double> energyMoment;
  unsigned particleTerms = 0, blockTerms = 0, cellTerms = 0;  // that the scene has, a bit each
  bool hasPower = false;                               // whether anything takes or brings power, pins not counted
  std::vector<PushedParticle<T>> pushes;               // by row
  std::array<Progress, kMostSteps / kGroup> finished;  // rows, by each group of steps

  /// The loops that finish rows in which no push acts.
  [[nodiscard]] FinishForces<T> finish(Update update) const { return kernels.finish[int(update)][particleTerms][0]; }
  /// One row, with the pushes that act in it. Where there are none at all, nothing is looked up.
  void run(RowTask<T>& rowTask, Update update, int row, bool finishes) const {
    if (!pushes.empty()) {
      const auto first = std::ranges::lower_bound(pushes, row, {}, &PushedParticle<T>::row);
      const auto end = std::ranges::upper_bound(first, pushes.end(), row, {}, &PushedParticle<T>::row);
      rowTask.firstPush = std::to_address(first), rowTask.endPush = std::to_address(end);
      rowTask.finish = kernels.finish[int(update)][particleTerms][first == end ? 0 : 1];
    }
    rowTask.there = masks.of(row);
    (rowTask.there != nullptr ? rowTask.masked : rowTask.accumulate)(rowTask, row, finishes);
  }
  T* cleanScratch(int slot) {
    AlignedVector<T>& memory = scratch[static_cast<std::size_t>(slot)];
    std::fill(memory.begin(), memory.end(), T(0));
    return memory.data();
  }
};

}  // namespace tyg
