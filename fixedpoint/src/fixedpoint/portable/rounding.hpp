// SPDX-License-Identifier: MIT
// Products, quotients and conversions with a rounding mode other than to nearest, half up.
#pragma once

#include <fixedpoint/portable/convert.hpp>
#include <fixedpoint/portable/divide.hpp>
#include <fixedpoint/portable/product_sum.hpp>

namespace fixedpoint {

/// The rounding mode: to which of two adjacent numbers a result between them goes.
enum class Rounding : unsigned char {
    toward_zero,   ///< to the one nearer to 0
    downward,      ///< to the smaller one
    half_to_even,  ///< to the nearer one; a tie goes to the one with an even raw
};

namespace portable {

// The remainder of an integer quotient compared with half the divisor.
enum class Remainder : unsigned char { none, below_half, half, above_half };
template <class Word>
constexpr Remainder remainder_of(const Word& rest, const Word& other, bool is_zero) {
    return is_zero        ? Remainder::none
           : rest < other ? Remainder::below_half
           : rest > other ? Remainder::above_half
                          : Remainder::half;
}

// Whether floor(x), with this remainder, must be rounded up by an ulp.
constexpr bool goes_up_from_floor(Rounding rounding, Remainder rest, bool negative, bool odd) {
    return rounding == Rounding::toward_zero ? negative && rest != Remainder::none
           : rounding == Rounding::half_to_even
               ? rest == Remainder::above_half || (rest == Remainder::half && odd)
               : false;
}
// The same for the magnitude of x, truncated.
constexpr bool goes_away_from_zero(Rounding rounding, Remainder rest, bool negative, bool odd) {
    return rounding == Rounding::downward ? negative && rest != Remainder::none
                                          : rounding == Rounding::half_to_even &&
                                                goes_up_from_floor(rounding, rest, negative, odd);
}

// a b / 2^F modulo 2^W.
template <Rounding rounding, class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw multiply_rounded(Raw a, Raw b) {
    using Product = DoubleWord<Raw>;
    const Product product = exact_product(a, b), floor = static_cast<Product>(product >> F);
    const Raw result = static_cast<Raw>(floor);
    if (rounding == Rounding::downward || F == 0) return result;
    const Product rest = static_cast<Product>(product - static_cast<Product>(floor << F));
    const Product other =
        static_cast<Product>(static_cast<Product>(Product(uint8_t(1)) << F) - rest);
    const bool negative = (a < 0) != (b < 0);  // irrelevant for a product of 0
    const bool up =
        goes_up_from_floor(rounding, remainder_of(rest, other, !(rest > Product(uint8_t(0)))),
                           negative, (static_cast<uint8_t>(result) & 1) != 0);
    return wrapping_add(result, static_cast<Raw>(up ? 1 : 0));
}

// The integer part of a 2^F / b and its remainder; from 2^(W-1) on it overflows.
template <class Raw>
struct WholeQuotient {
    Unsigned<Raw> quotient, rest;
};
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR WholeQuotient<Raw> whole_quotient(Unsigned<Raw> a, Unsigned<Raw> b, Raw) {
    using Dividend = Unsigned<Wide<Raw>>;
    const Dividend dividend = static_cast<Dividend>(static_cast<Dividend>(a) << F);
    const Dividend quotient = static_cast<Dividend>(dividend / b);
    if (quotient >> (RawLimits<Raw>::width - 1) != 0) return {magnitude_overflow<Raw>(), 0};
    return {static_cast<Unsigned<Raw>>(quotient),
            static_cast<Unsigned<Raw>>(dividend - static_cast<Dividend>(quotient * b))};
}
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR WholeQuotient<int64_t> whole_quotient(uint64_t a, uint64_t b, int64_t) {
    const uint64_t high = a >> 1 >> (63 - F);
    if (high >= b) return {magnitude_overflow<int64_t>(), 0};
    const Division128 division = divide_full(high, a << F, b);
    if (division.quotient >> 63 != 0) return {magnitude_overflow<int64_t>(), 0};
    return {division.quotient, division.remainder};
}
// a 2^F / b, saturated; for b = 0 as divide.
template <Rounding rounding, class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw divide_rounded(Raw a, Raw b) {
    if (b == 0) return a > 0 ? RawLimits<Raw>::max : a < 0 ? RawLimits<Raw>::min : Raw(0);
    const bool negative = (a < 0) != (b < 0);
    const WholeQuotient<Raw> whole = whole_quotient<Raw, F>(magnitude(a), magnitude(b), a);
    const Unsigned<Raw> other = static_cast<Unsigned<Raw>>(magnitude(b) - whole.rest);
    const bool away =
        goes_away_from_zero(rounding, remainder_of(whole.rest, other, whole.rest == 0), negative,
                            (whole.quotient & 1) != 0);
    return saturated_with_sign<Raw>(
        static_cast<Unsigned<Raw>>(whole.quotient + static_cast<Unsigned<Raw>>(away ? 1 : 0)),
        negative);
}

// a / 2^Shift. From Shift = W on the exact quotient is in [-1/2, 1/2).
template <Rounding rounding, int Shift, class Raw>
FIXEDPOINT_CONSTEXPR Raw shift_rounded(Raw a) {
    constexpr bool whole = Shift >= RawLimits<Raw>::width;
    constexpr int count = whole || Shift == 0 ? 1 : Shift;
    const bool negative = a < Raw(1) && a != Raw(0);
    if (Shift == 0) return a;
    if (whole) return static_cast<Raw>(rounding == Rounding::downward && negative ? -1 : 0);
    using Word = Unsigned<Raw>;
    const Raw floor = static_cast<Raw>(a >> count);
    const Word mask = static_cast<Word>(static_cast<Word>(Word(1) << count) - 1);
    const Word rest = static_cast<Word>(static_cast<Word>(a) & mask);
    const Word other = static_cast<Word>(static_cast<Word>(mask - rest) + 1);
    const bool up = goes_up_from_floor(rounding, remainder_of(rest, other, rest == 0), negative,
                                       (static_cast<uint8_t>(floor) & 1) != 0);
    return static_cast<Raw>(floor + (up ? 1 : 0));
}
// a, a raw of another format, rounded, modulo 2^W.
template <Rounding rounding, class ToRaw, int ToF, class FromRaw, int FromF>
FIXEDPOINT_CONSTEXPR ToRaw convert_rounded(FromRaw a) {
    return scale<ToRaw, left_shift<FromF, ToF>()>(
        shift_rounded<rounding, right_shift<FromF, ToF>()>(a));
}

}  // namespace portable
}  // namespace fixedpoint
