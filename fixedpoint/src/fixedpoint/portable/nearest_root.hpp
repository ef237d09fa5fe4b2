// SPDX-License-Identifier: MIT
// Correctly rounded square roots of integers and of ratios, by shift and subtract. sqrt,
// reciprocal_sqrt, length and normalise use them.
#pragma once

#include <fixedpoint/portable/double_word.hpp>

namespace fixedpoint {
namespace portable {

// sqrt(high 2^W + low) rounded to nearest, never a tie; at most `limit`. Digit by digit: two bits
// of the radicand give one bit of the root. A limit of 2^(W-1) is returned as the smallest number
// with a sign, which is its negative.
template <class Raw, uint64_t limit = static_cast<Unsigned<Raw>>(RawLimits<Raw>::max)>
FIXEDPOINT_CONSTEXPR Raw nearest_root(Unsigned<Raw> high, Unsigned<Raw> low) {
    using Word = Unsigned<Raw>;
    constexpr int W = RawLimits<Raw>::width;
    constexpr Word quarter = static_cast<Word>(Word(1) << (W - 2));
    if (RawLimits<Raw>::is_signed && high >= quarter) return static_cast<Raw>(limit);
    Word root = 0, remainder = 0, digits = high;
    int pair = 0;
    // The part of the remainder above W bits: only after the last pair, and only without a sign,
    // it is not 0.
    uint8_t above = 0;
    // Leading zeros do not give digits.
    for (; pair < W / 2 && digits < quarter; ++pair) digits = static_cast<Word>(digits << 2);
    for (; pair < W; ++pair) {
        if (pair == W / 2) digits = low;
        // 4 remainder + digit >= 4 root + 1, without overflow. The new remainder is at most twice
        // the new root and fits.
        const bool one = static_cast<Word>(remainder + (digits >= quarter ? 1 : 0)) > root;
        if (!RawLimits<Raw>::is_signed) above = static_cast<uint8_t>(remainder >> (W - 2));
        // One bit at a time: the device does not have a shift by 30.
        remainder = static_cast<Word>((remainder << 1) | (digits >> (W - 1)));
        digits = static_cast<Word>(digits << 1);
        remainder = static_cast<Word>((remainder << 1) | (digits >> (W - 1)));
        digits = static_cast<Word>(digits << 1);
        root = static_cast<Word>(root << 1);
        // Without a branch: on the host its misprediction would cost more than the iteration.
        const Word mask = static_cast<Word>(-static_cast<int>(one));
        const Word subtrahend = static_cast<Word>(static_cast<Word>((root << 1) | 1) & mask);
        if (!RawLimits<Raw>::is_signed) {
            above = static_cast<uint8_t>(above - ((root & mask) >> (W - 1)) -
                                         (remainder < subtrahend ? 1 : 0));
        }
        remainder = static_cast<Word>(remainder - subtrahend);
        root = static_cast<Word>(root | (mask & 1));
    }
    // remainder > root: the radicand exceeds (root + 1/2)^2 = root^2 + root + 1/4.
    const Word rounded = static_cast<Word>(root + (above != 0 || remainder > root ? 1 : 0));
    return static_cast<Raw>(rounded > static_cast<Word>(limit) ? static_cast<Word>(limit)
                                                               : rounded);
}

template <class Raw>
FIXEDPOINT_CONSTEXPR Raw nearest_root(DoubleWord<Raw> radicand) {
    return nearest_root<Raw>(DoubleWordOf<Raw>::high(radicand), DoubleWordOf<Raw>::low(radicand));
}

// sqrt(numerator 2^doublings / denominator) rounded to nearest, half up; at most `limit`, as above.
// Requires numerator < 2 denominator. Number may be any unsigned integer that can represent both.
template <class Raw, class Number, uint64_t limit = static_cast<Unsigned<Raw>>(RawLimits<Raw>::max)>
FIXEDPOINT_CONSTEXPR Raw nearest_root_of_ratio(Number numerator, Number denominator,
                                               int doublings) {
    using Word = Unsigned<Raw>;
    constexpr int W = RawLimits<Raw>::width;
    Word high = 0, low = 0;
    Number remainder = numerator;
    bool carry = false;
    for (int round = 0; round <= doublings; ++round) {
        if (round > 0) {
            if (high >> (W - 2) != 0) return static_cast<Raw>(limit);
            high = static_cast<Word>((high << 1) | (low >> (W - 1)));
            low = static_cast<Word>(low << 1);
            const Number doubled = static_cast<Number>(remainder << 1);
            carry = doubled < remainder;
            remainder = doubled;
        }
        if (carry || !(remainder < denominator)) {
            remainder = static_cast<Number>(remainder - denominator);
            low = static_cast<Word>(low | 1);
        }
    }
    // A ratio x reaches (r + 1/2)^2 when x + 3/4 reaches the integer r^2 + r + 1: the root of
    // floor(x + 3/4) rounds like that of x.
    const Number left = static_cast<Number>(denominator - remainder);
    if (!(remainder < left) ||
        !(static_cast<Number>(remainder << 1) < static_cast<Number>(left - remainder))) {
        low = static_cast<Word>(low + 1);
        if (low == 0) high = static_cast<Word>(high + 1);
    }
    return nearest_root<Raw, limit>(high, low);
}

}  // namespace portable
}  // namespace fixedpoint
