// SPDX-License-Identifier: MIT
/// \file
/// CorrectlyRounded: as Nearest, but functions too return the exact result rounded to nearest, half
/// up, so results do not depend on the algorithm. Every number of the format must be a number of
/// Q16.16, as in Q4.4 and Q8.8. sin, cos, atan, atan2, exp, log and the reciprocal square root are
/// first computed with a 32-bit core. If the error bound of that leaves the rounding undecided,
/// their kernels compute further digits; without a kernel, Q32.32 comes in between. The other
/// functions begin in Q32.32, and go on if that result is a tie. Functions of turns and degrees and
/// integer powers are those of Nearest.
#pragma once

#include <fixedpoint/arithmetic/nearest.hpp>
#include <fixedpoint/kernel/nearest.hpp>

namespace fixedpoint {

/// As Nearest, with correctly rounded functions: their error is at most 0.5 ulp.
struct CorrectlyRounded : Nearest {
    /// \cond internal
#define FIXEDPOINT_CORRECTLY_ROUNDED(name, in_doubt)                                              \
    template <class Raw, int F>                                                                   \
    static constexpr Raw name(Raw a) {                                                            \
        return kernel::is_kept(kernel::in_doubt<Raw, F>) ? kernel::nearest_##name<Raw, F>(a) : a; \
    }
    FIXEDPOINT_CORRECTLY_ROUNDED(sin, decided_sine)
    FIXEDPOINT_CORRECTLY_ROUNDED(cos, decided_sine)
    FIXEDPOINT_CORRECTLY_ROUNDED(exp, rounded_power)
    FIXEDPOINT_CORRECTLY_ROUNDED(log, decided_log)
#undef FIXEDPOINT_CORRECTLY_ROUNDED
    template <class Raw, int F>
    static constexpr Raw atan(Raw a) {
        return kernel::nearest_atan<Raw, F>(a);
    }
    template <class Raw, int F>
    static constexpr Raw reciprocal_sqrt(Raw a) {
        return kernel::nearest_reciprocal_sqrt<Raw, F>(a);
    }
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
    /// \endcond
    /// The angle of (x, y) in (-pi, pi], correctly rounded, saturated; 0 if both are 0.
    template <class Raw, int F>
    static constexpr Raw atan2(Raw y, Raw x) {
        return kernel::nearest_atan2<Raw, F>(y, x);
    }
    /// The sine and the cosine of an angle in radians, in that order, correctly rounded.
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR void sincos(Raw angle, Raw* sine_and_cosine) {
        sine_and_cosine[0] = sin<Raw, F>(angle);
        sine_and_cosine[1] = cos<Raw, F>(angle);
    }
    /// The length of a vector of two components, correctly rounded, saturated.
    template <class Raw, int F>
    static constexpr Raw length2(const Raw* v) {
        return portable::length2<Raw, F>(v);
    }
    /// The length of a vector of three components, correctly rounded, saturated.
    template <class Raw, int F>
    static constexpr Raw length3(const Raw* v) {
        return portable::length3<Raw, F>(v);
    }
    /// Writes v / length3(v) to `unit`, each component correctly rounded; the zero vector stays
    /// zero. `unit` may be `v`.
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

}  // namespace fixedpoint
