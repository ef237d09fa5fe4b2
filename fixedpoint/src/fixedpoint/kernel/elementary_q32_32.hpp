// SPDX-License-Identifier: MIT
// The elementary functions of Q32.32 as compositions of its kernels, of which some have entries
// that return digits behind an ulp. All are faithful (error below 0.75 ulp).
#pragma once

#include <fixedpoint/kernel/dispatch.hpp>
#include <fixedpoint/portable/elementary.hpp>

namespace fixedpoint {
namespace kernel {
namespace q32_32 {

using portable::Evaluation;
using portable::multiply_words;
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

// The kernel's power has no sign yet and 64 bits, of which the format holds 63.
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
// (1 - e^-2|a|) / (1 + e^-2|a|), of the sign of a.
struct Tanh {
    template <class Raw, int F>
    static FIXEDPOINT_IN_PLACE Evaluation<int64_t> apply(int64_t a) {
        constexpr uint64_t limit_of_power = uint64_t(23) << 31, limit_below_one = 50609756021;
        constexpr int64_t fine_one = int64_t(1) << 40;
        const uint64_t positive = magnitude(a);
        int64_t tangent = positive < limit_below_one ? one - 1 : one;
        if (positive <= limit_of_power) {
            const int64_t power = exp_fine<int64_t, 32>(-2 * static_cast<int64_t>(positive));
            tangent = divide<int64_t, 32>(fine_one - power, fine_one + power);
        }
        return {a < 0 ? -tangent : tangent, Outcome::in_range};
    }
};

// Logarithms. That to the base b, with 1 / ln b in units of 2^-41 and what rounds units of 2^-48 to
// ulps, less what log_fine has more.
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

// With x the distance from the nearest whole number of quarter turns and z = x^2, the cotangent of
// x is 1/x - x p and its tangent x / (1 - z p), p = 1/3 + z/45 + 2 z^2/945 + ... Large angles and
// those beside a pole ask for more digits of x.
struct Tan {
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR Evaluation<int64_t> apply(int64_t a) {
        const uint64_t positive = magnitude(a);
        if (positive >= uint64_t(1) << 40) return portable::Tan::apply<int64_t, 32>(a);
        constexpr int32_t two_over_pi = 41722;  // 2^-16
        constexpr uint32_t half_pi[3] = {0xc90fdaa2, 0x2168c234,
                                         0xc4c6628b};  // 2^-31, 2^-63, 2^-95
        const uint32_t quarters =
            static_cast<uint32_t>(
                multiply<int32_t, 16>(static_cast<int32_t>(positive >> 16), two_over_pi) +
                (int32_t(1) << 15)) >>
            16;
        const uint64_t rest = (positive << 31) - (uint64_t(quarters * half_pi[0]) << 32) -
                              multiply_words(quarters, half_pi[1]) -
                              (multiply_words(quarters, half_pi[2]) >> 32);  // 2^-63
        const bool below = static_cast<int64_t>(rest) < 0, odd = (quarters & 1) != 0;
        const int64_t x = static_cast<int64_t>(below ? 0 - rest : rest);
        if (odd && x < int64_t(1) << 52) return portable::Tan::apply<int64_t, 32>(a);

        const int64_t x_40 = x >> 23, z = multiply<int64_t, 32>(x_40, x_40);  // 2^-40, 2^-48
        const int64_t p =
            (int64_t(1) << 40) / 3 + int64_t(tail(static_cast<int32_t>(z >> 17))) * 16;
        const bool negative = (a < 0) != (below != odd);
        int64_t tangent = 0;
        if (odd) {
            const int64_t reciprocal =
                divide<int64_t, 32>(int64_t(1) << 62, (x + 16) >> 5);   // 2^-36
            const int64_t correction = multiply<int64_t, 32>(x_40, p);  // 2^-48
            tangent = (reciprocal * 4096 - correction + (int64_t(1) << 15)) >> 16;
        } else {
            const int64_t cosine = (int64_t(1) << 56) - multiply<int64_t, 32>(z, p);  // 2^-56
            tangent = divide<int64_t, 32>(x >> 7, cosine);
        }
        return {negative ? -tangent : tangent, Outcome::in_range};
    }

  private:
    // p - 1/3 in units of 2^-36, of z in units of 2^-31 up to 0.63, within 2 units.
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
