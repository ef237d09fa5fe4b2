// SPDX-License-Identifier: MIT
// The elementary functions of Q32.32 as compositions of its kernels, some of which have an entry
// that returns guard bits too. All are faithful (error below 0.75 ulp).
#pragma once

#include <fixedpoint/kernel/dispatch.hpp>
#include <fixedpoint/kernel/words.hpp>
#include <fixedpoint/portable/elementary.hpp>

namespace fixedpoint {
namespace kernel {

// Whether f(a) = a + c a^3 + ..., |c| <= 1/3, is within 1/3 ulp of a itself.
template <int F, class Magnitude>
constexpr bool is_nearly_linear(Magnitude positive) {
    return positive < Magnitude(1) << (F - (F + 2) / 3);
}

namespace q32_32 {

using portable::Evaluation;
using portable::Outcome;

constexpr int64_t one = int64_t(1) << 32;
constexpr int64_t largest = RawLimits<int64_t>::max;

constexpr Evaluation<int64_t> overflow(bool negative) {
    return {negative ? RawLimits<int64_t>::min : largest, Outcome::overflow};
}

// Powers.

struct Exp2 {
    template <class Raw, int F>
    static FIXEDPOINT_IN_PLACE Evaluation<int64_t> apply(int64_t a) {
        const int32_t whole = static_cast<int32_t>(a >> 32);
        if (whole >= 31) return overflow(false);
        return {whole < -33 ? 0 : exp2_unsaturated<int64_t, 32>(a), Outcome::in_range};
    }
};
struct Expm1 {
    template <class Raw, int F>
    static FIXEDPOINT_IN_PLACE Evaluation<int64_t> apply(int64_t a) {
        constexpr int64_t limit = 92288378629, limit_of_exp = limit - 2;
        if (a >= limit) return overflow(false);
        if (a >= limit_of_exp) {
            return {a == limit_of_exp ? 9223372033833837081 : 9223372035981320730,
                    Outcome::in_range};
        }
        return {exp<int64_t, 32>(a) - one, Outcome::in_range};
    }
};

// The kernel's power is unsigned and has 64 bits, of which the format has 63.
struct PowerOfMagnitude {
    template <class Raw, int F>
    static FIXEDPOINT_IN_PLACE Evaluation<int64_t> apply(uint64_t x, int64_t y, bool negative) {
        const uint64_t power =
            static_cast<uint64_t>(pow_unsaturated<int64_t, 32>(static_cast<int64_t>(x), y));
        if (power > uint64_t(largest) + (negative ? 1 : 0)) return overflow(negative);
        return {with_sign<int64_t>(power, negative), Outcome::in_range};
    }
};
struct Pow : portable::SignedPower<PowerOfMagnitude> {};

constexpr uint64_t limit_of_hyperbolic = 95265423099;  // 32 ln 2

struct Sinh {
    template <class Raw, int F>
    static FIXEDPOINT_IN_PLACE Evaluation<int64_t> apply(int64_t a) {
        const uint64_t positive = magnitude(a);
        if (is_nearly_linear<F>(positive)) return {a, Outcome::in_range};
        if (positive >= limit_of_hyperbolic) return overflow(a < 0);
        const int64_t sine = sinh_unsaturated<int64_t, 32>(static_cast<int64_t>(positive));
        return {a < 0 ? -sine : sine, Outcome::in_range};
    }
};
struct Cosh {
    template <class Raw, int F>
    static FIXEDPOINT_IN_PLACE Evaluation<int64_t> apply(int64_t a) {
        const uint64_t positive = magnitude(a);
        if (positive >= limit_of_hyperbolic) return overflow(false);
        return {cosh_unsaturated<int64_t, 32>(static_cast<int64_t>(positive)), Outcome::in_range};
    }
};
// (1 - e^-2|a|) / (1 + e^-2|a|), with the sign of a.
struct Tanh {
    template <class Raw, int F>
    static FIXEDPOINT_IN_PLACE Evaluation<int64_t> apply(int64_t a) {
        constexpr uint64_t limit_of_power = uint64_t(23) << 31, limit_below_one = 50609756021;
        constexpr int64_t fine_one = int64_t(1) << 40;
        const uint64_t positive = magnitude(a);
        if (is_nearly_linear<F>(positive)) return {a, Outcome::in_range};
        int64_t tangent = positive < limit_below_one ? one - 1 : one;
        if (positive <= limit_of_power) {
            const int64_t power = exp_fine<int64_t, 32>(-2 * static_cast<int64_t>(positive));
            tangent = divide<int64_t, 32>(fine_one - power, fine_one + power);
        }
        return {a < 0 ? -tangent : tangent, Outcome::in_range};
    }
};

// Logarithms to base b, given 1 / ln b in units of 2^-41. `half` is half an ulp in units of 2^-48,
// less what log_fine adds.
template <int64_t per_ln_b, int64_t half>
struct LogarithmToBase {
    template <class Raw, int F>
    static FIXEDPOINT_IN_PLACE Evaluation<int64_t> apply(int64_t a) {
        if (a <= 0) return portable::no_logarithm<int64_t>();
        const int64_t natural = log_fine<int64_t, 32>(a);
        return {(multiply<int64_t, 32>(natural, per_ln_b) + half) >> 16, Outcome::in_range};
    }
};
struct Log2 : LogarithmToBase<3172519945584, -14506> {};
struct Log10 : LogarithmToBase<955023665463, 18537> {};

struct Cbrt {
    template <class Raw, int F>
    static FIXEDPOINT_IN_PLACE Evaluation<int64_t> apply(int64_t a) {
        return {cbrt<int64_t, 32>(a), Outcome::in_range};
    }
};

// Angles.

// With x the distance from the nearest multiple of a quarter turn, a kernel has the tangent of x
// and its cotangent up to 16/3. A larger one is 1/x - x p, z = x^2, p = 1/3 + z/45 + 2 z^2/945 +
// ...; in units of 2^-40, it errs by 11, and by 22 more for x = 2^-10, since x is up to 1.4 2^-56
// off. Large angles and those near a pole need more digits of x.
struct Tan {
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR Evaluation<int64_t> apply(int64_t a) {
        const Words raw = words(static_cast<uint64_t>(a));
        bool negative = raw.is_negative(), odd = false;
        const Words positive = negative ? raw.negated() : raw;
        const bool is_short = positive.upper < uint32_t(1) << 8;
        Words x = is_short ? rest_of_short(positive, odd) : raw;  // 2^-56
        // Near a pole the digits after x matter more, in proportion to the tangent.
        if (!is_short || (odd && is_near(x))) {
            const Word128 fine = rest_of_long(join_words(positive.upper, positive.lower), odd);
            x = words(static_cast<uint64_t>(static_cast<int64_t>(fine.high) >> 6));
            if (odd && is_near(x)) {
                if (x.is_negative()) return beside_pole(Word128() - fine, negative);
                return beside_pole(fine, !negative);
            }
        }
        if (odd) negative = !negative;
        if (x.is_negative()) {
            x = x.negated();
            negative = !negative;
        }
        const int64_t distance = static_cast<int64_t>(join_words(x.upper, x.lower));
        const int64_t tangent = odd && x.upper < uint32_t(3) << 20
                                    ? large_cotangent(distance)
                                    : tan_of_rest<int64_t, 32>(distance, odd ? 1 : 0);
        return {negative ? -tangent : tangent, Outcome::in_range};
    }

