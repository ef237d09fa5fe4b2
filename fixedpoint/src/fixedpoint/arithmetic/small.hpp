// SPDX-License-Identifier: MIT
/// \file
/// Small: like Nearest, but division and functions are optimised for flash instead of time. In
/// Q16.16 they share code, and each table has at most 132 bytes; other formats need no tables, only
/// a few constants. The error bounds are those of Nearest, and so are quotients and square roots;
/// other results may differ in the last place.
#pragma once

#include <fixedpoint/arithmetic/nearest.hpp>

namespace fixedpoint {

/// Like Nearest, but division and functions take less flash and more time.
struct Small : Nearest {
    /// a / b, rounded and saturated; if b = 0, the largest number, the smallest number or 0,
    /// depending on the sign of a.
    template <class Raw, int F>
    static constexpr Raw divide(Raw a, Raw b) {
        return kernel::divide_small<Raw, F>(a, b);
    }
    /// sqrt(a), rounded; 0 if a < 0.
    template <class Raw, int F>
    static constexpr Raw sqrt(Raw a) {
        return kernel::sqrt_small<Raw, F>(a);
    }
    /// 1 / sqrt(a), error below 0.75 ulp; the largest number if a = 0, 0 if a < 0.
    template <class Raw, int F>
    static constexpr Raw reciprocal_sqrt(Raw a) {
        return kernel::reciprocal_sqrt_small<Raw, F>(a);
    }
    /// The arc tangent in radians, error below 0.75 ulp.
    template <class Raw, int F>
    static constexpr Raw atan(Raw a) {
        return kernel::atan_small<Raw, F>(a);
    }
    /// The angle of (x, y) in (-pi, pi], error below 0.75 ulp; 0 if both are 0.
    template <class Raw, int F>
    static constexpr Raw atan2(Raw y, Raw x) {
        return kernel::atan2_small<Raw, F>(y, x);
    }
    /// The sine of an angle in radians, error below 0.75 ulp, never outside [-1, 1].
    template <class Raw, int F>
    static constexpr Raw sin(Raw angle) {
        return kernel::sin_small<Raw, F>(angle);
    }
    /// The cosine of an angle in radians, error below 0.75 ulp, never outside [-1, 1].
    template <class Raw, int F>
    static constexpr Raw cos(Raw angle) {
        return kernel::cos_small<Raw, F>(angle);
    }
    /// e^a, error below 0.75 ulp; the largest number if it does not fit.
    template <class Raw, int F>
    static constexpr Raw exp(Raw a) {
        return kernel::exp_small<Raw, F>(a);
    }
    /// The natural logarithm, error below 0.75 ulp; the smallest number if a <= 0.
    template <class Raw, int F>
    static constexpr Raw log(Raw a) {
        return kernel::log_small<Raw, F>(a);
    }
    /// \cond internal The functions of portable/elementary_functions.hpp, without kernels.
#define FIXEDPOINT_ELEMENTARY_FUNCTION(name, Function)                                     \
    template <class Raw, int F, class... Operands>                                         \
    static constexpr Raw name(Operands... operands) {                                      \
        return portable::Evaluated<portable::Function, Raw, F>::apply(operands...).number; \
    }
    FIXEDPOINT_ELEMENTARY_FUNCTIONS(FIXEDPOINT_ELEMENTARY_FUNCTION)
#undef FIXEDPOINT_ELEMENTARY_FUNCTION  /// \endcond
    /// Writes the sine of an angle, then its cosine.
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR void sincos(Raw angle, Raw* sine_and_cosine) {
        sine_and_cosine[0] = sin<Raw, F>(angle);
        sine_and_cosine[1] = cos<Raw, F>(angle);
    }
};

}  // namespace fixedpoint
