// SPDX-License-Identifier: MIT
// Whether the exact result of a function, rounded to nearest, is in range. The functions themselves
// saturate, so the result alone does not show whether it fits: the largest number is a result like
// any other. Each answer is a comparison with the operand at which the result crosses the limit,
// half an ulp beyond the last number. Results of functions not named here are always in range.
#pragma once

#include <fixedpoint/portable/double_word.hpp>

namespace fixedpoint {
namespace portable {

template <class Raw, int F>
constexpr int integer_bits_of() {
    return RawLimits<Raw>::width - F;
}

// a 2^count is in range if shifting it back gives a.
template <class Raw>
constexpr bool shift_left_fits(Raw a, unsigned char count) {
    return a == 0 || (count < RawLimits<Raw>::width &&
                      static_cast<Raw>(wrapping_shift_left(a, count) >> count) == a);
}

// a must be greater than 0. The result is out of range if 2^(3F/2) / sqrt(a) >= 2^(W-1) - 1/2. With
// e = 3F + 2 - 2W that is a <= 2^e (1 + 2^(1-W) + ...), and the bracket does not matter for the
// integer a, since e is at most W - 1.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR bool reciprocal_sqrt_fits(Raw a) {
    constexpr int e = 3 * F + 2 - 2 * RawLimits<Raw>::width;
    return e < 0 || static_cast<Raw>(a - 1) >> (e < 0 ? 0 : e) != 0;
}

// If 1 is out of range, the result is too if cos(a) >= 1 - 2^-W: a^2 <= 2^-F up to a^4 / 12, which
// is less than the distance to the next square.
template <class Raw, int F>
constexpr bool cos_fits(Raw a) {
    using Square = DoubleWord<Raw>;
    return integer_bits_of<Raw, F>() > 1 ||
           square(a) >= static_cast<Square>(Square(uint8_t(1)) << (RawLimits<Raw>::width - 1));
}

// e^a >= 2^(I-1) - 2^-(F+1) from a = (I - 1) ln 2 - 2^-W on, rounded up to an ulp.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw exp_limit() {
    // ln(2) 2^120
    constexpr Word128 ln2(0xb17217f7d1cf79, 0xabc9e3b39803f2f6);
    constexpr int W = RawLimits<Raw>::width;
    if (integer_bits_of<Raw, F>() == 1) return 0;
    const Word128 limit =
        ln2 * static_cast<uint64_t>(integer_bits_of<Raw, F>() - 1) - (Word128(1) << (120 - W));
    return static_cast<Raw>((limit + ((Word128(1) << (120 - F)) - Word128(1))) >> (120 - F));
}
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR bool exp_fits(Raw a) {
    const Raw limit = exp_limit<Raw, F>();
    return a < limit;
}

// ln(a) < -2^(I-1) - 2^-(F+1) below a = e^-2^(I-1) (1 - d + d^2 / 2), d = 2^-(F+1). With seven
// integer bits or more no number is that small.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw log_limit() {
    // e^-2^k in units of 2^-64.
    constexpr uint64_t powers[] = {0x5e2d58d8b3bcdf1a, 0x22a555477f03973f, 0x04b0556e084f3d1d,
                                   0x0015fc21041027ac, 0x000001e355bbaee8, 0x000000000003908c};
    constexpr int whole_bits = integer_bits_of<Raw, F>();
    if (whole_bits > 6) return 0;
    const uint64_t power = powers[whole_bits > 6 ? 0 : whole_bits - 1];
    const uint64_t first_order = power >> F >> 1;
    const uint64_t second_order = first_order >> F >> 2;
    return static_cast<Raw>((power - first_order + second_order) >> ((64 - F) % 64));
}
// a must be greater than 0.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR bool log_fits(Raw a) {
    const Raw limit = log_limit<Raw, F>();
    return a > limit;
}

// The angle of (x, y) can leave [-c, c), c = 2^(I-1), if I is 1 or 2. It does if it is at least c -
// d, where d = 2^-(F+1) is half an ulp, or below -c - d, that is, if x / |y| <= cot(c -+ d). The
// constants have 62 bits: with 64-bit operands the limit is that of the angle to 2^-61, which is
// more accurate than the function itself.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR bool atan2_fits(Raw y, Raw x) {
    constexpr int whole_bits = integer_bits_of<Raw, F>();
    if (whole_bits > 2) return true;
    if (y == 0) return x >= 0;
    // |cot(c)|, 1 + cot(c)^2 and their product, in units of 2^-62: the terms of d^0, d and d^2.
    constexpr bool obtuse = whole_bits == 2;  // cot(2) is negative
    constexpr uint64_t cotangent = obtuse ? 0x1d4a42e92faa4dee : 0x29180ba09c39fb06;
    constexpr uint64_t slope = (obtuse ? 0x4d67a2ce5464d462 : 0x5a62d7ee82bc3ddf) >> F >> 1;
    constexpr uint64_t bend = (obtuse ? 0x236cc686a3a6d81e : 0x3a0947d1960d41db) >> F >> F >> 2;
    const uint64_t limit = ((y > 0) != obtuse ? cotangent + slope : cotangent - slope) + bend;
    const Word128 left = Word128(magnitude(x)) << 62;
    const Word128 right = Word128(limit) * magnitude(y);
    return obtuse ? x >= 0 || left < right : x > 0 && left > right;
}

// If 1 is out of range, a component v[i] / |v| is too if it is >= 1 - 2^-W. With n the sum of the
// other squares, that is 4 v[i]^2 > n (2^(F+2) - 3), up to a remainder below 1 between integers; it
// is impossible if n >= 2^F.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR bool normalised_fits(const Raw* v, int i) {
    using Square = DoubleWord<Raw>;
    if (integer_bits_of<Raw, F>() > 1 || v[i] <= 0) return true;
    const Square rest = static_cast<Square>(square(v[(i + 1) % 3]) + square(v[(i + 2) % 3]));
    const Square one = Square(uint8_t(1));
    if (rest >= static_cast<Square>(one << F)) return true;
    // n (2^(F+2) - 3), below 2^(2F+2).
    const Square bound =
        static_cast<Square>(static_cast<Square>(rest << (F + 2)) -
                            static_cast<Square>(rest + static_cast<Square>(rest << 1)));
    return !(static_cast<Square>(square(v[i]) << 2) > bound);
}

}  // namespace portable
}  // namespace fixedpoint