  private:
    using Word128 = portable::Word128;

    // A 64-bit number. The chip's compiler handles two words with fewer moves.
    struct Words {
        uint32_t upper, lower;

        constexpr bool is_negative() const { return static_cast<int32_t>(upper) < 0; }
        constexpr Words negated() const { return {~upper + (lower == 0 ? 1 : 0), 0 - lower}; }
    };
    static FIXEDPOINT_IN_PLACE Words words(uint64_t a) {
        return {upper_word(a), static_cast<uint32_t>(a)};
    }

    // Whether x, in units of 2^-56, is in -2^-10 .. 2^-10 - 2^-56.
    static constexpr bool is_near(Words x) {
        return x.upper + (uint32_t(1) << 14) < uint32_t(1) << 15;
    }

    // The remainder of an angle below 256 rad after subtracting whole quarter turns, in units of
    // 2^-56. Its magnitude is at most pi/4 + 2^-22.
    static FIXEDPOINT_IN_PLACE Words rest_of_short(Words positive, bool& odd) {
        constexpr uint32_t two_over_pi = 0xa2f9836e;                        // 2^-32
        constexpr uint64_t half_pi_less_1 = 0x921fb54442d1846a;             // 2^-64
        const uint32_t angle = positive.upper << 24 | positive.lower >> 8;  // 2^-24
        const uint8_t quarters = static_cast<uint8_t>(
            upper_half(upper_product<uint32_t, 0>(angle, two_over_pi) + (uint32_t(1) << 23)) >> 8);
        odd = (quarters & 1) != 0;
        return words(join_words(angle - (uint32_t(quarters) << 24), positive.lower << 24) -
                     byte_fraction<uint64_t, 0>(half_pi_less_1, quarters));
    }

