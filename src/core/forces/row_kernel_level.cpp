// One precision at one vector level: compiled several times, with TYG_LEVEL and TYG_NUMBER given by the build.
#include "core/forces/row_energy.h"
#include "core/forces/row_forces.h"
#include "core/forces/row_kernel.h"

#define TYG_JOIN(level, number) kRowKernels_##level##_##number
#define TYG_KERNELS(level, number) TYG_JOIN(level, number)

namespace tyg {
namespace {

template <class T, int families>
constexpr void fillStage(RowKernels<T>& kernels) {
  kernels.stage[families][int(DampingTerm::None)] = stageRow<T, families, DampingTerm::None>;
  kernels.stage[families][int(DampingTerm::Relative)] = stageRow<T, families, DampingTerm::Relative>;
  kernels.stage[families][int(DampingTerm::Axial)] = stageRow<T, families, DampingTerm::Axial>;
}

template <class T, Update update>
constexpr void fillFinish(RowKernels<T>& kernels) {
  kernels.finish[int(update)][0] = finishForces<T, update, false>;
  kernels.finish[int(update)][1] = finishForces<T, update, true>;
}

template <class T>
constexpr RowKernels<T> allKernels() {
  RowKernels<T> kernels{};
  fillStage<T, 0>(kernels), fillStage<T, 1>(kernels), fillStage<T, 2>(kernels), fillStage<T, 3>(kernels);
  fillStage<T, 4>(kernels), fillStage<T, 5>(kernels), fillStage<T, 6>(kernels), fillStage<T, 7>(kernels);
  fillFinish<T, Update::Store>(kernels);
  fillFinish<T, Update::KickAndDrift>(kernels);
  fillFinish<T, Update::Leapfrog>(kernels);
  kernels.energy = energyOfRow<T>;
  kernels.power = powerOfRow<T>;
  return kernels;
}

}  // namespace

extern const RowKernels<TYG_NUMBER> TYG_KERNELS(TYG_LEVEL, TYG_NUMBER);
constinit const RowKernels<TYG_NUMBER> TYG_KERNELS(TYG_LEVEL, TYG_NUMBER) = allKernels<TYG_NUMBER>();

}  // namespace tyg
