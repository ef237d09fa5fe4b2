// SPDX-License-Identifier: MIT
/// \file
/// CorrectlyRounded: as Nearest, but functions too return the exact result rounded to nearest, half
/// up, so results do not depend on the algorithm. Formats have at most 32 bits; for atan2 and pow,
/// every number must be a number of Q16.16, as in Q4.4 and Q8.8. In Q16.16, sin, cos, atan, atan2,
/// exp, log and the reciprocal square root are first computed with a 32-bit core, and if the error
/// bound of that leaves the rounding undecided, their kernels compute further digits. All other
/// functions begin in a 64-bit format with at least 16 more fraction bits, and go on if that result
/// is a tie. Functions of turns and degrees and integer powers are those of Nearest.
#pragma once

#include <fixedpoint/arithmetic/nearest.hpp>
#include <fixedpoint/kernel/nearest.hpp>

namespace fixedpoint {

/// As Nearest, with correctly rounded functions: their error is at most 0.5 ulp.
struct CorrectlyRounded : Nearest {
    /// \cond internal
#define FIXEDPOINT_CORRECTLY_ROUNDED(name)                                                      \
    template <class Raw, int F>                                                                 \
    static constexpr Raw name(Raw a) {                                                          \
        return kernel::CalledByKernels<Raw, F>::name() ? kernel::nearest_##name<Raw, F>(a) : a; \
    }
    FIXEDPOINT_CORRECTLY_ROUNDED(sin)
    FIXEDPOINT_CORRECTLY_ROUNDED(cos)
    FIXEDPOINT_CORRECTLY_ROUNDED(exp)
    FIXEDPOINT_CORRECTLY_ROUNDED(log)
#undef FIXEDPOINT_CORRECTLY_ROUNDED
    template <class Raw, int F>
    static constexpr Raw atan(Raw a) {
        return kernel::nearest_atan<Raw, F>(a);
    }
    template <class Raw, int F>
    static constexpr Raw reciprocal_sqrt(Raw a) {
        return kernel::nearest_reciprocal_sqrt<Raw, F>(a);
    }
#define FIXEDPOINT_CORRECTLY_ROUNDED(name, Function, ...)                                         \
    template <class Raw, int F, class... Operands>                                                \
    static constexpr Raw name(Operands... a) {                                                    \
        return portable::correctly_rounded<Raw, F, __VA_ARGS__>(                                  \
            portable::Evaluated<kernel::Function, int64_t, portable::finer_fraction<F>()>::apply( \
                portable::finer<Raw, F>(a)...)                                                    \
                .number,                                                                          \
            a...);                                                                                \
    }
#define FIXEDPOINT_ARC_SIDE(Function) \
    kernel::SideOf<Raw, F, portable::WideSide<portable::Function>, portable::side_of_tie::Function>
    FIXEDPOINT_CORRECTLY_ROUNDED(tan, Tan, portable::side_of_tie::Tan)
    FIXEDPOINT_CORRECTLY_ROUNDED(asin, Asin, FIXEDPOINT_ARC_SIDE(Asin))
    FIXEDPOINT_CORRECTLY_ROUNDED(acos, Acos, FIXEDPOINT_ARC_SIDE(Acos))
    FIXEDPOINT_CORRECTLY_ROUNDED(exp2, Exp2, portable::side_of_tie::Exp2)
    FIXEDPOINT_CORRECTLY_ROUNDED(expm1, Expm1, portable::side_of_tie::Expm1)
    FIXEDPOINT_CORRECTLY_ROUNDED(log2, Log2, portable::side_of_tie::Log2)
    FIXEDPOINT_CORRECTLY_ROUNDED(log10, Log10, portable::side_of_tie::Log10)
    FIXEDPOINT_CORRECTLY_ROUNDED(log1p, Log1p, portable::side_of_tie::Log1p)
    FIXEDPOINT_CORRECTLY_ROUNDED(sinh, Sinh, portable::side_of_tie::Sinh)
    FIXEDPOINT_CORRECTLY_ROUNDED(cosh, Cosh, portable::side_of_tie::Cosh)
    FIXEDPOINT_CORRECTLY_ROUNDED(tanh, Tanh, portable::side_of_tie::Tanh)
    FIXEDPOINT_CORRECTLY_ROUNDED(cbrt, Cbrt, portable::side_of_tie::Cbrt)
    FIXEDPOINT_CORRECTLY_ROUNDED(pow, Pow, portable::InQ16_16<portable::WideSide<portable::Pow>>)
#undef FIXEDPOINT_ARC_SIDE
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
    /// Writes v / length3(v) to `unit`, each component correctly rounded; the zero vector stays
    /// zero. `unit` may be `v`.
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR void normalise3(const Raw* v, Raw* unit) {
        using Side = portable::UnitComponentSide;
        const Raw x = v[0], y = v[1], z = v[2];
        int64_t fine[3] = {portable::finer<Raw, F>(x), portable::finer<Raw, F>(y),
                           portable::finer<Raw, F>(z)};
        kernel::normalise3<int64_t, portable::finer_fraction<F>()>(fine, fine);
        unit[0] = portable::correctly_rounded<Raw, F, Side>(fine[0], x, y, z);
        unit[1] = portable::correctly_rounded<Raw, F, Side>(fine[1], y, z, x);
        unit[2] = portable::correctly_rounded<Raw, F, Side>(fine[2], z, x, y);
    }
};

}  // namespace fixedpoint
