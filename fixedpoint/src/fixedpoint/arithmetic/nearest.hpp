// SPDX-License-Identifier: MIT
/// \file
/// Nearest, the default arithmetic, on raw integers of W bits with F fraction bits.
///
/// One rule covers every operation and every input: the exact result is rounded to the nearest
/// representable number, half up, floor(x + 1/2). The ring operations (+ - * negate, abs, shifts,
/// dot, multiply_add) and conversions are then taken modulo 2^W, so a sum is correct even if a
/// partial sum overflows. Everything else (division, square root, functions, lengths) saturates,
/// since a wrapped quotient would carry no information. Functions that are not correctly rounded
/// state their error bound.
#pragma once

#include <fixedpoint/arithmetic/wrapping.hpp>
#include <fixedpoint/kernel/dispatch.hpp>
#include <fixedpoint/kernel/elementary.hpp>

namespace fixedpoint {

/// The default arithmetic: results are rounded to nearest, half up; ring operations wrap,
/// everything else saturates.
struct Nearest : Wrapping {
    /// a b rounded, mod 2^W.
    template <class Raw, int F>
    static constexpr Raw multiply(Raw a, Raw b) {
        return kernel::multiply<Raw, F>(a, b);
    }
    /// a / b rounded, saturated; a / 0 is the largest number, the smallest one or 0, by the sign of
    /// a.
    template <class Raw, int F>
    static constexpr Raw divide(Raw a, Raw b) {
        return kernel::divide<Raw, F>(a, b);
    }
    /// a - b trunc(a / b), exact, 0 or with the sign of a; a if b is 0.
    template <class Raw, int F>
    static constexpr Raw remainder(Raw a, Raw b) {
        return kernel::remainder<Raw, F>(a, b);
    }
    /// sqrt(a) rounded; 0 if a < 0.
    template <class Raw, int F>
    static constexpr Raw sqrt(Raw a) {
        return kernel::sqrt<Raw, F>(a);
    }
    /// 1 / sqrt(a), faithful (error below 0.75 ulp), saturated; the largest number if a = 0, and 0
    /// if a < 0.
    template <class Raw, int F>
    static constexpr Raw reciprocal_sqrt(Raw a) {
        return kernel::reciprocal_sqrt<Raw, F>(a);
    }
    /// The arc tangent in radians, faithful (error below 0.75 ulp), saturated.
    template <class Raw, int F>
    static constexpr Raw atan(Raw a) {
        return kernel::atan<Raw, F>(a);
    }
    /// The angle of (x, y) in (-pi, pi], faithful (error below 0.75 ulp), saturated; 0 if both are
    /// 0.
    template <class Raw, int F>
    static constexpr Raw atan2(Raw y, Raw x) {
        return kernel::atan2<Raw, F>(y, x);
    }
    /// The sine of an angle in radians, faithful (error below 0.75 ulp), never outside [-1, 1].
    template <class Raw, int F>
    static constexpr Raw sin(Raw angle) {
        return kernel::sin<Raw, F>(angle);
    }
    /// The cosine of an angle in radians, faithful (error below 0.75 ulp), never outside [-1, 1],
    /// saturated.
    template <class Raw, int F>
    static constexpr Raw cos(Raw angle) {
        return kernel::cos<Raw, F>(angle);
    }
    /// The sine and the cosine, in that order: the same results in less time than two calls.
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR void sincos(Raw angle, Raw* sine_and_cosine) {
        kernel::sincos<Raw, F>(angle, sine_and_cosine);
    }
    /// e^a, faithful (error below 0.75 ulp), saturated.
    template <class Raw, int F>
    static constexpr Raw exp(Raw a) {
        return kernel::exp<Raw, F>(a);
    }
    /// The natural logarithm, faithful (error below 0.75 ulp), saturated; the smallest number if
    /// a <= 0.
    template <class Raw, int F>
    static constexpr Raw log(Raw a) {
        return kernel::log<Raw, F>(a);
    }
    /// \cond internal The functions of portable/elementary_functions.hpp.
#define FIXEDPOINT_ELEMENTARY_FUNCTION(name, Function)                                   \
    template <class Raw, int F, class... Operands>                                       \
    static constexpr Raw name(Operands... operands) {                                    \
        return portable::Evaluated<kernel::Function, Raw, F>::apply(operands...).number; \
    }
    FIXEDPOINT_ELEMENTARY_FUNCTIONS(FIXEDPOINT_ELEMENTARY_FUNCTION)
#undef FIXEDPOINT_ELEMENTARY_FUNCTION  /// \endcond
    /// a b + c, rounded once, mod 2^W.
    template <class Raw, int F>
    static constexpr Raw multiply_add(Raw a, Raw b, Raw c) {
        return kernel::multiply_add<Raw, F>(a, b, c);
    }
    /// a[0] b[0] + a[1] b[1], rounded once, mod 2^W.
    template <class Raw, int F>
    static constexpr Raw dot2(const Raw* a, const Raw* b) {
        return kernel::dot2<Raw, F>(a, b);
    }
    /// a[0] b[0] + a[1] b[1] + a[2] b[2], rounded once, mod 2^W.
    template <class Raw, int F>
    static constexpr Raw dot3(const Raw* a, const Raw* b) {
        return kernel::dot3<Raw, F>(a, b);
    }
    /// The length of a vector of two components rounded, saturated. No square overflows.
    template <class Raw, int F>
    static constexpr Raw length2(const Raw* v) {
        return kernel::length2<Raw, F>(v);
    }
    /// The length of a vector of three components rounded, saturated. No square overflows.
    template <class Raw, int F>
    static constexpr Raw length3(const Raw* v) {
        return kernel::length3<Raw, F>(v);
    }
    /// Writes v / length3(v) to `unit`, each component within 1 ulp, saturated; the zero vector
    /// stays zero. `unit` may be `v`.
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR void normalise3(const Raw* v, Raw* unit) {
        kernel::normalise3<Raw, F>(v, unit);
    }
};

}  // namespace fixedpoint
