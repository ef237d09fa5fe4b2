// SPDX-License-Identifier: MIT
/// \file
/// Rounded: as Nearest, but products, quotients, conversions and divisions by a power of two are
/// rounded toward zero, toward minus infinity or half to even. Use it to reproduce the results of
/// another machine or of a standard. It does not have kernels: products take several times the
/// cycles of Nearest, and quotients of 64 bits dozens of times. Everything else is inherited from
/// Nearest.
#pragma once

#include <fixedpoint/arithmetic/nearest.hpp>
#include <fixedpoint/portable/rounding.hpp>

namespace fixedpoint {

/// As Nearest, with another rounding of products, quotients and conversions.
template <Rounding rounding>
struct Rounded : Nearest {
    /// a b rounded, mod 2^W.
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR Raw multiply(Raw a, Raw b) {
        return portable::multiply_rounded<rounding, Raw, F>(a, b);
    }
    /// a / b rounded, saturated; a / 0 is the largest number, the smallest one or 0, by the sign of
    /// a.
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR Raw divide(Raw a, Raw b) {
        return portable::divide_rounded<rounding, Raw, F>(a, b);
    }
    /// The rounded a b, plus c, mod 2^W.
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR Raw multiply_add(Raw a, Raw b, Raw c) {
        return wrapping_add(multiply<Raw, F>(a, b), c);
    }
    /// The sum of a_i b_i over two or three components, each product rounded separately, mod 2^W.
    /// @{
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR Raw dot2(const Raw* a, const Raw* b) {
        return multiply_add<Raw, F>(a[1], b[1], multiply<Raw, F>(a[0], b[0]));
    }
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR Raw dot3(const Raw* a, const Raw* b) {
        return multiply_add<Raw, F>(a[2], b[2], dot2<Raw, F>(a, b));
    }
    /// @}
    /// a / 2^K rounded.
    template <int K, class Raw>
    static FIXEDPOINT_CONSTEXPR Raw scale_down(Raw a) {
        return portable::shift_rounded<rounding, K>(a);
    }
    /// a, an integer or a raw of another format, rounded to F fraction bits, mod 2^W.
    template <class Raw, int F, class FromRaw, int FromF>
    static FIXEDPOINT_CONSTEXPR Raw convert(FromRaw a) {
        return portable::convert_rounded<rounding, Raw, F, FromRaw, FromF>(a);
    }
};

/// Rounds toward zero, as C divides integers.
using TowardZero = Rounded<Rounding::toward_zero>;
/// Rounds toward minus infinity, as >> shifts.
using Downward = Rounded<Rounding::downward>;
/// Rounds to nearest, half to even, as IEEE 754 does by default: unbiased.
using HalfToEven = Rounded<Rounding::half_to_even>;

}  // namespace fixedpoint
