// SPDX-License-Identifier: MIT
// The elementary functions as compositions of kernels. They exist for the 32-bit formats with 9 to
// 24 fraction bits (tan and pow with 16 to 24) and for Q32.32 (elementary_q32_32.hpp); the 64-bit
// formats with 31 to 52 fraction bits have the logarithms (elementary_fine.hpp). All other formats
// use the portable code of portable/elementary.hpp. All are faithful (error below 0.75 ulp). exp2,
// log2, asin and acos of Q16.16 have kernels of their own.
//
// The kernel of a finer format supplies the guard bits: its error and the error that the
// composition adds before the final rounding stay below 0.2 ulp together. Powers come from
// exp_wide, since no 32-bit format has enough digits for them.
#pragma once

#include <fixedpoint/kernel/dispatch.hpp>
#include <fixedpoint/kernel/elementary_fine.hpp>
#include <fixedpoint/kernel/elementary_q32_32.hpp>
#include <fixedpoint/portable/elementary.hpp>
#include <fixedpoint/portable/logarithm_of_factor_table.hpp>

namespace fixedpoint {
namespace kernel {

using portable::Evaluation;
using portable::Outcome;

// First if the condition is true, else Second.
template <class First, class Second, bool condition>
struct Choice {
    using Type = First;
};
template <class First, class Second>
struct Choice<First, Second, false> {
    using Type = Second;
};

namespace composed {

// The formats that a composition serves: those of 32 bits with least..most fraction bits.
template <int least, int most>
struct Splits {
    template <class Raw, int F>
    static constexpr bool serves() {
        return sizeof(Raw) == 4 && F >= least && F <= most;
    }
};

// a, with F fraction bits, with 40.
template <int F>
constexpr int64_t with_40_bits(int64_t a) {
    return a * (int64_t(1) << (40 - F));
}
// a 2^-drop, rounded half up. a + 2^(drop-1) must not overflow.
template <int drop, class Integer>
constexpr Integer rounded(Integer a) {
    return drop == 0 ? a : (a + (Integer(1) << (drop > 0 ? drop - 1 : 0))) >> drop;
}
// A magnitude in units of 2^-32 and a sign, rounded to the nearest number and saturated.
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
        const int32_t scaled = a * (int32_t(1) << (24 - F));  // at most 33 2^24
        const int64_t x = multiply<int64_t, 32>(scaled, ln2_48);
        return rounded_power(exp_wide<int64_t, 40>(x, F), false);
    }
};
template <>
FIXEDPOINT_IN_PLACE Evaluation<int32_t> Exp2::apply<int32_t, 16>(int32_t a) {
    const int16_t whole = static_cast<int16_t>(a >> 16);
    if (whole >= 15) return {RawLimits<int32_t>::max, Outcome::overflow};
    return {whole < -17 ? 0 : exp2_unsaturated<int32_t, 16>(a), Outcome::in_range};
}
struct Expm1 : Splits<9, 24> {
    template <class Raw, int F>
    static FIXEDPOINT_IN_PLACE Evaluation<Raw> apply(Raw a) {
        const uint64_t one = uint64_t(1) << (32 + F);
        const uint64_t power = exp_wide<int64_t, 40>(with_40_bits<F>(a), F);
        // The error of a power close to 1 must not change the sign.
        const bool negative = power < one;
        return rounded_power(negative ? one - power : power - one, negative);
    }
};
struct Sinh : Splits<9, 24> {
    template <class Raw, int F>
    static FIXEDPOINT_IN_PLACE Evaluation<Raw> apply(Raw a) {
        const uint32_t positive = magnitude(a);
        if (is_nearly_linear<F>(positive)) return {a, Outcome::in_range};
        const int64_t x = with_40_bits<F>(positive);
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
// (1 - e^-2|a|) / (1 + e^-2|a|), with the sign of a.
struct Tanh : Splits<9, 24> {
    template <class Raw, int F>
    static FIXEDPOINT_IN_PLACE Evaluation<Raw> apply(Raw a) {
        constexpr int32_t one = int32_t(1) << 29;
        const uint32_t positive = magnitude(a);
        if (is_nearly_linear<F>(positive)) return {a, Outcome::in_range};
        int32_t result = int32_t(1) << F;
        if (positive < uint32_t(16) << F) {
            const int32_t power = static_cast<int32_t>(
                exp_wide<int64_t, 40>(-2 * with_40_bits<F>(positive), 29) >> 32);
            result = rounded<28 - F>(divide<int32_t, 28>(one - power, one + power));
        }
        return {a < 0 ? -result : result, Outcome::in_range};
    }
};

// Logarithms. `of` is that of a 2^-fraction, in units of 2^-fraction:

template <class Wide>
struct NaturalLogarithm;
template <>
struct NaturalLogarithm<int32_t> {
    static constexpr int fraction = 24, scale = 30;
    static constexpr int32_t ln2 = 11629080;
    static FIXEDPOINT_CONSTEXPR int32_t of(uint32_t a) {
        return a >> 31 != 0 ? log<int32_t, 24>(static_cast<int32_t>(a >> 1)) + ln2
                            : log<int32_t, 24>(static_cast<int32_t>(a));
    }
};
template <>
struct NaturalLogarithm<int64_t> {
    static constexpr int fraction = 32, scale = 32;
    static constexpr int64_t ln2_11_times = 32747489190;  // within 0.02 units
    static FIXEDPOINT_CONSTEXPR int64_t of(uint64_t a) {
        return a >> 63 != 0 ? log<int64_t, 32>(static_cast<int64_t>(a >> 11)) + ln2_11_times
                            : log<int64_t, 32>(static_cast<int64_t>(a));
    }
};
// The logarithm of a 2^-F, which is `excess` ln 2 more, in the same units.
template <int F>
struct LogarithmOf {
    using Wide = typename Choice<int32_t, int64_t, (F <= 16)>::Type;
    static constexpr int fraction = NaturalLogarithm<Wide>::fraction;
    static constexpr int64_t excess = fraction - F;
    static FIXEDPOINT_CONSTEXPR Wide natural(Unsigned<Wide> a) {
        return NaturalLogarithm<Wide>::of(a) +
               static_cast<Wide>((excess * ln2_48 + (int64_t(1) << (47 - fraction))) >>
                                 (48 - fraction));
    }
    // To base b, given 1 / ln b in units of 2^-34 and log_b 2 in units of 2^-32.
    template <int64_t per_ln_b, int64_t log_b_of_2>
    static FIXEDPOINT_CONSTEXPR Wide to_base(Unsigned<Wide> a) {
        constexpr int scale = NaturalLogarithm<Wide>::scale, drop = 34 - scale;
        constexpr Wide factor = static_cast<Wide>((per_ln_b + (1 << (drop - 1))) >> drop);
        return multiply<Wide, scale>(NaturalLogarithm<Wide>::of(a), factor) +
               static_cast<Wide>(excess * log_b_of_2 >> (32 - fraction));
    }
    template <class Raw>
    static FIXEDPOINT_IN_PLACE Evaluation<Raw> evaluation(Wide logarithm) {
        return {static_cast<Raw>(rounded<fraction - F>(logarithm)), Outcome::in_range};
    }
};
struct Log2 : Splits<9, 24> {
    template <class Raw, int F>
    static FIXEDPOINT_IN_PLACE Evaluation<Raw> apply(Raw a) {
        if (a <= 0) return portable::no_logarithm<Raw>();
        return LogarithmOf<F>::template evaluation<Raw>(
            LogarithmOf<F>::template to_base<24785312075, int64_t(1) << 32>(
                static_cast<Unsigned<Raw>>(a)));
    }
};
template <>
FIXEDPOINT_IN_PLACE Evaluation<int32_t> Log2::apply<int32_t, 16>(int32_t a) {
    return {log2<int32_t, 16>(a), a > 0 ? Outcome::in_range : Outcome::domain_error};
}
struct Log10 : Splits<9, 24> {
    template <class Raw, int F>
    static FIXEDPOINT_IN_PLACE Evaluation<Raw> apply(Raw a) {
        if (a <= 0) return portable::no_logarithm<Raw>();
        return LogarithmOf<F>::template evaluation<Raw>(
            LogarithmOf<F>::template to_base<7461122386, 1292913986>(
                static_cast<Unsigned<Raw>>(a)));
    }
};
// As an unsigned number, 1 + a always fits.
struct Log1p : Splits<9, 24> {
    template <class Raw, int F>
    static FIXEDPOINT_IN_PLACE Evaluation<Raw> apply(Raw a) {
        constexpr Unsigned<Raw> one = Unsigned<Raw>(1) << F;
        if (a < 0 && magnitude(a) >= one) return portable::no_logarithm<Raw>();
        return LogarithmOf<F>::template evaluation<Raw>(
            LogarithmOf<F>::natural(one + static_cast<Unsigned<Raw>>(a)));
    }
};
// e^(ln |a| / 3), with the sign of a.
struct Cbrt : Splits<9, 24> {
    template <class Raw, int F>
    static FIXEDPOINT_IN_PLACE Evaluation<Raw> apply(Raw a) {
        constexpr int64_t third = ((int64_t(1) << (72 - LogarithmOf<F>::fraction)) + 1) / 3;
        if (a == 0) return {0, Outcome::in_range};
        const int64_t x = multiply<int64_t, 32>(LogarithmOf<F>::natural(magnitude(a)), third);
        return rounded_power(exp_wide<int64_t, 40>(x, F), a < 0);
    }
};

// Angles.

// The right triangle with the legs a 2^-F < 1 and sqrt(1 - (a 2^-F)^2), whose radicand is exact.
// Sides are in units of 2^-side, angles in units of 2^-angle. a must not be 0.
template <class Raw>
struct Triangle;
template <>
struct Triangle<int32_t> {
    static constexpr int side = 24, angle = 24;
    static constexpr int32_t half_pi = 26353589, pi = 52707179;
    template <int F>
    static FIXEDPOINT_CONSTEXPR int32_t root(uint32_t a) {
        return sqrt<int32_t, 18>(static_cast<int32_t>((0 - (a * a << (32 - 2 * F))) >> 2));
    }
};
template <>
struct Triangle<int64_t> {
    static constexpr int side = 48, angle = 32;
    static constexpr int64_t half_pi = 6746518852, pi = 13493037705;
    template <int F>
    static FIXEDPOINT_CONSTEXPR int64_t root(uint32_t a) {
        const uint32_t positive = a << (F < 32 ? 31 - F : 0);
        const uint64_t square = uint64_t(positive) * positive;
        return 2 * sqrt<int64_t, 32>(static_cast<int64_t>(F < 32 ? (uint64_t(1) << 62) - square
                                                                 : (0 - square) >> 2));
    }
};
template <class Raw, int F>
struct Arc {
    using Wide = typename Choice<int32_t, int64_t, (F <= 16)>::Type;
    using Sides = Triangle<Wide>;
    static constexpr Wide side(Raw a) {
        return static_cast<Wide>(a) * (Wide(1) << (Sides::side - F));
    }
    static FIXEDPOINT_CONSTEXPR Wide other_side(Raw a) {
        return Sides::template root<F>(static_cast<uint32_t>(magnitude(a)));
    }
    static FIXEDPOINT_IN_PLACE Evaluation<Raw> evaluation(Wide angle, Raw a) {
        return {static_cast<Raw>(rounded<Sides::angle - F>(angle)),
                portable::beyond_one<Raw, F>(a) ? Outcome::domain_error : Outcome::in_range};
    }
};
struct Asin : Splits<9, 28> {
    template <class Raw, int F>
    static FIXEDPOINT_IN_PLACE Evaluation<Raw> apply(Raw a) {
        using A = Arc<Raw, F>;
        using Sides = typename A::Sides;
        if (portable::from_one_on<Raw, F>(a)) {
            return A::evaluation(a < 0 ? -Sides::half_pi : Sides::half_pi, a);
        }
        if (is_nearly_linear<F>(magnitude(a))) return {a, Outcome::in_range};
        return A::evaluation(atan2<typename A::Wide, Sides::angle>(A::side(a), A::other_side(a)),
                             a);
    }
};
struct Acos : Splits<9, 28> {
    template <class Raw, int F>
    static FIXEDPOINT_IN_PLACE Evaluation<Raw> apply(Raw a) {
        using A = Arc<Raw, F>;
        using Sides = typename A::Sides;
        if (portable::from_one_on<Raw, F>(a)) return A::evaluation(a < 0 ? Sides::pi : 0, a);
        if (a == 0) return A::evaluation(Sides::half_pi, a);
        return A::evaluation(atan2<typename A::Wide, Sides::angle>(A::other_side(a), A::side(a)),
                             a);
    }
};
// The outcome of the arc functions of Q16.16, which have kernels of their own.
constexpr Outcome arc_outcome_q16_16(int32_t a) {
    return portable::beyond_one<int32_t, 16>(a) ? Outcome::domain_error : Outcome::in_range;
}
template <>
FIXEDPOINT_IN_PLACE Evaluation<int32_t> Asin::apply<int32_t, 16>(int32_t a) {
    return {asin<int32_t, 16>(a), arc_outcome_q16_16(a)};
}
template <>
FIXEDPOINT_IN_PLACE Evaluation<int32_t> Acos::apply<int32_t, 16>(int32_t a) {
    return {acos<int32_t, 16>(a), arc_outcome_q16_16(a)};
}

// Near a pole the tangent is 1 / rest - rest (1/3 + rest^2 / 45 + 2 rest^4 / 945 + ...). With few
// fraction bits, a rest below 2^-5 needs only the first term; with more, a rest below 3/8 needs the
// first four.
template <int F, bool few = (F <= 16)>
struct Pole {
    static constexpr int32_t reach = int32_t(1) << 26;  // 2^-31
    static constexpr int32_t series(int32_t) { return 1431655765; }
};
template <int F>
struct Pole<F, false> {
    static constexpr int32_t reach = int32_t(3) << 28;
    static FIXEDPOINT_CONSTEXPR int32_t series(int32_t rest) {
        const int32_t square = multiply<int32_t, 32>(rest, rest);                   // 2^-30
        const int32_t third = 145438046 + multiply<int32_t, 32>(square, 58175218);  // 2^-36
        const int32_t second = 381774871 + multiply<int32_t, 32>(square, third);    // 2^-34
        return 1431655765 + multiply<int32_t, 32>(square, second);                  // 2^-32
    }
};
// `rest` is the distance of |a| from the nearest multiple of a quarter turn, in units of 2^-31,
// with 32 more bits in `fine`. Working on |a| is enough: the tangent of a differs only in its sign.
struct Tan : Splits<16, 24> {
    template <class Raw, int F>
    static FIXEDPOINT_IN_PLACE Evaluation<Raw> apply(Raw a) {
        constexpr int32_t two_over_pi_less_1 = -1560706194;                      // 2^-32
        constexpr uint32_t half_pi_high = 0xc90fdaa2, half_pi_low = 0x2168c235;  // 2^-31, 2^-63
        constexpr uint16_t half_pi_third = half_pi_low >> 16, half_pi_fourth = half_pi_low & 0xffff;
        constexpr int fraction = F <= 20 ? F + 8 : 28;
        const bool below_zero = a < 0;
        const int32_t turns = multiply<int32_t, 32>(a, two_over_pi_less_1) + a;
        const int16_t nearest = static_cast<int16_t>(rounded<F>(turns));
        const uint16_t quarters = static_cast<uint16_t>(below_zero ? -nearest : nearest);
        const uint32_t positive = magnitude(a);
        // |a| 2^(31 - F) modulo 2^32, in two parts: the compiler shifts by whole bytes and by a bit
        // faster.
        const uint32_t angle =
            (positive >> 1) << (32 - F) | ((positive & 1) != 0 ? uint32_t(1) << (31 - F) : 0);
        // quarters half_pi_low / 2^16. The compiler multiplies 64 bits by 64, in a call.
        const uint32_t low =
            uint32_t(quarters) * half_pi_third + (uint32_t(quarters) * half_pi_fourth >> 16);
        const int32_t rest =
            static_cast<int32_t>(angle - quarters * half_pi_high - (low >> 16) - 1);
        const bool odd = (quarters & 1) != 0;
        if (odd && rest < Pole<F>::reach && rest >= -Pole<F>::reach) {
            const int64_t fine = int64_t(rest) * (int64_t(1) << 32) +
                                 static_cast<int64_t>((uint64_t(1) << 32) - quarters * half_pi_low);
            const int64_t distance = fine < 0 ? -fine : fine;
            const int32_t series =
                multiply<int32_t, 32>(rest < 0 ? -rest : rest, Pole<F>::series(rest));
            const int64_t cotangent =
                divide<int64_t, 32>(int64_t(1) << 62, distance >> 1) - 2 * int64_t(series);
            return portable::evaluation<Raw>(static_cast<uint64_t>(cotangent), 32 - F,
                                             (fine < 0) == below_zero);
        }
        int32_t unit[2] = {};
        sincos<int32_t, 30>(rounded<1>(rest), unit);
        const int32_t tangent = odd ? -divide<int32_t, fraction>(unit[1], unit[0])
                                    : divide<int32_t, fraction>(unit[0], unit[1]);
        return {rounded<fraction - F>(below_zero ? -tangent : tangent), Outcome::in_range};
    }
};

// x^y = e^(y ln x). The logarithm is as accurate as the largest y requires: in units of 2^-56 and,
// near 1, with a relative error below 2^-45. A factor from the table brings x to 1 + s,
// |s| < 0.016, whose logarithm is s - s^2 (1/2 - s/3 + s^2/4 - s^3/5 + s^4/6).
template <int F>
FIXEDPOINT_CONSTEXPR int64_t logarithm_56(uint32_t x) {
    using portable::LogarithmOfFactor;
    int8_t exponent = 31 - F;
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
        const int64_t product = multiply<int64_t, 32>(logarithm_56<F>(x), y);
        return rounded_power(exp_wide<int64_t, 40>(product >> (F - 16), F), negative);
    }
};
struct Pow : Splits<16, 24>, portable::SignedPower<PowerOfMagnitude> {};

}  // namespace composed

// The functions of Q32.32 that do not need more digits than these compositions have.
namespace q32_32 {
using composed::Acos;
using composed::Asin;
using composed::Log1p;
}  // namespace q32_32

// Composition if it serves the format, otherwise that of Q32.32 or of fine formats, otherwise
// Portable.
template <class Composition, class OfQ32_32, class OfFine, class Portable>
struct Composed {
    template <class Raw, int F, class... Operands>
    static FIXEDPOINT_IN_PLACE Evaluation<Raw> apply(Operands... a) {
        using OfFineOrCoarse = typename Choice<OfFine, Portable, fine::serves<Raw, F>()>::Type;
        using Of64Bits =
            typename Choice<OfQ32_32, OfFineOrCoarse, (sizeof(Raw) == 8 && F == 32)>::Type;
        using Chosen =
            typename Choice<Composition, Of64Bits, Composition::template serves<Raw, F>()>::Type;
        return Chosen::template apply<Raw, F>(a...);
    }
};

#define FIXEDPOINT_COMPOSED(name, Function) \
    using Function =                        \
        Composed<composed::Function, q32_32::Function, fine::Function, portable::Function>;
FIXEDPOINT_ELEMENTARY_FUNCTIONS(FIXEDPOINT_COMPOSED)
#undef FIXEDPOINT_COMPOSED

}  // namespace kernel
}  // namespace fixedpoint