    // 1/x - x p for x from 2^-10 to 3/16, in units of 2^-56.
    static FIXEDPOINT_CONSTEXPR int64_t large_cotangent(int64_t x) {
        const int32_t x_32 = static_cast<int32_t>(x >> 24);
        const int32_t z = multiply<int32_t, 32>(x_32, x_32);                   // 2^-32
        const int32_t third = 145436868 + multiply<int32_t, 32>(z, 14570000);  // 2^-36
        const int32_t second = 1527099544 + multiply<int32_t, 32>(z, third);   // 2^-36
        const int64_t p = (int64_t(1) << 40) / 3 + int64_t(multiply<int32_t, 32>(z, second)) * 16;
        const int64_t reciprocal = divide<int64_t, 32>(int64_t(1) << 62, x);  // 2^-38
        const int64_t correction = multiply<int64_t, 32>(x >> 16, p);         // 2^-48
        return (reciprocal * 4 - (correction >> 8) + 128) >> 8;
    }

    // The remainder of any angle after subtracting whole quarter turns, in units of 2^-126.
    static FIXEDPOINT_CONSTEXPR Word128 rest_of_long(uint64_t positive, bool& odd) {
        const uint32_t high = static_cast<uint32_t>(positive >> 32),
                       low = static_cast<uint32_t>(positive);
        // 2/pi in units of 2^-32 and 2^-64, the quarters in units of 2^-32.
        constexpr uint32_t per_half_pi[2] = {0xa2f9836e, 0x4e441529};
        const uint32_t quarters = static_cast<uint32_t>(
            (multiply_words(high, per_half_pi[0]) + (multiply_words(high, per_half_pi[1]) >> 32) +
             (multiply_words(low, per_half_pi[0]) >> 32) + (uint32_t(1) << 31)) >>
            32);
        odd = (quarters & 1) != 0;
        // pi/2 in units of 2^-30, 2^-62, 2^-94, 2^-126 and 2^-142.
        constexpr uint32_t half_pi[4] = {0x6487ed51, 0x10b4611a, 0x62633145, 0xc06e0e68};
        constexpr uint16_t last = 0x9481;
        const uint64_t third = multiply_words(quarters, half_pi[2]);
        const Word128 upper(multiply_words(quarters, half_pi[1]) +
                                (uint64_t(quarters * half_pi[0]) << 32) + (third >> 32),
                            third << 32);
        const Word128 lower(0, multiply_words(quarters, half_pi[3]) +
                                   uint32_t(static_cast<uint16_t>(quarters >> 16)) * last);
        return Word128(positive << 30, 0) - upper - lower;
    }

    // 1/x - x/3 for x below 2^-10, which is in units of 2^-126.
    static FIXEDPOINT_CONSTEXPR Evaluation<int64_t> beside_pole(Word128 x, bool negative) {
        if (x.high >> 31 == 0) return overflow(negative);
        const int32_t third = multiply<int32_t, 32>(static_cast<int32_t>(x.high >> 22),
                                                    0x55555555);  // 2^-40
        uint8_t zeros = 0;
        for (; static_cast<uint8_t>(x.high >> 56) == 0; zeros = static_cast<uint8_t>(zeros + 8))
            x = x << 8;
        for (; static_cast<int64_t>(x.high) >= 0; ++zeros) {
            x.high += x.high + (static_cast<int64_t>(x.low) < 0 ? 1 : 0);
            x.low += x.low;
        }
        // The reciprocal of the upper 63 bits, then a correction from the remainder of all bits.
        const uint64_t upper = x.high >> 1;
        const uint64_t first = static_cast<uint64_t>(
            divide<int64_t, 32>(int64_t(1) << 62, static_cast<int64_t>(upper)));
        const uint32_t behind = (static_cast<uint32_t>(x.low >> 32) >> 1) |
                                ((static_cast<uint8_t>(x.high) & 1) != 0 ? uint32_t(1) << 31 : 0);
        const int64_t left = static_cast<int64_t>(
            0 - first * upper -
            (multiply_words(static_cast<uint32_t>(first - (first >> 32)), behind) >> 32));
        const int64_t second = divide<int64_t, 32>(left * 2, static_cast<int64_t>(upper));
        const int64_t fraction = (second * 64 >> (32 - zeros)) - third;  // 2^-40
        const uint64_t cotangent =
            (first << (zeros - 1)) + static_cast<uint64_t>((fraction + 128) >> 8);
        if (cotangent > uint64_t(largest) + (negative ? 1 : 0)) return overflow(negative);
        return {with_sign<int64_t>(cotangent, negative), Outcome::in_range};
    }
};

}  // namespace q32_32
}  // namespace kernel
}  // namespace fixedpoint
