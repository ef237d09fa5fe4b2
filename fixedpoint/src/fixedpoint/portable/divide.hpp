// SPDX-License-Identifier: MIT
// divide: floor(a 2^F / b + 1/2), the quotient rounded to nearest, ties upward, clamped to what fits.
// b = 0: the largest number where a > 0, the smallest where a < 0, 0 where a = 0.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/wide.hpp>

namespace fixedpoint {
namespace portable {

// |a| 2^F / |b|: the integer part, clamped to 2^(W-1), and whether twice the rest is at least (more
// than) |b|, as the rounding needs it.
template <class Raw, int F>
struct MagnitudeQuotient {
    static constexpr Unsigned<Raw> rounded(Unsigned<Raw> a, Unsigned<Raw> b, bool tie_upward) {
        using Dividend = Unsigned<Wide<Raw>>;
        const Dividend dividend = static_cast<Dividend>(a) << F;
        const Dividend quotient = dividend / b;
        if (quotient >> (width_of<Raw> - 1) != 0) return Unsigned<Raw>(raw_max<Raw>) + 1u;
        const Unsigned<Raw> rest = static_cast<Unsigned<Raw>>(dividend - quotient * b);
        const Unsigned<Raw> other = static_cast<Unsigned<Raw>>(b - rest);
        return static_cast<Unsigned<Raw>>(quotient + (tie_upward ? rest >= other : rest > other));
    }
};

template <int F>
struct MagnitudeQuotient<int64_t, F> {
    static constexpr uint64_t rounded(uint64_t a, uint64_t b, bool tie_upward) {
        const uint64_t high = F == 0 ? 0 : a >> (63 - (F - 1));
        // The integer part takes at least 64 bits.
        if (high >= b) return uint64_t(1) << 63;
        const Division128 division = divide_full(high, a << F, b);
        if (division.quotient >> 63 != 0) return uint64_t(1) << 63;
        const uint64_t rest = division.remainder, other = b - rest;
        return division.quotient + (tie_upward ? rest >= other : rest > other);
    }
};

template <class Raw, int F>
constexpr Raw divide(Raw a, Raw b) {
    if (b == 0) return a > 0 ? raw_max<Raw> : a < 0 ? raw_min<Raw> : Raw(0);
    const bool negative = (a < 0) != (b < 0);
    return clamped_with_sign<Raw>(
        MagnitudeQuotient<Raw, F>::rounded(magnitude(a), magnitude(b), !negative), negative);
}

}  // namespace portable
}  // namespace fixedpoint
