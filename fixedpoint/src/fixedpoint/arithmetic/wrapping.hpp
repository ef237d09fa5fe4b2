// SPDX-License-Identifier: MIT
/// \file
/// Wrapping: the operations that all arithmetics share. Sums and shifts are exact modulo 2^W;
/// conversions, divisions by a power of two and roundings to an integer are rounded to nearest.
/// Arithmetics that saturate, report or round differently override them.
#pragma once

#include <fixedpoint/arithmetic/event.hpp>
#include <fixedpoint/portable/convert.hpp>
#include <fixedpoint/portable/floating_point.hpp>
#include <fixedpoint/portable/from_decimal.hpp>
#include <fixedpoint/portable/round.hpp>
#include <fixedpoint/portable/scale_down.hpp>

namespace fixedpoint {

/// The operations that all arithmetics share: sums, shifts, conversions and roundings to an
/// integer.
struct Wrapping {
    /// Whether sums, differences and products out of range are taken modulo 2^W.
    static constexpr bool is_modulo = true;

    /// (a + b) mod 2^W.
    template <class Raw, int F>
    static constexpr Raw add(Raw a, Raw b) {
        return wrapping_add(a, b);
    }
    /// (a - b) mod 2^W.
    template <class Raw, int F>
    static constexpr Raw subtract(Raw a, Raw b) {
        return wrapping_subtract(a, b);
    }
    /// -a mod 2^W: the smallest number is its own negative.
    template <class Raw, int F>
    static constexpr Raw negate(Raw a) {
        return wrapping_negate(a);
    }
    /// Whether `settle` needs more than the result mod 2^W.
    static constexpr bool settles = false;
    /// Turns an exact result into the one to return, for operations that are not defined by two
    /// raws alone. `wrapped` is the result mod 2^W; the other arguments say whether it is the exact
    /// one, if not, whether the exact one is above the range rather than below, and which operation
    /// it belongs to.
    template <class Raw>
    static constexpr Raw settle(Raw wrapped, bool, bool, Operation) {
        return wrapped;
    }
    /// The same for the integer quotient a / b, which is already saturated.
    template <class Raw>
    static constexpr Raw settle_quotient(Raw quotient, Raw, Raw) {
        return quotient;
    }
    /// a 2^count mod 2^W; 0 from count = W on.
    template <class Raw, int F>
    static constexpr Raw shift_left(Raw a, unsigned char count) {
        return wrapping_shift_left(a, count);
    }
    /// a / 2^K rounded to nearest, half up.
    template <int K, class Raw>
    static constexpr Raw scale_down(Raw a) {
        return portable::scale_down<K>(a);
    }
    /// a, an integer or a raw of another format, rounded to F fraction bits, mod 2^W.
    template <class Raw, int F, class FromRaw, int FromF>
    static constexpr Raw convert(FromRaw a) {
        return portable::convert<Raw, F, FromRaw, FromF>(a);
    }
    /// The float or double x, rounded, saturated; 0 if x is NaN.
    template <class Raw, int F, class Float>
    static constexpr Raw from_float(Float x) {
        return portable::from_float<Raw, F>(x).number;
    }
    /// n / 10^decimals, rounded, saturated.
    template <class Raw, int F, class Int>
    static constexpr Raw from_decimal(Int n, uint8_t decimals) {
        return portable::from_decimal<Raw, F>(n, decimals).number;
    }
    /// The smallest integral number >= a, saturated.
    template <class Raw, int F>
    static constexpr Raw ceil(Raw a) {
        return portable::ceil<Raw, F>(a);
    }
    /// The nearest integral number, half up, saturated.
    template <class Raw, int F>
    static constexpr Raw round(Raw a) {
        return portable::round<Raw, F>(a);
    }
};

}  // namespace fixedpoint
