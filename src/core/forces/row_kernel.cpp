// Chooses among the compiled vector levels.
#include "core/forces/row_kernel.h"

namespace tyg {

#define TYG_DECLARE(level)                                    \
  extern const RowKernels<float> kRowKernels_##level##_float; \
  extern const RowKernels<double> kRowKernels_##level##_double;
TYG_DECLARE(baseline)
#if TYG_X86_LEVELS
TYG_DECLARE(v3)
TYG_DECLARE(v4)
#endif
#undef TYG_DECLARE

namespace {
std::optional<VectorLevel>& levelAskedFor() {
  static std::optional<VectorLevel> level;
  return level;
}
}  // namespace

VectorLevel bestVectorLevel() {
#if TYG_X86_LEVELS
  const bool v3 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi") &&
                  __builtin_cpu_supports("bmi2");
  const bool v4 = v3 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                  __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
                  __builtin_cpu_supports("avx512vl");
  if (v4) return VectorLevel::V4;
  if (v3) return VectorLevel::V3;
#endif
  return VectorLevel::Baseline;
}

void useVectorLevel(std::optional<VectorLevel> level) { levelAskedFor() = level; }

#if TYG_X86_LEVELS
#define TYG_CHOOSE(number)                                                                                        \
  template <>                                                                                                     \
  const RowKernels<number>& rowKernels() {                                                                        \
    static const RowKernels<number>* const kLevels[] = {&kRowKernels_baseline_##number, &kRowKernels_v3_##number, \
                                                        &kRowKernels_v4_##number};                                \
    return *kLevels[int(levelAskedFor().value_or(bestVectorLevel()))];                                            \
  }
#else
#define TYG_CHOOSE(number)                 \
  template <>                              \
  const RowKernels<number>& rowKernels() { \
    return kRowKernels_baseline_##number;  \
  }
#endif
TYG_CHOOSE(float)
TYG_CHOOSE(double)
#undef TYG_CHOOSE

}  // namespace tyg
