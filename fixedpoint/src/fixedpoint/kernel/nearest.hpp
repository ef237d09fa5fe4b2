// SPDX-License-Identifier: MIT
// The functions of CorrectlyRounded that are computed with 32-bit cores: kernel::nearest_sin<Raw,
// F> and so on. Those of Q16.16 have kernels, which, except those of angles, call the code here if
// the core leaves the rounding undecided.
#pragma once

#include <fixedpoint/kernel/power_side.hpp>
#include <fixedpoint/kernel/precise_sine.hpp>
#include <fixedpoint/kernel/short_turns.hpp>
#include <fixedpoint/portable/certain.hpp>
#include <fixedpoint/portable/correct_rounding.hpp>

namespace fixedpoint {
namespace kernel {

// Out of line, so the path that is nearly always taken does not save registers for it.
#define FIXEDPOINT_DOUBTFUL(name, Side, at_once)                                      \
    template <class Raw, int F>                                                       \
    FIXEDPOINT_CONSTEXPR __attribute__((noinline)) Raw doubtful_##name(Raw a) {       \
        return at_once portable::correctly_rounded<Raw, F, Side>(                     \
            kernel::name<int64_t, 32>(portable::convert<int64_t, 32, Raw, F>(a)), a); \
    }
// In Q16.16 the precise sine does not need a stage before it.
FIXEDPOINT_DOUBTFUL(sin, SineSide, F == 16 ? static_cast<Raw>(nearest_sine(a, 0)) :)
FIXEDPOINT_DOUBTFUL(cos, CosineSide, F == 16 ? static_cast<Raw>(nearest_sine(a, 1)) :)
FIXEDPOINT_DOUBTFUL(atan, ArcTangentSide, )
FIXEDPOINT_DOUBTFUL(exp, ExponentialSide, )
FIXEDPOINT_DOUBTFUL(log, NaturalLogarithmSide, )
#undef FIXEDPOINT_DOUBTFUL
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR __attribute__((noinline)) Raw doubtful_atan2(Raw y, Raw x) {
    return portable::correctly_rounded<Raw, F, AngleSide>(
        atan2<int64_t, 32>(portable::convert<int64_t, 32, Raw, F>(y),
                           portable::convert<int64_t, 32, Raw, F>(x)),
        y, x);
}

// `above` and `above` - 1 are the numbers adjacent to the logarithm.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR FIXEDPOINT_CALLED_BY_KERNEL Raw decided_log(Raw a, Raw above) {
    const int64_t tie = static_cast<int64_t>(above) * 65536 - 32768;
    return NaturalLogarithmSide::reaches(tie, a) ? above : static_cast<Raw>(above - 1);
}
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR FIXEDPOINT_CALLED_BY_KERNEL Raw decided_sine(Raw a, uint8_t turned) {
    return static_cast<Raw>(nearest_sine(a, turned));
}

}  // namespace kernel

#define FIXEDPOINT_NEAREST(shape, name)                                           \
    namespace portable {                                                          \
    template <class Raw, int F>                                                   \
    FIXEDPOINT_CONSTEXPR Raw nearest_##name FIXEDPOINT_PARAMETERS_##shape(Raw) {  \
        const Raw certain = certain_##name<Raw, F> FIXEDPOINT_ARGUMENTS_##shape;  \
        return certain != RawLimits<Raw>::min ? certain                           \
                                              : kernel::doubtful_##name<Raw, F>   \
                                                    FIXEDPOINT_ARGUMENTS_##shape; \
    }                                                                             \
    }                                                                             \
    namespace kernel {                                                            \
    template <class Raw, int F>                                                   \
    FIXEDPOINT_CONSTEXPR Raw nearest_##name FIXEDPOINT_PARAMETERS_##shape(Raw) {  \
        return portable::nearest_##name<Raw, F> FIXEDPOINT_ARGUMENTS_##shape;     \
    }                                                                             \
    }
FIXEDPOINT_NEAREST(UNARY, sin)
FIXEDPOINT_NEAREST(UNARY, cos)
FIXEDPOINT_NEAREST(UNARY, atan)
FIXEDPOINT_NEAREST(UNARY, exp)
FIXEDPOINT_NEAREST(UNARY, log)
FIXEDPOINT_NEAREST(BINARY, atan2)
#undef FIXEDPOINT_NEAREST

}  // namespace fixedpoint

FIXEDPOINT_ROUNDED_KERNELS(FIXEDPOINT_DISPATCH)
FIXEDPOINT_ROUNDED_ANGLE_KERNELS(FIXEDPOINT_DISPATCH)
