// One precision at one vector level: compiled several times, with TYG_LEVEL and TYG_NUMBER given by the build.
#include "core/forces/row_energy.h"
#include "core/forces/row_forces.h"
#include "core/forces/row_kernel.h"

#define TYG_JOIN(level, number) kRowKernels_##level##_##number
#define TYG_KERNELS(level, number) TYG_JOIN(level, number)

namespace tyg {
namespace {

/// Every combination has loops of its own, but for rare ones beside terms of cells: these take the loops of the next
/// larger combination, in which the springs that are missing have no stiffness. That halves the time of compiling.
constexpr int familiesOfLoop(int families, unsigned cellTerms) {
  if (cellTerms == 0 || families < 2 || families == 3) return families;
  return families < 4 ? 3 : 7;
}

template <class T, int families, unsigned cellTerms>
constexpr void fillAccumulate(RowKernels<T>& kernels) {
  using Terms = typename ChosenTerms<TermPlace::Cells, cellTerms, AllTerms>::Type;
  AccumulateRow<T>(&byDamping)[3] = kernels.accumulate[cellTerms][families];
  constexpr int kFamilies = familiesOfLoop(families, cellTerms);
  byDamping[int(DampingTerm::None)] = accumulateRow<T, kFamilies, DampingTerm::None, Terms, false>;
  byDamping[int(DampingTerm::Relative)] = accumulateRow<T, kFamilies, DampingTerm::Relative, Terms, false>;
  byDamping[int(DampingTerm::Axial)] = accumulateRow<T, kFamilies, DampingTerm::Axial, Terms, false>;
  // Rows of which something is gone leave to their neighbours what the same families leave, but may have structural
  // springs besides.
  AccumulateRow<T>(&masked)[3] = kernels.masked[cellTerms][families];
  constexpr int kMasked = kFamilies == 0 ? 0 : kFamilies | kStructural;
  masked[int(DampingTerm::None)] = accumulateRow<T, kMasked, DampingTerm::None, Terms, true>;
  masked[int(DampingTerm::Relative)] = accumulateRow<T, kMasked, DampingTerm::Relative, Terms, true>;
  masked[int(DampingTerm::Axial)] = accumulateRow<T, kMasked, DampingTerm::Axial, Terms, true>;
}
template <class T, unsigned... cellTerms>
constexpr void fillAllAccumulate(RowKernels<T>& kernels, std::integer_sequence<unsigned, cellTerms...> /*subsets*/) {
  (fillAccumulate<T, 0, cellTerms>(kernels), ...), (fillAccumulate<T, 1, cellTerms>(kernels), ...);
  (fillAccumulate<T, 2, cellTerms>(kernels), ...), (fillAccumulate<T, 3, cellTerms>(kernels), ...);
  (fillAccumulate<T, 4, cellTerms>(kernels), ...), (fillAccumulate<T, 5, cellTerms>(kernels), ...);
  (fillAccumulate<T, 6, cellTerms>(kernels), ...), (fillAccumulate<T, 7, cellTerms>(kernels), ...);
}

template <class T, Update update, unsigned terms>
constexpr void fillFinish(RowKernels<T>& kernels) {
  using Terms = typename ChosenTerms<TermPlace::Particles, terms, AllTerms>::Type;
  kernels.finish[int(update)][terms][0] = finishForces<T, update, Terms, false>;
  kernels.finish[int(update)][terms][1] = finishForces<T, update, Terms, true>;
}
template <class T, unsigned... terms>
constexpr void fillAllFinish(RowKernels<T>& kernels, std::integer_sequence<unsigned, terms...> /*subsets*/) {
  (fillFinish<T, Update::Store, terms>(kernels), ...);
  (fillFinish<T, Update::KickAndDrift, terms>(kernels), ...);
  (fillFinish<T, Update::Leapfrog, terms>(kernels), ...);
}

template <class T, unsigned terms>
constexpr AddToBlock<T> addToBlockOf() {
  using Terms = typename ChosenTerms<TermPlace::Blocks, terms, AllTerms>::Type;
  if constexpr (Terms::kEmpty) {
    return nullptr;
  } else {
    return addToBlock<T, Terms>;
  }
}
template <class T, unsigned... terms>
constexpr void fillAllAddToBlock(RowKernels<T>& kernels, std::integer_sequence<unsigned, terms...> /*subsets*/) {
  ((kernels.addToBlock[terms] = addToBlockOf<T, terms>()), ...);
}

template <class T>
constexpr RowKernels<T> allKernels() {
  RowKernels<T> kernels{};
  fillAllAccumulate(kernels, std::make_integer_sequence<unsigned, subsetsOf(TermPlace::Cells)>{});
  fillAllFinish(kernels, std::make_integer_sequence<unsigned, subsetsOf(TermPlace::Particles)>{});
  fillAllAddToBlock(kernels, std::make_integer_sequence<unsigned, subsetsOf(TermPlace::Blocks)>{});
  kernels.energy = energyOfRow<T>;
  kernels.power = powerOfRow<T>;
  return kernels;
}

}  // namespace

extern const RowKernels<TYG_NUMBER> TYG_KERNELS(TYG_LEVEL, TYG_NUMBER);
constinit const RowKernels<TYG_NUMBER> TYG_KERNELS(TYG_LEVEL, TYG_NUMBER) = allKernels<TYG_NUMBER>();

}  // namespace tyg
