// SPDX-License-Identifier: MIT
// The elementary functions that are made of kernels of other formats, in splits of 32 bits; the
// others have the portable code of elementary.hpp. All are faithful (error below 0.75 ulp).
//
// A kernel of a finer split has the bits behind an ulp that a function of its result needs: the
// logarithm, the root, the quotient and the angle are those of up to 30 fraction bits. Powers come
// from exp_wide, which no split of 32 bits has digits enough for.
#pragma once

#include <fixedpoint/kernel/dispatch.hpp>
#include <fixedpoint/portable/elementary.hpp>
#include <fixedpoint/portable/logarithm_of_factor_table.hpp>

namespace fixedpoint {
namespace kernel {

using portable::Evaluation;
using portable::Outcome;

namespace composed {

template <int least, int most>
struct Splits {
    static constexpr int least_fraction = least, most_fraction = most;
};

// a with 40 fraction bits, of F.
template <int F>
constexpr int64_t with_40_bits(int64_t a) {
    return a * (int64_t(1) << (40 - F));
}
// a 2^-drop, rounded half up.
template <int drop>
constexpr int32_t rounded(int32_t a) {
    return drop == 0 ? a : ((a >> (drop > 0 ? drop - 1 : 0)) + 1) >> 1;
}
// A magnitude in units of 2^-32 as the number it is nearest to, saturated.
FIXEDPOINT_IN_PLACE Evaluation<int32_t> rounded_power(uint64_t magnitude, bool negative) {
    const uint32_t limit = uint32_t(RawLimits<int32_t>::max) + (negative ? 1 : 0);
    const uint32_t whole = static_cast<uint32_t>(magnitude >> 32);
    const uint32_t result = whole + (static_cast<uint32_t>(magnitude) >> 31);
    if (whole > limit || result > limit) {
        return {negative ? RawLimits<int32_t>::min : RawLimits<int32_t>::max, Outcome::overflow};
    }
    return {with_sign<int32_t>(result, negative), Outcome::in_range};
}

// Powers.

constexpr int64_t ln2_48 = 195103586505167;  // 2^-48

struct Exp2 : Splits<9, 24> {
    template <class Raw, int F>
    static FIXEDPOINT_IN_PLACE Evaluation<Raw> apply(Raw a) {
        const Raw whole = a >> F;
        if (whole > 32) return {RawLimits<Raw>::max, Outcome::overflow};
        if (whole < -32) return {0, Outcome::in_range};
        const int64_t x = multiply<int64_t, 32>(int64_t(a * (int32_t(1) << (24 - F))), ln2_48);
        return rounded_power(exp_wide<int64_t, 40>(x, F), false);
    }
};
struct Expm1 : Splits<9, 24> {
    template <class Raw, int F>
    static FIXEDPOINT_IN_PLACE Evaluation<Raw> apply(Raw a) {
        const uint64_t one = uint64_t(1) << (32 + F);
        const uint64_t power = exp_wide<int64_t, 40>(with_40_bits<F>(a), F);
        // The error of a power next to 1 must not change the sign.
        const bool negative = power < one;
        return rounded_power(negative ? one - power : power - one, negative);
    }
};
struct Sinh : Splits<9, 24> {
    template <class Raw, int F>
    static FIXEDPOINT_IN_PLACE Evaluation<Raw> apply(Raw a) {
        const int64_t x = with_40_bits<F>(magnitude(a));
        return rounded_power(exp_wide<int64_t, 40>(x, F - 1) - exp_wide<int64_t, 40>(-x, F - 1),
                             a < 0);
    }
};
struct Cosh : Splits<9, 24> {
    template <class Raw, int F>
    static FIXEDPOINT_IN_PLACE Evaluation<Raw> apply(Raw a) {
        const int64_t x = with_40_bits<F>(magnitude(a));
        const uint64_t power = exp_wide<int64_t, 40>(x, F - 1);
        if (power >> 63 != 0) return {RawLimits<Raw>::max, Outcome::overflow};
        return rounded_power(power + exp_wide<int64_t, 40>(-x, F - 1), false);
    }
};
// (1 - e^-2|a|) / (1 + e^-2|a|), of the sign of a.
struct Tanh : Splits<9, 24> {
    template <class Raw, int F>
    static FIXEDPOINT_IN_PLACE Evaluation<Raw> apply(Raw a) {
        constexpr int32_t one = int32_t(1) << 29;
        const uint32_t positive = magnitude(a);
        int32_t quotient = one >> 1;
        if (positive < uint32_t(16) << F) {
            const int32_t power = static_cast<int32_t>(
                exp_wide<int64_t, 40>(-2 * with_40_bits<F>(positive), 29) >> 32);
            quotient = divide<int32_t, 28>(one - power, one + power);
        }
        const int32_t result = rounded<28 - F>(quotient);
        return {a < 0 ? -result : result, Outcome::in_range};
    }
};

// Logarithms: that of a 2^-fraction in `fraction` bits is (fraction - F) ln 2 too small.

template <int F>
struct FineLogarithm {
    static constexpr int fraction = F <= 20 ? 24 : 26;
    static constexpr int excess = fraction - F;
    static FIXEDPOINT_CONSTEXPR int32_t of(int32_t a) { return log<int32_t, fraction>(a); }
};
struct Log2 : Splits<9, 20> {
    template <class Raw, int F>
    static FIXEDPOINT_IN_PLACE Evaluation<Raw> apply(Raw a) {
        constexpr int32_t per_ln2_less_1 = 1901360723;  // 2^-32
        constexpr int fraction = FineLogarithm<F>::fraction;
        if (a <= 0) return portable::no_logarithm<Raw>();
        const int32_t logarithm = FineLogarithm<F>::of(a);
        const int32_t sum = logarithm + multiply<int32_t, 32>(logarithm, per_ln2_less_1) +
                            FineLogarithm<F>::excess * (int32_t(1) << fraction);
        return {rounded<fraction - F>(sum), Outcome::in_range};
    }
};
struct Log10 : Splits<9, 24> {
    template <class Raw, int F>
    static FIXEDPOINT_IN_PLACE Evaluation<Raw> apply(Raw a) {
        constexpr int32_t per_ln10 = 1865280597;    // 2^-32
        constexpr int64_t log10_of_2 = 1292913986;  // 2^-32
        constexpr int fraction = FineLogarithm<F>::fraction;
        if (a <= 0) return portable::no_logarithm<Raw>();
        const int32_t sum =
            multiply<int32_t, 32>(FineLogarithm<F>::of(a), per_ln10) +
            static_cast<int32_t>(FineLogarithm<F>::excess * log10_of_2 >> (32 - fraction));
        return {rounded<fraction - F>(sum), Outcome::in_range};
    }
};
// 1 + a fits the unsigned number, and half of it the signed one.
struct Log1p : Splits<9, 24> {
    template <class Raw, int F>
    static FIXEDPOINT_IN_PLACE Evaluation<Raw> apply(Raw a) {
        constexpr int fraction = FineLogarithm<F>::fraction;
        constexpr int64_t excess = FineLogarithm<F>::excess;
        constexpr uint32_t one = uint32_t(1) << F;
        if (a < 0 && magnitude(a) >= one) return portable::no_logarithm<Raw>();
        const uint32_t sum = one + static_cast<uint32_t>(a);
        const bool large = sum >> 31 != 0;
        const int32_t logarithm =
            FineLogarithm<F>::of(static_cast<int32_t>(large ? sum >> 1 : sum)) +
            static_cast<int32_t>((large ? (excess + 1) * ln2_48 : excess * ln2_48) >>
                                 (48 - fraction));
        return {rounded<fraction - F>(logarithm), Outcome::in_range};
    }
};
// e^(ln |a| / 3), of the sign of a.
struct Cbrt : Splits<9, 16> {
    template <class Raw, int F>
    static FIXEDPOINT_IN_PLACE Evaluation<Raw> apply(Raw a) {
        constexpr int fraction = FineLogarithm<F>::fraction;
        constexpr int64_t third = ((int64_t(1) << (72 - fraction)) + 1) / 3;
        constexpr int32_t excess =
            static_cast<int32_t>(FineLogarithm<F>::excess * ln2_48 >> (48 - fraction));
        if (a == 0) return {0, Outcome::in_range};
        const uint32_t positive = magnitude(a);
        const bool large = positive >> 31 != 0;  // the smallest number
        const int32_t logarithm =
            FineLogarithm<F>::of(static_cast<int32_t>(large ? positive >> 1 : positive)) + excess;
        const int64_t x = multiply<int64_t, 32>(logarithm, third);
        return rounded_power(exp_wide<int64_t, 40>(large ? x + ln2_48 / 768 : x, F), a < 0);
    }
};

// Angles.

// |a| 2^-F and the root of (1 - |a|) (1 + |a|), in units of 2^-28; a is not 0 and below 1.
template <int F>
FIXEDPOINT_CONSTEXPR int32_t complement(uint32_t a) {
    const uint32_t square = (a << (16 - F)) * (a << (16 - F));
    return sqrt<int32_t, 26>(static_cast<int32_t>((0 - square) >> 2));
}
template <class Raw, int F>
FIXEDPOINT_IN_PLACE Evaluation<Raw> arc(int32_t angle, Raw a) {
    return {rounded<28 - F>(angle),
            portable::beyond_one<Raw, F>(a) ? Outcome::domain_error : Outcome::in_range};
}
constexpr int32_t half_pi_28 = 421657428;
struct Asin : Splits<9, 16> {
    template <class Raw, int F>
    static FIXEDPOINT_IN_PLACE Evaluation<Raw> apply(Raw a) {
        if (portable::from_one_on<Raw, F>(a)) {
            return arc<Raw, F>(a < 0 ? -half_pi_28 : half_pi_28, a);
        }
        if (a == 0) return {0, Outcome::in_range};
        return arc<Raw, F>(
            atan2<int32_t, 28>(a * (int32_t(1) << (28 - F)), complement<F>(magnitude(a))), a);
    }
};
struct Acos : Splits<9, 16> {
    template <class Raw, int F>
    static FIXEDPOINT_IN_PLACE Evaluation<Raw> apply(Raw a) {
        if (portable::from_one_on<Raw, F>(a)) return arc<Raw, F>(a < 0 ? 2 * half_pi_28 : 0, a);
        if (a == 0) return arc<Raw, F>(half_pi_28, a);
        return arc<Raw, F>(
            atan2<int32_t, 28>(complement<F>(magnitude(a)), a * (int32_t(1) << (28 - F))), a);
    }
};

// a 2^15, modulo 2^32, by whole bytes.
constexpr uint32_t shifted_by_15(uint32_t a) {
    return (a >> 1) << 16 | ((a & 1) != 0 ? 0x8000u : 0u);
}

// The angle from the nearest whole number of quarter turns, in units of 2^-63: of |a|, which does
// not change what the tangent is but for its sign.
struct Tan : Splits<16, 16> {
    template <class Raw, int F>
    static FIXEDPOINT_IN_PLACE Evaluation<Raw> apply(Raw a) {
        constexpr int32_t two_over_pi_less_1 = -1560706194;                      // 2^-32
        constexpr uint32_t half_pi_high = 0xc90fdaa2, half_pi_low = 0x2168c235;  // 2^-31, 2^-63
        constexpr int32_t third = 1431655765;                                    // 2^-32
        const bool below_zero = a < 0;
        const int32_t turns = multiply<int32_t, 32>(a, two_over_pi_less_1) + a;
        const int16_t nearest = static_cast<int16_t>((turns + (int32_t(1) << 15)) >> 16);
        const uint16_t quarters = static_cast<uint16_t>(below_zero ? -nearest : nearest);
        const uint64_t low = uint64_t(quarters) * half_pi_low;
        const int32_t rest =
            static_cast<int32_t>(shifted_by_15(magnitude(a)) - quarters * half_pi_high -
                                 static_cast<uint32_t>(low >> 32) - 1);
        const bool odd = (quarters & 1) != 0;
        if (odd && rest < int32_t(1) << 26 && rest >= -(int32_t(1) << 26)) {
            // Beside a pole, below 2^-5: 1 / rest - rest / 3, and rest^3 / 45 is nothing.
            const int64_t fine =
                int64_t(rest) * (int64_t(1) << 32) +
                static_cast<int64_t>((uint64_t(1) << 32) - static_cast<uint32_t>(low));
            const int64_t positive = fine < 0 ? -fine : fine;
            const int64_t cotangent =
                divide<int64_t, 32>(int64_t(1) << 48, positive >> 7) -
                multiply<int32_t, 32>(static_cast<int32_t>(positive >> 39), third);
            return portable::evaluation<Raw>(static_cast<uint64_t>(cotangent), 8,
                                             (fine < 0) == below_zero);
        }
        int32_t unit[2] = {};
        sincos<int32_t, 30>(rounded<1>(rest), unit);
        const int32_t tangent =
            odd ? -divide<int32_t, 24>(unit[1], unit[0]) : divide<int32_t, 24>(unit[0], unit[1]);
        return {rounded<24 - F>(below_zero ? -tangent : tangent), Outcome::in_range};
    }
};

// x^y = e^(y ln x). The logarithm is as exact as the largest y asks for: in units of 2^-56 and,
// near 1, within 2^-45 of itself. A factor of the table brings x near 1, to 1 + s, |s| < 0.016,
// whose logarithm is s - s^2 (1/2 - s/3 + s^2/4 - s^3/5 + s^4/6).
FIXEDPOINT_CONSTEXPR int64_t logarithm_56(uint32_t x) {
    using portable::LogarithmOfFactor;
    int8_t exponent = 15;
    while (x >> 31 == 0) {
        x <<= 1;
        --exponent;
    }
    const uint8_t node = static_cast<uint8_t>((static_cast<uint8_t>(x >> 24) - 127) >> 1);
    const uint32_t factor = 256u - read_program_memory(LogarithmOfFactor<>::decrease[node]);
    const int64_t s = static_cast<int64_t>(uint64_t(x) * factor - (uint64_t(1) << 39));  // 2^-39
    const int32_t z = static_cast<int32_t>(s >> 2);                                      // 2^-37
    const int32_t fifth = 13107 - multiply<int32_t, 32>(z, 341);        // 1/5 - s/6, 2^-16
    const int32_t fourth = 524288 - multiply<int32_t, 32>(z, fifth);    // 1/4 - ..., 2^-21
    const int32_t third = 22369621 - multiply<int32_t, 32>(z, fourth);  // 1/3 - ..., 2^-26
    const int32_t half = 1073741824 - multiply<int32_t, 32>(z, third);  // 1/2 - ..., 2^-31
    const int64_t bend = multiply<int64_t, 32>(s * (1 << 11), half);    // 2^-49
    return s * (int32_t(1) << 17) - multiply<int64_t, 32>(s, bend) +
           static_cast<int64_t>(read_program_memory(LogarithmOfFactor<>::logarithm[node])) +
           exponent * LogarithmOfFactor<>::ln2();
}
struct PowerOfMagnitude {
    template <class Raw, int F>
    static FIXEDPOINT_IN_PLACE Evaluation<Raw> apply(uint32_t x, Raw y, bool negative) {
        const int64_t product = multiply<int64_t, 32>(logarithm_56(x), y);
        return rounded_power(exp_wide<int64_t, 40>(product, F), negative);
    }
};
struct Pow : Splits<16, 16>, portable::SignedPower<PowerOfMagnitude> {};

}  // namespace composed

// Composition where it serves a format, else Portable.
template <class Composition, class Portable, bool serves>
struct Choice {
    using Type = Composition;
};
template <class Composition, class Portable>
struct Choice<Composition, Portable, false> {
    using Type = Portable;
};
template <class Composition, class Portable>
struct Composed {
    template <class Raw, int F, class... Operands>
    static FIXEDPOINT_IN_PLACE Evaluation<Raw> apply(Operands... a) {
        using Chosen = typename Choice<Composition, Portable,
                                       sizeof(Raw) == 4 && F >= Composition::least_fraction &&
                                           F <= Composition::most_fraction>::Type;
        return Chosen::template apply<Raw, F>(a...);
    }
};

#define FIXEDPOINT_COMPOSED(name, Function) \
    using Function = Composed<composed::Function, portable::Function>;
FIXEDPOINT_ELEMENTARY_FUNCTIONS(FIXEDPOINT_COMPOSED)
#undef FIXEDPOINT_COMPOSED

}  // namespace kernel
}  // namespace fixedpoint
