// SPDX-License-Identifier: MIT
// The elementary functions of Q32.32 as compositions of its kernels, of which some have entries that
// return digits behind an ulp. All are faithful (error below 0.75 ulp).
#pragma once

#include <fixedpoint/kernel/dispatch.hpp>
#include <fixedpoint/portable/elementary.hpp>

namespace fixedpoint {
namespace kernel {
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

}  // namespace q32_32
}  // namespace kernel
}  // namespace fixedpoint
