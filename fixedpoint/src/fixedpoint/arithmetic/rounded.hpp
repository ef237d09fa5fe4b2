// SPDX-License-Identifier: MIT
/// \file
/// Rounded: as Nearest, but products, quotients, conversions and divisions by a power of two are
/// rounded toward zero, toward minus infinity or half to even. Use it to reproduce the results of
/// another machine or of a standard. Products and quotients are first rounded by the kernels of
/// Nearest; a product modulo 2^F or 2^W tells whether that must be changed. Everything else is
/// inherited from Nearest.
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
        // The whole product of 8 bits is one instruction.
        if (rounding == Rounding::downward && RawLimits<Raw>::width == 8)
            return static_cast<Raw>(portable::exact_product(a, b) >> F);
        if (F == 0) return Nearest::multiply<Raw, F>(a, b);
        constexpr int lost_count = F == 0 ? 1 : F;
        // Before the kernel is called, for what is needed afterwards occupies registers.
        const auto lost = portable::lost_bits<lost_count>(a, b);
        const bool negative = signs_differ(a, b);
        return portable::product_from_nearest<rounding, lost_count>(Nearest::multiply<Raw, F>(a, b),
                                                                    lost, negative);
    }
    /// a / b rounded, saturated; a / 0 is the largest number, the smallest one or 0, by the sign of
    /// a.
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR Raw divide(Raw a, Raw b) {
        return portable::quotient_from_nearest<rounding, Raw, F>(Nearest::divide<Raw, F>(a, b), a,
                                                                 b);
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
