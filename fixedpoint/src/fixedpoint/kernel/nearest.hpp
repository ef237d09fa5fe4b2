// SPDX-License-Identifier: MIT
// The functions of CorrectlyRounded that are computed with 32-bit cores: kernel::nearest_sin<Raw,
// F> and so on. Those of Q16.16 have kernels, which, except those of angles, call the code here if
// the core leaves the rounding undecided.
#pragma once

#include <fixedpoint/kernel/elementary.hpp>
#include <fixedpoint/kernel/power_side.hpp>
#include <fixedpoint/kernel/precise_sine.hpp>
#include <fixedpoint/kernel/short_turns.hpp>
#include <fixedpoint/portable/certain.hpp>
#include <fixedpoint/portable/correct_rounding.hpp>
#include <fixedpoint/portable/side_of_tie.hpp>

namespace fixedpoint {
namespace kernel {

// Q16.16 has some sides of its own, which are faster.
template <class Raw, int F, class Own, class Side>
using SideOf = typename Choice<portable::InQ16_16<Own>, Side, (sizeof(Raw) == 4 && F == 16)>::Type;

// Out of line, so the path that is nearly always taken does not save registers for it.
#define FIXEDPOINT_DOUBTFUL(name, Side)                                                           \
    template <class Raw, int F>                                                                   \
    FIXEDPOINT_CONSTEXPR __attribute__((noinline)) Raw doubtful_##name(Raw a) {                   \
        return portable::correctly_rounded<Raw, F, Side>(                                         \
            kernel::name<int64_t, portable::finer_fraction<F>()>(portable::finer<Raw, F>(a)), a); \
    }
#define FIXEDPOINT_SIDE(Own, Side) SideOf<Raw, F, Own, portable::side_of_tie::Side>
FIXEDPOINT_DOUBTFUL(sin, portable::side_of_tie::Sin)
FIXEDPOINT_DOUBTFUL(cos, portable::side_of_tie::Cos)
FIXEDPOINT_DOUBTFUL(atan, FIXEDPOINT_SIDE(ArcTangentSide, Atan))
FIXEDPOINT_DOUBTFUL(exp, FIXEDPOINT_SIDE(ExponentialSide, Exp))
FIXEDPOINT_DOUBTFUL(log, FIXEDPOINT_SIDE(NaturalLogarithmSide, Log))
#undef FIXEDPOINT_SIDE
#undef FIXEDPOINT_DOUBTFUL
// In Q16.16 the precise sine does not need a stage before it.
template <>
FIXEDPOINT_CONSTEXPR __attribute__((noinline)) int32_t doubtful_sin<int32_t, 16>(int32_t a) {
    return nearest_sine(a, 0);
}
template <>
FIXEDPOINT_CONSTEXPR __attribute__((noinline)) int32_t doubtful_cos<int32_t, 16>(int32_t a) {
    return nearest_sine(a, 1);
}
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR __attribute__((noinline)) Raw doubtful_atan2(Raw y, Raw x) {
    return portable::correctly_rounded<Raw, F, portable::InQ16_16<AngleSide>>(
        atan2<int64_t, 32>(portable::finer<Raw, F>(y), portable::finer<Raw, F>(x)), y, x);
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

// The functions above that the kernels of a function jump to, if it has any: name() is always true.
template <class Raw, int F, bool has_kernels = (sizeof(Raw) == 4 && F == 16)>
struct CalledByKernels {
    static constexpr bool sin() { return is_kept(decided_sine<Raw, F>); }
    static constexpr bool cos() { return is_kept(decided_sine<Raw, F>); }
    static constexpr bool exp() { return is_kept(rounded_power<Raw, F>); }
    static constexpr bool log() { return is_kept(decided_log<Raw, F>); }
};
template <class Raw, int F>
struct CalledByKernels<Raw, F, false> {
    static constexpr bool sin() { return true; }
    static constexpr bool cos() { return true; }
    static constexpr bool exp() { return true; }
    static constexpr bool log() { return true; }
};

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
