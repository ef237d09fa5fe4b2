// SPDX-License-Identifier: MIT
/// \file
/// CorrectlyRounded: as Nearest, but functions too return the exact result rounded to nearest, half
/// up, so that a result does not depend on the algorithm that made it. In Q16.16 they compute with
/// cores of 32 bits, where those leave a doubt in Q32.32, and further where that lies on a tie;
/// sine and cosine go that far at once. Only for formats whose numbers all are numbers of Q16.16,
/// such as Q4.4 and Q8.8. Functions of turns and degrees and integer powers are Nearest's.
#pragma once

#include <fixedpoint/arithmetic/nearest.hpp>
#include <fixedpoint/kernel/power_side.hpp>
#include <fixedpoint/kernel/precise_sine.hpp>
#include <fixedpoint/kernel/short_turns.hpp>
#include <fixedpoint/portable/correct_rounding.hpp>

namespace fixedpoint {

/// As Nearest, with functions whose error is 0.5 ulp at most.
struct CorrectlyRounded : Nearest {
    /// \cond internal
    // What a core of 32 bits leaves in doubt is out of line, so that nothing is saved for it on the
    // way that is nearly always taken.
#define FIXEDPOINT_CORRECTLY_ROUNDED(name, Side)                                       \
    template <class Raw, int F>                                                        \
    static FIXEDPOINT_CONSTEXPR __attribute__((noinline)) Raw doubtful_##name(Raw a) { \
        return portable::correctly_rounded<Raw, F, Side>(                              \
            kernel::name<int64_t, 32>(portable::convert<int64_t, 32, Raw, F>(a)), a);  \
    }                                                                                  \
    template <class Raw, int F>                                                        \
    static FIXEDPOINT_CONSTEXPR Raw name(Raw a) {                                      \
        const Raw certain = kernel::certain_##name<Raw, F>(a);                         \
        return certain != RawLimits<Raw>::min ? certain : doubtful_##name<Raw, F>(a);  \
    }
    FIXEDPOINT_CORRECTLY_ROUNDED(sin, kernel::SineSide)
    FIXEDPOINT_CORRECTLY_ROUNDED(cos, kernel::CosineSide)
    FIXEDPOINT_CORRECTLY_ROUNDED(atan, kernel::ArcTangentSide)
    FIXEDPOINT_CORRECTLY_ROUNDED(exp, kernel::ExponentialSide)
    FIXEDPOINT_CORRECTLY_ROUNDED(log, kernel::NaturalLogarithmSide)
#undef FIXEDPOINT_CORRECTLY_ROUNDED
#define FIXEDPOINT_CORRECTLY_ROUNDED(name, Function, ...)              \
    template <class Raw, int F, class... Operands>                     \
    static constexpr Raw name(Operands... a) {                         \
        return portable::correctly_rounded<Raw, F, __VA_ARGS__>(       \
            portable::Evaluated<kernel::Function, int64_t, 32>::apply( \
                portable::convert<int64_t, 32, Raw, F>(a)...)          \
                .number,                                               \
            a...);                                                     \
    }
    FIXEDPOINT_CORRECTLY_ROUNDED(tan, Tan, portable::TangentSide)
    FIXEDPOINT_CORRECTLY_ROUNDED(asin, Asin, portable::WideSide<portable::Asin>)
    FIXEDPOINT_CORRECTLY_ROUNDED(acos, Acos, portable::WideSide<portable::Acos>)
    FIXEDPOINT_CORRECTLY_ROUNDED(exp2, Exp2, portable::WideSide<portable::Exp2>)
    FIXEDPOINT_CORRECTLY_ROUNDED(expm1, Expm1, portable::WideSide<portable::Expm1>)
    FIXEDPOINT_CORRECTLY_ROUNDED(log2, Log2, portable::Log2Side)
    FIXEDPOINT_CORRECTLY_ROUNDED(log10, Log10, portable::Log10Side)
    FIXEDPOINT_CORRECTLY_ROUNDED(log1p, Log1p, kernel::Log1pSide)
    FIXEDPOINT_CORRECTLY_ROUNDED(sinh, Sinh, portable::WideSide<portable::Sinh>)
    FIXEDPOINT_CORRECTLY_ROUNDED(cosh, Cosh, portable::WideSide<portable::Cosh>)
    FIXEDPOINT_CORRECTLY_ROUNDED(tanh, Tanh, portable::WideSide<portable::Tanh>)
    FIXEDPOINT_CORRECTLY_ROUNDED(cbrt, Cbrt, portable::CubeRootSide)
    FIXEDPOINT_CORRECTLY_ROUNDED(pow, Pow, portable::WideSide<portable::Pow>)
#undef FIXEDPOINT_CORRECTLY_ROUNDED
    template <class Raw, int F>
    static constexpr Raw reciprocal_sqrt(Raw a) {
        return kernel::nearest_reciprocal_sqrt<Raw, F>(a);
    }
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR __attribute__((noinline)) Raw doubtful_atan2(Raw y, Raw x) {
        return portable::correctly_rounded<Raw, F, kernel::AngleSide>(
            kernel::atan2<int64_t, 32>(portable::convert<int64_t, 32, Raw, F>(y),
                                       portable::convert<int64_t, 32, Raw, F>(x)),
            y, x);
    }
    /// \endcond
    /// The angle of (x, y) in (-pi, pi]; 0 where both are 0.
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR Raw atan2(Raw y, Raw x) {
        const Raw certain = kernel::certain_atan2<Raw, F>(y, x);
        return certain != RawLimits<Raw>::min ? certain : doubtful_atan2<Raw, F>(y, x);
    }
    /// The sine and the cosine of an angle in radians.
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR void sincos(Raw angle, Raw* sine_and_cosine) {
        kernel::certain_sincos<Raw, F>(angle, sine_and_cosine);
        if (sine_and_cosine[0] == RawLimits<Raw>::min)
            sine_and_cosine[0] = doubtful_sin<Raw, F>(angle);
        if (sine_and_cosine[1] == RawLimits<Raw>::min)
            sine_and_cosine[1] = doubtful_cos<Raw, F>(angle);
    }
    /// The length of a vector of two components, saturated.
    template <class Raw, int F>
    static constexpr Raw length2(const Raw* v) {
        return portable::length2<Raw, F>(v);
    }
    /// The length of a vector of three components, saturated.
    template <class Raw, int F>
    static constexpr Raw length3(const Raw* v) {
        return portable::length3<Raw, F>(v);
    }
    /// v / length3(v), by component; the zero vector stays zero. `unit` may be v.
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR void normalise3(const Raw* v, Raw* unit) {
        using Side = portable::UnitComponentSide;
        const Raw x = v[0], y = v[1], z = v[2];
        int64_t wide[3] = {portable::convert<int64_t, 32, Raw, F>(x),
                           portable::convert<int64_t, 32, Raw, F>(y),
                           portable::convert<int64_t, 32, Raw, F>(z)};
        kernel::normalise3<int64_t, 32>(wide, wide);
        unit[0] = portable::correctly_rounded<Raw, F, Side>(wide[0], x, y, z);
        unit[1] = portable::correctly_rounded<Raw, F, Side>(wide[1], y, z, x);
        unit[2] = portable::correctly_rounded<Raw, F, Side>(wide[2], z, x, y);
    }
};

/// \cond internal
// Of Q16.16 the precise sine needs no stage before it.
template <>
FIXEDPOINT_CONSTEXPR __attribute__((noinline)) int32_t CorrectlyRounded::doubtful_sin<int32_t, 16>(
    int32_t a) {
    return kernel::nearest_sine(a, 0);
}
template <>
FIXEDPOINT_CONSTEXPR __attribute__((noinline)) int32_t CorrectlyRounded::doubtful_cos<int32_t, 16>(
    int32_t a) {
    return kernel::nearest_sine(a, 1);
}
/// \endcond

}  // namespace fixedpoint
