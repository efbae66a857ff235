// One precision at one vector level: compiled several times, with TYG_LEVEL and TYG_NUMBER given by the build.
#include "core/row_energy.h"
#include "core/row_forces.h"
#include "core/row_kernel.h"

#define TYG_JOIN(level, number) kRowKernels_##level##_##number
#define TYG_KERNELS(level, number) TYG_JOIN(level, number)

namespace tyg {
namespace {

template <class T, int families, Update update>
constexpr void fillUpdate(RowKernels<T>& kernels) {
  kernels.finish[families][int(update)][0] = finishForces<T, families, update, false>;
  kernels.finish[families][int(update)][1] = finishForces<T, families, update, true>;
}

template <class T, int families>
constexpr void fill(RowKernels<T>& kernels) {
  kernels.stage[families][int(DampingTerm::None)] = stageSprings<T, families, DampingTerm::None>;
  kernels.stage[families][int(DampingTerm::Relative)] = stageSprings<T, families, DampingTerm::Relative>;
  kernels.stage[families][int(DampingTerm::Axial)] = stageSprings<T, families, DampingTerm::Axial>;
  fillUpdate<T, families, Update::Store>(kernels);
  fillUpdate<T, families, Update::KickAndDrift>(kernels);
  fillUpdate<T, families, Update::Leapfrog>(kernels);
}

template <class T>
constexpr RowKernels<T> allKernels() {
  RowKernels<T> kernels{};
  fill<T, 0>(kernels), fill<T, 1>(kernels), fill<T, 2>(kernels), fill<T, 3>(kernels);
  fill<T, 4>(kernels), fill<T, 5>(kernels), fill<T, 6>(kernels), fill<T, 7>(kernels);
  kernels.row = stageAndFinishRow<T>;
  kernels.energy = energyOfRow<T>;
  kernels.power = powerOfRow<T>;
  return kernels;
}

}  // namespace

extern const RowKernels<TYG_NUMBER> TYG_KERNELS(TYG_LEVEL, TYG_NUMBER);
constinit const RowKernels<TYG_NUMBER> TYG_KERNELS(TYG_LEVEL, TYG_NUMBER) = allKernels<TYG_NUMBER>();

}  // namespace tyg
