// SPDX-License-Identifier: MIT
/// \file
/// Small: as Nearest, with a division and functions that take little flash instead of little time.
/// In Q16.16 they share code and have tables of 132 bytes at most; elsewhere they have no tables
/// but a few constants. Bounds are the same; quotients and roots are the same too, other results
/// may differ in the last place.
#pragma once

#include <fixedpoint/arithmetic/nearest.hpp>

namespace fixedpoint {

/// As Nearest, with a division and functions that take less flash and more time.
struct Small : Nearest {
    /// a / b rounded, saturated; a / 0 is the largest number, the smallest one or 0, by the sign of
    /// a.
    template <class Raw, int F>
    static constexpr Raw divide(Raw a, Raw b) {
        return kernel::divide_small<Raw, F>(a, b);
    }
    /// sqrt(a) rounded; 0 where a < 0.
    template <class Raw, int F>
    static constexpr Raw sqrt(Raw a) {
        return kernel::sqrt_small<Raw, F>(a);
    }
    /// 1 / sqrt(a), error below 0.75 ulp; the largest number where a = 0, 0 where a < 0.
    template <class Raw, int F>
    static constexpr Raw reciprocal_sqrt(Raw a) {
        return kernel::reciprocal_sqrt_small<Raw, F>(a);
    }
    /// The arc tangent in radians, error below 0.75 ulp.
    template <class Raw, int F>
    static constexpr Raw atan(Raw a) {
        return kernel::atan_small<Raw, F>(a);
    }
    /// The angle of (x, y) in (-pi, pi], error below 0.75 ulp; 0 where both are 0.
    template <class Raw, int F>
    static constexpr Raw atan2(Raw y, Raw x) {
        return kernel::atan2_small<Raw, F>(y, x);
    }
    /// The sine of an angle in radians, error below 0.75 ulp, never beyond +-1.
    template <class Raw, int F>
    static constexpr Raw sin(Raw angle) {
        return kernel::sin_small<Raw, F>(angle);
    }
    /// The cosine of an angle in radians, error below 0.75 ulp, never beyond +-1.
    template <class Raw, int F>
    static constexpr Raw cos(Raw angle) {
        return kernel::cos_small<Raw, F>(angle);
    }
    /// e^a, error below 0.75 ulp; the largest number where it does not fit.
    template <class Raw, int F>
    static constexpr Raw exp(Raw a) {
        return kernel::exp_small<Raw, F>(a);
    }
    /// The natural logarithm, error below 0.75 ulp; the smallest number where a <= 0.
    template <class Raw, int F>
    static constexpr Raw log(Raw a) {
        return kernel::log_small<Raw, F>(a);
    }
    /// \cond internal Those of portable/elementary.hpp, without kernels.
#define FIXEDPOINT_ELEMENTARY_FUNCTION(name, Function)                                     \
    template <class Raw, int F, class... Operands>                                         \
    static constexpr Raw name(Operands... operands) {                                      \
        return portable::Evaluated<portable::Function, Raw, F>::apply(operands...).number; \
    }
    FIXEDPOINT_ELEMENTARY_FUNCTIONS(FIXEDPOINT_ELEMENTARY_FUNCTION)
#undef FIXEDPOINT_ELEMENTARY_FUNCTION  /// \endcond
    /// Sine and cosine of an angle, the sine first.
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR void sincos(Raw angle, Raw* sine_and_cosine) {
        sine_and_cosine[0] = sin<Raw, F>(angle);
        sine_and_cosine[1] = cos<Raw, F>(angle);
    }
};

}  // namespace fixedpoint
