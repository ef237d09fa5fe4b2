// SPDX-License-Identifier: MIT
// The elementary functions of Q32.32 as compositions of its kernels, some of which have an entry
// that returns guard bits too. All are faithful (error below 0.75 ulp).
#pragma once

#include <fixedpoint/kernel/dispatch.hpp>
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

// With x the distance from the nearest multiple of a quarter turn and z = x^2, the cotangent of x
// is 1/x - x p and its tangent x / (1 - z p), p = 1/3 + z/45 + 2 z^2/945 + ... Large angles and
// those near a pole need more digits of x.
struct Tan {
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR Evaluation<int64_t> apply(int64_t a) {
        const uint64_t positive = magnitude(a);
        const bool is_short = positive < uint64_t(1) << 40;
        bool negative = a < 0, odd = false;
        int64_t x = is_short ? rest_of_short(positive, odd) : 0;  // 2^-56
        // Near a pole the digits after x matter more, in proportion to the tangent.
        constexpr uint64_t near = uint64_t(1) << 46;
        if (!is_short || (odd && magnitude(x) < near)) {
            const Word128 fine = rest_of_long(positive, odd);
            x = static_cast<int64_t>(fine.high) >> 6;
            if (odd && magnitude(x) < near) {
                if (x < 0) return beside_pole(Word128() - fine, negative);
                return beside_pole(fine, !negative);
            }
        }
        if (odd) negative = !negative;
        if (x < 0) {
            x = -x;
            negative = !negative;
        }
        const int64_t x_40 = x >> 16;
        const int64_t z = multiply<int64_t, 32>(x_40, x_40);  // 2^-48
        const int64_t p =
            (int64_t(1) << 40) / 3 +
            int64_t(tail(static_cast<int32_t>(static_cast<uint32_t>(z >> 16) >> 1))) * 16;
        int64_t tangent = 0;
        if (odd) {
            const int64_t reciprocal = divide<int64_t, 32>(int64_t(1) << 62, x);  // 2^-38
            const int64_t correction = multiply<int64_t, 32>(x_40, p);            // 2^-48
            tangent = (reciprocal * 4 - (correction >> 8) + 128) >> 8;
        } else {
            const int64_t cosine = (int64_t(1) << 40) - (multiply<int64_t, 32>(z, p) >> 16);
            tangent = divide<int64_t, 32>(x_40, cosine);
        }
        return {negative ? -tangent : tangent, Outcome::in_range};
    }

  private:
    using Word128 = portable::Word128;

    // The remainder of an angle below 256 rad after subtracting whole quarter turns, in units of
    // 2^-56.
    static FIXEDPOINT_CONSTEXPR int64_t rest_of_short(uint64_t positive, bool& odd) {
        constexpr int32_t two_over_pi = 41722;                     // 2^-16
        constexpr uint32_t upper = 0x1921fb5, lower = 0x4442d184;  // of pi/2, 2^-24 and 2^-56
        constexpr uint16_t last = 0x6989;                          // 2^-72
        const uint8_t quarters = static_cast<uint8_t>(
            (multiply<int32_t, 16>(static_cast<int32_t>(positive >> 16), two_over_pi) +
             (int32_t(1) << 15)) >>
            16);
        odd = (quarters & 1) != 0;
        const uint64_t whole = (uint64_t(quarters * upper) << 32) +
                               multiply_words(quarters, lower) +
                               static_cast<uint16_t>((uint32_t(quarters) * last + 0x8000) >> 16);
        return static_cast<int64_t>((positive << 24) - whole);
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

    // p - 1/3 in units of 2^-36, within 2 units, for z in units of 2^-31 up to 0.63.
    static FIXEDPOINT_CONSTEXPR int32_t tail(int32_t z) {
        const int32_t fourth = 11562496 + multiply<int32_t, 32>(z, 2895704);  // 2^-39, 2^-40
        const int32_t third = 58206832 + multiply<int32_t, 32>(z, fourth);    // 2^-38
        const int32_t second = 290873736 + multiply<int32_t, 32>(z, third);   // 2^-37
        const int32_t first = 1527099544 + multiply<int32_t, 32>(z, second);  // 2^-36
        return multiply<int32_t, 31>(z, first);
    }
};

}  // namespace q32_32
}  // namespace kernel
}  // namespace fixedpoint
