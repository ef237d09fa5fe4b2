// SPDX-License-Identifier: MIT
// Products and quotients rounded half up, turned into those of another rounding mode; and
// conversions.
#pragma once

#include <fixedpoint/portable/convert.hpp>
#include <fixedpoint/portable/product_sum.hpp>

namespace fixedpoint {

/// The rounding mode: to which of two adjacent numbers a result between them goes.
enum class Rounding : unsigned char {
    toward_zero,   ///< to the one nearer to 0
    downward,      ///< to the smaller one
    half_to_even,  ///< to the nearer one; a tie goes to the one with an even raw
};

namespace portable {

// The smallest built-in word of at least so many bits.
template <int Bits>
using WordOf = UnsignedInteger<(Bits <= 8    ? 8
                                : Bits <= 16 ? 16
                                : Bits <= 32 ? 32
                                             : 64)>;

template <class Raw>
constexpr bool is_odd(Raw a) {
    return (static_cast<uint8_t>(a) & 1) != 0;
}
template <class Raw>
constexpr Raw moved(Raw a, bool up, bool down) {
    return up == down ? a : up ? wrapping_add(a, Raw(1)) : wrapping_subtract(a, Raw(1));
}

// a b modulo 2^F: the bits that a product loses.
template <int F, class Raw>
constexpr WordOf<F> lost_bits(Raw a, Raw b) {
    return static_cast<WordOf<F>>((1u * static_cast<WordOf<F>>(a) * static_cast<WordOf<F>>(b)) &
                                  static_cast<WordOf<F>>((WordOf<F>(2) << (F - 1)) - 1));
}
// A product modulo 2^W from the one rounded half up, which has gone up if the lost bits begin with
// a one.
template <Rounding rounding, int F, class Raw>
constexpr Raw product_from_nearest(Raw nearest, WordOf<F> lost, bool negative) {
    return moved(nearest, rounding == Rounding::toward_zero && negative && lost != 0,
                 rounding == Rounding::half_to_even
                     ? lost == WordOf<F>(1) << (F - 1) && is_odd(nearest)
                     : lost >= WordOf<F>(1) << (F - 1));
}

// Whether |a / b| is 2^(I-1) or more, or b is 0.
template <class Raw, int F>
constexpr bool quotient_is_beyond(Raw a, Raw b) {
    return static_cast<Unsigned<Raw>>(magnitude(a) >> (RawLimits<Raw>::width - 1 - F)) >=
           magnitude(b);
}
// A quotient, saturated, from the one rounded half up; for b = 0 that. Unless the quotient is
// beyond the range, a 2^F - nearest b is less than |b|, so its W bits tell on which side of
// `nearest` the quotient lies.
template <Rounding rounding, class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw quotient_from_nearest(Raw nearest, Raw a, Raw b) {
    using Word = WordOf<RawLimits<Raw>::width>;
    if ((nearest == RawLimits<Raw>::max || nearest == RawLimits<Raw>::min) &&
        quotient_is_beyond<Raw, F>(a, b))
        return nearest;
    const Word divisor = static_cast<Word>(b);
    const Word rest = static_cast<Word>(static_cast<Word>(static_cast<Word>(a) << F) -
                                        1u * static_cast<Word>(nearest) * divisor);
    if (rest == 0) return nearest;
    if (rounding == Rounding::half_to_even)
        return moved(nearest, false,
                     static_cast<Word>(rest + rest + divisor) == 0 && is_odd(nearest));
    const bool above = !signs_differ(static_cast<Raw>(rest), b);
    const bool negative = rounding == Rounding::toward_zero && signs_differ(a, b);
    return moved(nearest, above && negative, !above && !negative);
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
    const Word half = static_cast<Word>(Word(1) << (count - 1));
    const Word mask = static_cast<Word>(half | (half - 1));
    const Word rest = static_cast<Word>(static_cast<Word>(a) & mask);
    const bool up = rounding == Rounding::toward_zero
                        ? negative && rest != 0
                        : rounding == Rounding::half_to_even &&
                              (rest > half || (rest == half && is_odd(floor)));
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
