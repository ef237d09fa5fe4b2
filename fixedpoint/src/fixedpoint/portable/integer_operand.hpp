// SPDX-License-Identifier: MIT
// Operations on a raw number a, value = a / 2^F, and an integer n of any type: the result modulo
// 2^W, and whether it is the exact one. No step narrows n.
#pragma once

#include <fixedpoint/arithmetic/event.hpp>
#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/convert.hpp>

namespace fixedpoint {
namespace portable {

// An unsigned integer wide enough for the magnitudes of both.
template <class Raw, class Int>
using MagnitudeOf =
    UnsignedInteger<(sizeof(Raw) > sizeof(Int)) ? RawLimits<Raw>::width : RawLimits<Int>::width>;

// Avoids comparing an unsigned number with zero by <, which compilers warn about.
template <class Int>
constexpr bool is_negative_integer(Int n) {
    return n < Int(1) && n != Int(0);
}
template <class Word, class Int>
constexpr Word integer_magnitude(Int n) {
    return is_negative_integer(n) ? static_cast<Word>(Word(0) - static_cast<Word>(n))
                                  : static_cast<Word>(n);
}

// The raw of a + n modulo 2^W, for which W bits of n are enough.
template <class Raw, int F, class Int>
constexpr Raw add_integer(Raw a, Int n) {
    return wrapping_add(a, scale<Raw, F>(n));
}
template <class Raw, class Int>
constexpr Raw multiply_integer(Raw a, Int n) {
    return static_cast<Raw>(
        wrapping_product(static_cast<Unsigned<Raw>>(a), static_cast<Unsigned<Raw>>(n)));
}

// floor((to - from) / 2^F) for raws. Requires to >= from.
template <class Raw, int F, class Int>
constexpr MagnitudeOf<Raw, Int> whole_distance(Raw from, Raw to) {
    return static_cast<MagnitudeOf<Raw, Int>>(shift_down<F>(static_cast<Unsigned<Raw>>(
        static_cast<Unsigned<Raw>>(to) - static_cast<Unsigned<Raw>>(from))));
}

// a + n is in range if |n| is at most the distance from a to the limit in the direction of n.
template <class Raw, int F, class Int>
constexpr bool sum_fits(Raw a, Int n) {
    return integer_magnitude<MagnitudeOf<Raw, Int>>(n) <=
           (is_negative_integer(n) ? whole_distance<Raw, F, Int>(RawLimits<Raw>::min, a)
                                   : whole_distance<Raw, F, Int>(a, RawLimits<Raw>::max));
}
// a - n: ~a = -a - 1 is as far from one limit as a is from the other.
template <class Raw, int F, class Int>
constexpr bool difference_fits(Raw a, Int n) {
    return sum_fits<Raw, F>(static_cast<Raw>(~a), n);
}
// n - a is in [min, max] if n 2^F is in [a + min, a + max]. With a sign, only the upper bound
// matters for n >= 0, and only the lower one for n < 0, which is written as |n| - 1 <= (max - a -
// (2^F - 1)) / 2^F, since 2^F may be out of range.
template <class Raw, int F, class Int, bool is_signed = RawLimits<Raw>::is_signed>
struct DifferenceFrom {
    using Magnitude = MagnitudeOf<Raw, Int>;
    static constexpr bool fits(Raw a, Int n) {
        return !is_negative_integer(n)
                   ? a != RawLimits<Raw>::min &&
                         integer_magnitude<Magnitude>(n) <=
                             whole_distance<Raw, F, Int>(static_cast<Raw>(-a), RawLimits<Raw>::max)
                   : a <= RawLimits<Raw>::max - fraction_mask<Raw, F>() &&
                         static_cast<Magnitude>(integer_magnitude<Magnitude>(n) - 1) <=
                             whole_distance<Raw, F, Int>(
                                 a,
                                 static_cast<Raw>(RawLimits<Raw>::max - fraction_mask<Raw, F>()));
    }
    // Whether n - a is above the range, if it is out of range.
    static constexpr bool is_above(Raw, Int n) { return !is_negative_integer(n); }
};
// Without a sign, n - a is the sum of the integer n - ceil(a) and the fraction ceil(a) - a.
template <class Raw, int F, class Int>
struct DifferenceFrom<Raw, F, Int, false> {
    using Magnitude = MagnitudeOf<Raw, Int>;
    static constexpr bool fits(Raw a, Int n) {
        return is_above(a, n) &&
               static_cast<Magnitude>(static_cast<Magnitude>(n) -
                                      static_cast<Magnitude>(integer_ceil<Raw, F>(a))) <=
                   whole_distance<Raw, F, Int>(fraction<Raw, F>(wrapping_negate(a)),
                                               RawLimits<Raw>::max);
    }
    static constexpr bool is_above(Raw a, Int n) {
        return !is_negative_integer(n) && static_cast<Magnitude>(n) >= integer_ceil<Raw, F>(a);
    }
};
// |a| <= limit / |n|: if n is a constant, so is the quotient.
template <class Raw, class Int>
constexpr bool product_fits(Raw a, Int n) {
    using Magnitude = MagnitudeOf<Raw, Int>;
    return n == Int(0) ||
           magnitude(a) <= largest_magnitude<Magnitude, Raw>((a < 0) != is_negative_integer(n)) /
                               integer_magnitude<Magnitude>(n);
}

// Whether n is a number of the format: its raw is then scale<Raw, F>(n).
template <class Raw, int F, class Int>
constexpr bool integer_fits(Int n) {
    return sum_fits<Raw, F>(Raw(0), n);
}

// A ratio of small numbers that rounds like a / n in every rounding mode, for an n that exceeds all
// raws: it is on the same side of 0, 1/2 and 1 as a / n.
template <class Raw>
struct Ratio {
    Raw numerator, denominator;
};
template <class Raw, class Magnitude>
constexpr Ratio<Raw> ratio_like(Magnitude a, Magnitude n, Raw sign) {
    return a == n       ? Ratio<Raw>{sign, 1}
           : a > n - a  ? Ratio<Raw>{static_cast<Raw>(2 * sign), 3}
           : a == n - a ? Ratio<Raw>{sign, 2}
                        : Ratio<Raw>{sign, 3};
}

// a / n by the division of Arithmetic.
template <class Arithmetic, class Raw>
constexpr Raw divide_ratio(Ratio<Raw> ratio) {
    return Arithmetic::template divide<Raw, 0>(ratio.numerator, ratio.denominator);
}
template <class Arithmetic, class Raw, class Int>
constexpr Raw divide_integer_with_sign(Raw a, Int n) {
    return divide_ratio<Arithmetic>(
        integer_fits<Raw, 0>(n)
            ? Ratio<Raw>{a, static_cast<Raw>(n)}
            : ratio_like(static_cast<MagnitudeOf<Raw, Int>>(magnitude(a)),
                         integer_magnitude<MagnitudeOf<Raw, Int>>(n),
                         static_cast<Raw>(a == 0                              ? 0
                                          : (a < 0) == is_negative_integer(n) ? 1
                                                                              : -1)));
}
// Without a sign, a / n is 0 for every n < 0, and out of range where it does not round to 0.
template <class Arithmetic, class Raw, class Int>
constexpr Raw divide_integer(Raw a, Int n) {
    return RawLimits<Raw>::is_signed || !is_negative_integer(n)
               ? divide_integer_with_sign<Arithmetic>(a, n)
           : static_cast<MagnitudeOf<Raw, Int>>(a) <=
                   integer_magnitude<MagnitudeOf<Raw, Int>>(n) / 2
               ? divide_ratio<Arithmetic>(Ratio<Raw>{static_cast<Raw>(a != 0), 3})
               : Arithmetic::settle(Raw(0), false, false, Operation::divide);
}

}  // namespace portable
}  // namespace fixedpoint
